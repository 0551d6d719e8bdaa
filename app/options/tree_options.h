#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "core/bsp/traversal.h"
#include "core/bsp/tree.h"
#include "core/render/arithmetic.h"

namespace bspview {

/// What every command and the viewer can be told about scene and tree.
struct TreeOptions {
  std::string scene;  ///< file or spd:NAME[:SIZE]
  BuildParams build;
  Traversal traversal = Traversal::robust;
  std::uint64_t seed = 0;  ///< of everything random
};

/// The positional SCENE; call ->required() on the result where it has to be there.
CLI::Option* add_scene(CLI::App& app, std::string& scene);

/// --arithmetic and --offset. The values outlive the parsing.
void add_arithmetic_options(CLI::App& app, Arithmetic& arithmetic, OffsetRule& offset);

/// Every tree option. `options` outlives the parsing. `not_lazy`: why --lazy on is refused; ""
/// where it is not.
void add_tree_options(CLI::App& app, TreeOptions& options, const std::string& not_lazy = "");

/// Whether --lazy on goes together with the other options; throws CLI::ValidationError.
void check_lazy(const TreeOptions& options);

}  // namespace bspview
