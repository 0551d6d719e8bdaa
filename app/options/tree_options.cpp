#include "app/options/tree_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <span>

#include "app/options/values.h"

namespace bspview {
namespace {

constexpr const char* group = "Tree";

/// Accepts one of `names`, whose positions are the values of the enumeration T.
template <class T>
CLI::Option* add_names(CLI::App& app, const std::string& name,
                       std::span<const std::string_view> names, T& value) {
  const auto set = [name, names, &value](const std::string& text) {
    const auto found = std::ranges::find(names, text);
    if (found == names.end()) {
      throw CLI::ValidationError(name,
                                 fmt::format("'{}' is none of {}", text, fmt::join(names, ", ")));
    }
    value = static_cast<T>(found - names.begin());
  };
  return app.add_option_function<std::string>(name, set)
      ->type_name(fmt::format("{}", fmt::join(names, "|")))
      ->default_str(std::string(name_of(value)));
}

void add_split_options(CLI::App& app, BuildParams& build) {
  add_names(app, "--builder", builder_names(), build.builder)
      ->description("How split planes are chosen")
      ->group(group);
  add_switch(app, "--clip", build.clip)
      ->description("Clip objects to the node (\"perfect splits\"); default on, off for median")
      ->group(group);
  app.add_option("--cost-traversal", build.cost_traversal, "SAH cost of a visited node")
      ->check(finite_number(0.0, 1e6))
      ->capture_default_str()
      ->group(group);
  app.add_option(
         "--cost-intersection", build.cost_intersection,
         "SAH cost of an object test; default: as measured for the scene's kinds of objects")
      ->check(finite_number(1e-6, 1e6))
      ->group(group);
  app.add_option("--empty-bonus", build.empty_bonus,
                 "Share of the expected tests that cutting off empty space is spared")
      ->check(finite_number(0.0, 1.0))
      ->capture_default_str()
      ->group(group);
}

/// A depth beyond int is as good as the largest int: every depth is clamped to depth_cap.
void set_max_depth(const std::string& text, std::optional<int>& depth) {
  depth.reset();
  if (text == "auto") return;
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc::invalid_argument || stop != end) {
    throw CLI::ValidationError("--max-depth",
                               fmt::format("'{}' is neither a depth nor auto", text));
  }
  constexpr std::uint64_t largest = std::numeric_limits<int>::max();
  depth = static_cast<int>(error == std::errc() ? std::min(number, largest) : largest);
}

void set_memory_limit(const std::string& text, std::size_t& limit) {
  const std::optional<std::size_t> bytes = parse_byte_size(text);
  if (!bytes) {
    throw CLI::ValidationError("--memory-limit",
                               fmt::format("'{}' is no size; write 512M or 2G", text));
  }
  limit = *bytes;
}

void add_size_options(CLI::App& app, BuildParams& build) {
  app.add_option_function<std::string>(
         "--max-depth", [&build](const std::string& text) { set_max_depth(text, build.max_depth); },
         fmt::format("Depth of the deepest leaves, at most {}", depth_cap))
      ->type_name("N|auto")
      ->default_str("auto")
      ->group(group);
  app.add_option("--leaf-size", build.leaf_size, "Leaf when a node holds at most N objects")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()).description(""))
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
  app.add_option_function<std::string>(
         "--memory-limit",
         [&build](const std::string& text) { set_memory_limit(text, build.memory_limit); },
         "Memory for nodes and references; when it is spent, nodes become leaves")
      ->type_name("SIZE")
      ->default_str(fmt::format("{}M", build.memory_limit >> 20))
      ->group(group);
}

void add_lazy(CLI::App& app, BuildParams& build, const std::string& not_lazy) {
  const auto refuse = [not_lazy](const std::string& text) {
    return text == "on" ? not_lazy : std::string();
  };
  app.add_option_function<std::string>(
         "--lazy", [&build](const std::string& text) { build.lazy = text == "on"; },
         "Build what is below the upper nodes where and when rays come to it")
      ->check(CLI::IsMember({"on", "off"}).description(""))
      ->check(CLI::Validator(refuse, ""))
      ->type_name("on|off")
      ->default_str("off")
      ->group(group);
}

}  // namespace

CLI::Option* add_scene(CLI::App& app, std::string& scene) {
  return app.add_option("SCENE", scene, "Scene file, or spd:NAME[:SIZE] for a standard scene")
      ->type_name("");
}

void add_arithmetic_options(CLI::App& app, Arithmetic& arithmetic, OffsetRule& offset) {
  add_names(app, "--arithmetic", arithmetic_names(), arithmetic)
      ->description("How the tests of the shapes compute");
  add_names(app, "--offset", offset_rule_names(), offset)
      ->description("What keeps a ray off the surface that it leaves");
}

void check_lazy(const TreeOptions& options) {
  if (!options.build.lazy) return;
  if (options.build.builder == Builder::naive) {
    throw CLI::ValidationError("--lazy", "the builder naive splits nothing that could wait");
  }
  if (options.traversal != Traversal::robust) {
    throw CLI::ValidationError("--lazy", "a tree that grows is walked by --traversal robust only");
  }
}

void add_tree_options(CLI::App& app, TreeOptions& options, const std::string& not_lazy) {
  add_split_options(app, options.build);
  add_size_options(app, options.build);
  add_names(app, "--traversal", traversal_names(), options.traversal)
      ->description("How a ray walks the tree")
      ->group(group);
  add_lazy(app, options.build, not_lazy);
  app.add_option("--threads", options.build.threads, "Threads; 0: all cores")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("N")
      ->default_str("all cores")
      ->group(group);
  app.add_option("--seed", options.seed, "Seed of everything random")
      ->type_name("N")
      ->capture_default_str()
      ->group(group);
}

}  // namespace bspview
