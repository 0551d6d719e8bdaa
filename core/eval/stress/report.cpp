#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/machine.h"
#include "core/eval/machine_json.h"
#include "core/eval/stress/stress.h"

namespace bspview::stress {
namespace {

using Json = nlohmann::ordered_json;

std::string line_of(const Row& row) {
  const std::string place = row.scene.empty() ? "" : fmt::format(" ({})", row.scene);
  return fmt::format("{:<4} {:>9} {:>9} {:>9.2g} {:>8.2f}  {}{}\n", row.id, row.trials,
                     row.failures, row.upper_bound(), row.seconds, row.what, place);
}

/// What all rows come to.
Row sum_of(std::span<const Row> rows) {
  Row sum;
  for (const Row& row : rows) {
    sum.trials += row.trials;
    sum.failures += row.failures;
    sum.seconds += row.seconds;
  }
  return sum;
}

Json json_of(const Row& row, std::uint64_t seed) {
  Json json{{"id", row.id},
            {"group", row.group},
            {"what", row.what},
            {"scene", row.scene.empty() ? Json(nullptr) : Json(row.scene)},
            {"trials", row.trials},
            {"failures", row.failures},
            {"upper_bound", row.upper_bound()},
            {"seconds", row.seconds},
            {"first_failure", nullptr}};
  if (row.first) {
    json["first_failure"] = Json{{"trial", row.first->trial},
                                 {"sentence", row.first->sentence},
                                 {"command", command_of(row, seed)}};
  }
  return json;
}

}  // namespace

std::string command_of(const Row& row, std::uint64_t seed) {
  const std::string scene = row.scene.empty() ? "" : " " + row.scene;
  return fmt::format("bspeval stress{} --check {} --seed {} --trial {}", scene, row.id, seed,
                     row.first->trial);
}

std::string to_text(std::span<const Row> rows, std::uint64_t seed) {
  std::string text = fmt::format("{:<4} {:>9} {:>9} {:>9} {:>8}  {}\n", "id", "trials", "failures",
                                 "95 % <", "seconds", "what must hold");
  for (const Row& row : rows) text += line_of(row);
  const Row sum = sum_of(rows);
  text += fmt::format("{:<4} {:>9} {:>9} {:>9} {:>8.2f}  in all\n", "", sum.trials, sum.failures,
                      "", sum.seconds);
  for (const Row& row : rows) {
    if (!row.first) continue;
    text += fmt::format("\n{} trial {}: {}\n  {}\n", row.id, row.first->trial, row.first->sentence,
                        command_of(row, seed));
  }
  return text;
}

std::string to_json(std::span<const Row> rows, std::uint64_t seed) {
  const Row sum = sum_of(rows);
  const Machine machine = this_machine();
  Json json{{"seed", seed},
            {"trials", sum.trials},
            {"failures", sum.failures},
            {"seconds", sum.seconds},
            {"rows", Json::array()}};
  for (const Row& row : rows) json["rows"].push_back(json_of(row, seed));
  json["machine"] = machine_json(machine);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace bspview::stress
