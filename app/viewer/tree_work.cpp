#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "app/viewer/work.h"
#include "core/base/memory.h"
#include "core/base/timer.h"
#include "core/bsp/cut.h"
#include "core/render/scene_tree.h"

namespace bspview {
namespace {

// For what is kept of inner nodes, besides the tree. The builders that costs stop early keep 100 to
// 700 bytes an object of the standard scenes; of more objects nothing is kept.
constexpr std::size_t inner_bytes = std::size_t{1} << 30;
constexpr std::size_t most_objects = inner_bytes / 1024;

// Fewer objects are built by `sah` within about a frame (33 ms, two cores).
constexpr std::size_t fewest_sketched = std::size_t{1} << 15;

// Of the time for a sketch and the tree: `sah-binned` takes about two thirds of that of `sah`.
constexpr double sketch_share = 0.4;

/// Whether `sah-binned` is worth the while before `sah`. Clipping polygons takes both most of their
/// time, and equally long.
bool is_worth_a_sketch(const TreeRequest& request) {
  const ObjectCounts& counts = request.scene->counts;
  return request.params.builder == Builder::sah && counts.objects >= fewest_sketched &&
         counts.polygons <= counts.objects / 2;
}

bool is_family(const TreeRequest& a, const TreeRequest& b) {
  return a.scene == b.scene && same_planes(a.params, b.params);
}

bool same_scene_and_builder(const TreeRequest& a, const TreeRequest& b) {
  return a.scene == b.scene && a.params.builder == b.params.builder;
}

/// The tree that others with the same planes are parts of: all where nodes cost as much or more,
/// and with `cheaper_nodes` down to a quarter. Free nodes would take several times as long.
TreeRequest without_limits(TreeRequest request, bool cheaper_nodes) {
  request.params.max_depth = depth_cap;
  request.params.leaf_size = 1;
  if (cheaper_nodes) request.params.cost_traversal *= 0.25f;
  return request;
}

/// False as soon as another tree is wanted; true when none is for a while, in which the boxes of
/// this one, and most pictures, are made undisturbed.
bool nobody_goes_on(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds rest(60);
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  never.wait_for(lock, stop, rest, [] { return false; });
  return !stop.stop_requested();
}

}  // namespace

class TreeWork::Grower {
 public:
  /// The tree, and where it is from.
  struct Grown {
    std::shared_ptr<const Tree> tree;
    BuiltTree::Origin origin = BuiltTree::Origin::build;
  };

  /// Publishes a sketch before it where that is sooner there.
  Result<Grown> grow(const TreeRequest& request, std::stop_token stop,
                     const Publish<BuiltTree>& publish) {
    const std::optional<TreeRequest> before = std::exchange(last_, request);
    const bool is_new = !before || !is_family(*before, request);
    const bool costs_move = !is_new && cost_ratio(before->params) != cost_ratio(request.params);
    if (is_new) {
      whole_ = {};
      largest_fits_ = cheaper_nodes_fit_ = request.scene->counts.objects <= most_objects;
    }
    if (std::optional<Grown> part = cut_from_whole(request, stop)) return *std::move(part);
    is_untidy_ = true;
    const bool is_turned_at =
        is_new ? before && same_scene_and_builder(*before, request) : costs_move && !largest_fits_;
    if (is_turned_at && is_worth_a_sketch(request)) sketch(request, stop, publish);
    return is_new ? grow_first(request, stop) : grow_next(request, costs_move, stop);
  }

  /// Builds free many times what they leave. Call it when nobody waits.
  void tidy() {
    if (std::exchange(is_untidy_, false)) give_memory_back();
  }

  double progress() const { return done_; }

  /// Nothing is under way any more.
  void rest() {
    done_ = 0.0;
    set_under_way(std::nullopt);
  }

  bool serves(const TreeRequest& wish) const {
    const std::lock_guard lock(mutex_);
    return under_way_ && under_way_->scene == wish.scene &&
           is_part(wish.params, under_way_->params, wish.scene->counts.objects);
  }

 private:
  /// About the tree that is asked for.
  void sketch(TreeRequest about, const std::stop_token& stop, const Publish<BuiltTree>& publish) {
    about.params.builder = Builder::sah_binned;
    Result<Tree> tree =
        build_scene_tree(about.scene->scene, about.params, watch_build(stop, sketch_share));
    if (!tree) return;
    const auto built = std::make_shared<const BuiltTree>(
        about, std::make_shared<const Tree>(*std::move(tree)), BuiltTree::Origin::sketch, stop);
    if (!stop.stop_requested()) publish(built);
  }

  std::optional<Grown> cut_from_whole(const TreeRequest& request, const std::stop_token& stop) {
    if (!whole_.tree) return {};
    if (whole_.inner) set_under_way(TreeRequest{request.scene, whole_.tree->params});
    if (request.params == whole_.tree->params) return Grown{whole_.tree};
    std::optional<Tree> tree = cut(whole_, request.params, stop);
    if (!tree) return {};
    return Grown{std::make_shared<const Tree>(*std::move(tree)), BuiltTree::Origin::cut};
  }

  /// The first tree of its scene or builder, which nothing should delay.
  Result<Grown> grow_first(const TreeRequest& request, std::stop_token stop) {
    if (largest_fits_ && has_costs(request.params.builder)) {
      return grow_as_asked(request, stop);
    }
    Result<Tree> tree = build_scene_tree(request.scene->scene, request.params,
                                         watch_build(std::move(stop), 1.0 - done_));
    if (!tree) return tree.error();
    return Grown{std::make_shared<const Tree>(*std::move(tree))};
  }

  /// Someone moves a limit out of those of the last tree, and will go on: the largest tree of a
  /// builder that costs stop takes hardly longer than this one.
  Result<Grown> grow_next(const TreeRequest& request, bool costs_move, std::stop_token stop) {
    if (largest_fits_ && has_costs(request.params.builder)) {
      constexpr InnerLimit whole_or_nothing{inner_bytes, InnerLimit::WhenPassed::do_not_build};
      const bool cheaper_nodes = costs_move && cheaper_nodes_fit_;
      const auto grown = grow_whole(without_limits(request, cheaper_nodes), whole_or_nothing, stop);
      if (stop.stop_requested()) return Error{"stopped"};
      if (std::optional<Grown> part = cut_from_whole(request, stop)) return *std::move(part);
      (cheaper_nodes ? cheaper_nodes_fit_ : largest_fits_) = false;
    }
    return grow_as_asked(request, stop);
  }

  Result<Grown> grow_as_asked(const TreeRequest& request, std::stop_token stop) {
    if (const auto grown = grow_whole(request, {inner_bytes}, stop); !grown) return grown.error();
    return Grown{whole_.tree};
  }

  /// Makes `whole_` the tree that is asked for.
  Result<void> grow_whole(const TreeRequest& request, InnerLimit limit, std::stop_token stop) {
    set_under_way(request);
    const Timer timer;
    const SceneBuildInput objects(request.scene->scene, default_test_costs, stop);
    Result<MaximalTree> whole = build_maximal_tree(objects.input(), request.params, limit,
                                                   watch_build(std::move(stop), 1.0 - done_));
    if (!whole) return whole.error();
    whole_ = *std::move(whole);
    if (!whole_.inner) set_under_way(std::nullopt);
    whole_.tree->build_seconds = timer.seconds();
    return {};
  }

  /// Of a build that is `share` of the work.
  Watch watch_build(std::stop_token stop, double share) {
    Watch watch(std::move(stop));
    watch.progress = [this, share](double more) {
      done_.fetch_add(more * share, std::memory_order_relaxed);
    };
    return watch;
  }

  void set_under_way(std::optional<TreeRequest> request) {
    const std::lock_guard lock(mutex_);
    under_way_ = std::move(request);
  }

  std::optional<TreeRequest> last_;
  MaximalTree whole_;          // of the same scene and planes; its tree is null before there is one
  bool largest_fits_ = false;  // without limits
  bool cheaper_nodes_fit_ = false;  // and with cheaper nodes
  bool is_untidy_ = false;
  std::atomic<double> done_ = 0.0;  // of the work under way

  mutable std::mutex mutex_;
  std::optional<TreeRequest> under_way_;  // guarded; others are or will be cut from it
};

/// Ends work however it ends.
class TreeWork::Rest {
 public:
  explicit Rest(Grower& grower) : grower_(grower) {}
  ~Rest() { grower_.rest(); }
  Rest(const Rest&) = delete;
  Rest& operator=(const Rest&) = delete;

 private:
  Grower& grower_;
};

TreeWork::TreeWork() : grower_(std::make_shared<Grower>()) {}

Result<void> TreeWork::operator()(const TreeRequest& request, std::stop_token stop,
                                  const Publish<BuiltTree>& publish) {
  const Rest afterwards(*grower_);
  Result<Grower::Grown> grown = grower_->grow(request, stop, publish);
  if (!grown) return grown.error();
  const auto built =
      std::make_shared<const BuiltTree>(request, std::move(grown->tree), grown->origin, stop);
  if (stop.stop_requested()) return Error{"stopped"};
  publish(built);
  if (nobody_goes_on(stop)) grower_->tidy();
  return {};
}

bool TreeWork::serves(const TreeRequest& wish) const {
  return grower_->serves(wish);
}

double TreeWork::progress() const {
  return grower_->progress();
}

}  // namespace bspview
