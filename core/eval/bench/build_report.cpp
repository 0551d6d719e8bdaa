#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/eval/bench/build_quality.h"
#include "core/eval/machine_json.h"

namespace bspview {
namespace {

using Json = nlohmann::ordered_json;

double microseconds_an_object(const BuiltScene& scene, const BuildTimes& times) {
  return 1e6 * summarise(times.seconds).median / static_cast<double>(scene.objects);
}

double bytes_an_object(const BuiltScene& scene, const BuildTimes& times) {
  return static_cast<double>(times.bytes) / static_cast<double>(scene.objects);
}

std::string row(const BuildReport& report, const BuiltScene& scene, std::size_t peer) {
  std::string text = fmt::format("  {:>9} {:<14}", scene.objects, report.peers[peer].name);
  for (const int threads : report.threads) {
    const BuildTimes* const times = find_times(scene, peer, threads);
    text += fmt::format(" {:>10.5f}", summarise(times->seconds).median);
  }
  const BuildTimes& times = *find_times(scene, peer, 1);
  const Measured seconds = summarise(times.seconds);
  text += fmt::format(" {:>3.0f} {:>3} {:>8.3f} {:>8.1f} {:>5.0f}",
                      100.0 * seconds.spread / seconds.median, seconds.repeats,
                      microseconds_an_object(scene, times), 1e-6 * static_cast<double>(times.bytes),
                      bytes_an_object(scene, times));
  if (!times.shape) return text + "\n";
  return text + fmt::format(" {:>5} {:>8.2f}{}\n", times.shape->deepest_leaf,
                            times.shape->expected_cost,
                            times.shape->memory_limit_reached ? "  memory limit reached" : "");
}

/// "1 thread", "2 threads" ... in columns of `width`.
std::string thread_titles(const BuildReport& report, int width) {
  std::string text;
  for (const int threads : report.threads) {
    const std::string title = fmt::format("{} thread{}", threads, threads > 1 ? "s" : "");
    text += fmt::format(" {:>{}}", title, width);
  }
  return text;
}

std::string family_table(const BuildReport& report, const BuildFamily& family) {
  std::string text = fmt::format(
      "\n{}, seconds\n    objects builder       {} +-%  of   us/obj       MB B/obj depth     "
      "cost\n",
      family.name, thread_titles(report, 10));
  for (const BuiltScene& scene : family.sizes) {
    for (std::size_t peer = 0; peer < report.peers.size(); ++peer) text += row(report, scene, peer);
  }
  return text;
}

/// Calls visit(family, peer, threads, fit) for every fit that there is.
template <class Visit>
void for_each_fit(const BuildReport& report, const Visit& visit) {
  for (const BuildFamily& family : report.families) {
    for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
      for (const int threads : report.threads) {
        if (const auto fit = fit_of(family, peer, threads)) visit(family, peer, threads, *fit);
      }
    }
  }
}

std::string fit_table(const BuildReport& report) {
  std::string text;
  for_each_fit(report, [&](const BuildFamily& family, std::size_t peer, int threads, PowerFit fit) {
    if (threads == 1) text += fmt::format("  {:<9} {:<14}", family.name, report.peers[peer].name);
    text += fmt::format(" {:>7.3f} {:>6.4f}", fit.exponent, fit.r2);
    if (threads == report.threads.back()) text += "\n";
  });
  if (text.empty()) return "\nToo few sizes for a slope: three are needed.\n";
  return fmt::format("\nseconds ~ (N log N)^exponent, and R^2\n{:26}{}\n", "",
                     thread_titles(report, 14)) +
         text;
}

/// The least and the largest of some values.
struct Range {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

/// What one peer takes for the largest scenes, on one thread and on all.
std::string verdict(const BuildReport& report, std::size_t peer) {
  Range time, gain, exponent;
  for (const BuildFamily& family : report.families) {
    if (family.sizes.empty()) continue;
    const BuiltScene& largest = family.sizes.back();
    const BuildTimes* const one = find_times(largest, peer, 1);
    const BuildTimes* const all = find_times(largest, peer, report.threads.back());
    if (!one || !all) continue;
    time.add(microseconds_an_object(largest, *one));
    gain.add(summarise(one->seconds).median / summarise(all->seconds).median);
  }
  for_each_fit(report, [&](const BuildFamily&, std::size_t i, int threads, PowerFit fit) {
    if (i == peer && threads == 1) exponent.add(fit.exponent);
  });
  std::string text = fmt::format(
      "{}: {:.2f} to {:.2f} us an object of the largest scenes on one thread, {:.2f} to {:.2f} "
      "times as fast on {}",
      report.peers[peer].name, time.least, time.most, gain.least, gain.most, report.threads.back());
  if (exponent.most > 0.0) {
    text += fmt::format("; exponent {:.2f} to {:.2f}", exponent.least, exponent.most);
  }
  return text + ".";
}

Json times_json(const BuildReport& report, const BuiltScene& scene, const BuildTimes& times) {
  const Measured seconds = summarise(times.seconds);
  Json json{{"builder", report.peers[times.peer].name},
            {"threads", times.threads},
            {"seconds", seconds.median},
            {"seconds_spread", seconds.spread},
            {"seconds_by_repeat", times.seconds},
            {"us_per_object", microseconds_an_object(scene, times)},
            {"bytes", times.bytes}};
  if (!times.shape) return json;
  json["deepest_leaf"] = times.shape->deepest_leaf;
  json["expected_cost"] = times.shape->expected_cost;
  json["memory_limit_reached"] = times.shape->memory_limit_reached;
  return json;
}

Json family_json(const BuildReport& report, const BuildFamily& family) {
  Json json{{"name", family.name}, {"sizes", Json::array()}, {"fits", Json::array()}};
  for (const BuiltScene& scene : family.sizes) {
    Json size{{"scene", scene.name}, {"objects", scene.objects}, {"builds", Json::array()}};
    for (const BuildTimes& times : scene.times) {
      size["builds"].push_back(times_json(report, scene, times));
    }
    json["sizes"].push_back(std::move(size));
  }
  for_each_fit(report, [&](const BuildFamily& of, std::size_t peer, int threads, PowerFit fit) {
    if (&of != &family) return;
    json["fits"].push_back({{"builder", report.peers[peer].name},
                            {"threads", threads},
                            {"exponent", fit.exponent},
                            {"r2", fit.r2}});
  });
  return json;
}

}  // namespace

std::string to_text(const BuildReport& report) {
  std::string text = fmt::format(
      "seconds: median of up to {} interleaved repeats (column of); +-%: half the distance of the "
      "quartiles\nthat, us, bytes, depth and expected cost on one thread\n",
      report.params.repeats);
  for (const BuildPeer& peer : report.peers) text += fmt::format("{}: {}\n", peer.name, peer.what);
  if (!report.peers.back().foreign) {
    text += "Embree was not there when this was built: install libembree-dev and build again.\n";
  }
  for (const BuildFamily& family : report.families) {
    if (!family.sizes.empty()) text += family_table(report, family);
  }
  text += fit_table(report) + quality_table(report) + "\n";
  for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
    text += verdict(report, peer) + "\n";
  }
  return text;
}

std::string to_json(const BuildReport& report) {
  Json json{{"verdict", Json::array()},
            {"parameters",
             {{"sizes", report.params.sizes},
              {"repeats", report.params.repeats},
              {"max_depth",
               report.params.build.max_depth ? Json(*report.params.build.max_depth) : Json("auto")},
              {"leaf_size", report.params.build.leaf_size},
              {"memory_limit", report.params.build.memory_limit}}}};
  for (std::size_t peer = 0; peer < report.peers.size(); ++peer) {
    json["verdict"].push_back(verdict(report, peer));
    json["builders"].push_back(
        {{"name", report.peers[peer].name}, {"what", report.peers[peer].what}});
  }
  for (const BuildFamily& family : report.families) {
    json["families"].push_back(family_json(report, family));
  }
  json["quality"] = quality_json(report);
  json["machine"] = machine_json(report.machine);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_csv(const BuildReport& report) {
  std::string csv =
      "scene,objects,builder,threads,repeats,seconds,seconds_spread,us_per_object,bytes,"
      "deepest_leaf,expected_cost,memory_limit_reached\n";
  for (const BuildFamily& family : report.families) {
    for (const BuiltScene& scene : family.sizes) {
      for (const BuildTimes& times : scene.times) {
        const Measured seconds = summarise(times.seconds);
        csv += fmt::format("{},{},\"{}\",{},{},{:.6f},{:.6f},{:.4f},{}", scene.name, scene.objects,
                           report.peers[times.peer].name, times.threads, seconds.repeats,
                           seconds.median, seconds.spread, microseconds_an_object(scene, times),
                           times.bytes);
        csv += times.shape
                   ? fmt::format(",{},{:.4f},{:d}\n", times.shape->deepest_leaf,
                                 times.shape->expected_cost, times.shape->memory_limit_reached)
                   : ",,,\n";
      }
    }
  }
  return csv;
}

}  // namespace bspview
