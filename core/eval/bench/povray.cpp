#include "core/eval/bench/povray.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>

#include "core/base/file.h"
#include "core/base/run_time.h"
#include "core/eval/bench/povray_scene.h"
#include "core/eval/lambda.h"
#include "core/render/accelerator.h"
#include "core/render/render.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

/// An empty folder that goes with its owner; its path is empty when none can be made.
class Folder {
 public:
  Folder() {
    std::error_code error;
    const std::filesystem::path place = std::filesystem::temp_directory_path(error);
    std::string path = (place / "bspview-povray-XXXXXX").string();
    if (!error && ::mkdtemp(path.data()) != nullptr) path_ = path;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

class PovrayRun {
 public:
  PovrayRun(const PovrayParams& params, const Watch& watch) : params_(params), watch_(watch) {
    report_.params = params;
  }

  Result<void> add(const Scene& scene, double share) {
    if (folder_.path().empty()) return Error{"no temporary folder can be made for POV-Ray's files"};
    const Result<Tree> tree = build_scene_tree(scene, params_.build, watch_.stop);
    if (!tree) return tree.error();
    const auto written =
        write_file(folder_.path() / "scene.pov", to_povray(scene, params_.max_ray_depth));
    if (!written) return written;
    const FastWorld fast({scene, *tree});
    PictureTimes times{scene.name, scene.objects.size(), {}, {}, {}};
    for (int i = 0; i < params_.repeats; ++i) {
      if (watch_.stopped()) return Error{"stopped"};
      times.own.push_back(own_seconds(fast.world()));
      for (const auto& [all, bounding] : {std::pair(&times.boxes, 1), std::pair(&times.bsp, 2)}) {
        const Result<double> seconds = povray_seconds(bounding);
        if (!seconds) return seconds.error();
        all->push_back(*seconds);
      }
      watch_.advance(share / params_.repeats);
    }
    report_.pictures.push_back(std::move(times));
    return {};
  }

  PovrayReport take_report() { return std::move(report_); }

 private:
  double own_seconds(const World& world) const {
    RenderParams render;
    render.width = render.height = params_.side;
    render.max_ray_depth = params_.max_ray_depth;
    render.threads = 1;
    return time_run(1, [&] { (void)render_image(world, world.scene.camera, render, watch_).ok(); });
  }

  Result<double> povray_seconds(int bounding) const {
    const std::string command =
        fmt::format("cd {} && {} +Iscene.pov -F -D -A +WT1 +W{} +H{} +BM{} > messages 2>&1",
                    quoted(folder_.path().string()), quoted(params_.program), params_.side,
                    params_.side, bounding);
    if (std::system(command.c_str()) != 0) {
      return Error{params_.program + ": does not run; install povray for --povray"};
    }
    const Result<std::string> messages = read_file(folder_.path() / "messages");
    if (!messages) return messages.error();
    const auto seconds = povray_trace_seconds(*messages);
    return seconds ? Result<double>(*seconds)
                   : Error{params_.program + ": tells no time of tracing"};
  }

  const PovrayParams& params_;
  const Watch& watch_;
  Folder folder_;
  PovrayReport report_;
};

}  // namespace

Result<PovrayReport> run_povray(std::span<const Scene> scenes, const PovrayParams& params,
                                const Watch& watch) {
  PovrayRun run(params, watch);
  for (const Scene& scene : scenes) {
    const auto added = run.add(scene, 1.0 / static_cast<double>(scenes.size()));
    if (!added) return added.error();
  }
  return run.take_report();
}

std::optional<double> povray_trace_seconds(std::string_view messages) {
  // Trace Time:       0 hours  0 minutes  1 seconds (1.606 seconds)
  //             using 1 thread(s) with 0.737 CPU-seconds total
  std::size_t at = messages.find("Trace Time:");
  if (at == messages.npos) return std::nullopt;
  constexpr std::string_view before = "thread(s) with ";
  at = messages.find(before, at);
  if (at == messages.npos) return std::nullopt;
  double seconds = 0.0;
  const std::string_view number = messages.substr(at + before.size());
  const auto parsed = std::from_chars(number.data(), number.data() + number.size(), seconds);
  return parsed.ec == std::errc() && seconds > 0.0 ? std::optional(seconds) : std::nullopt;
}

double povray_ratio(const PictureTimes& times) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < times.own.size(); ++i) {
    ratios.push_back(std::min(times.boxes[i], times.bsp[i]) / times.own[i]);
  }
  return summarise(std::move(ratios)).median;
}

}  // namespace bspview
