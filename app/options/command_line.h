#pragma once

#include <CLI/CLI.hpp>
#include <optional>

namespace bspview {

inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;
inline constexpr int exit_wrong_usage = 2;

/// Parses the arguments. Returns the exit code when the program is to end here: 0 after --help or
/// --version, 2 after one sentence about wrong usage on stderr.
std::optional<int> parse_command_line(CLI::App& app, int argc, char** argv);

}  // namespace bspview
