#include <fmt/format.h>

#include <memory>

#include "core/eval/bench/peer.h"
#include "core/eval/kernels.h"
#include "core/render/accelerator.h"
#include "core/render/hits.h"

namespace bspview {
namespace {

class KernelTracer : public Tracer {
 public:
  KernelTracer(const Kernel::Closest& closest, const Kernel::Occluded& occluded)
      : closest_(closest), occluded_(occluded) {}

  void load(BenchKind kind, std::span<const Ray> rays) override {
    kind_ = kind;
    rays_.assign(rays.begin(), rays.end());
    results_.resize(rays.size());
    found_.resize(rays.size());
  }
  void trace() override {
    if (kind_ == BenchKind::shadow) {
      occluded_(rays_, found_);
    } else {
      closest_(rays_, results_);
    }
  }
  void read(std::span<RayResult> results) const override {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const RayResult found{found_[i] != 0 ? 0 : no_index, 0.0};
      results[i] = kind_ == BenchKind::shadow ? found : results_[i];
    }
  }

 private:
  const Kernel::Closest closest_;
  const Kernel::Occluded occluded_;
  BenchKind kind_ = BenchKind::primary;
  std::vector<Ray> rays_;
  std::vector<RayResult> results_;
  std::vector<char> found_;
};

/// The accelerator, with the rays and the answers as it takes and gives them.
class FastTracer : public Tracer {
 public:
  explicit FastTracer(std::shared_ptr<const FastWorld> world) : world_(std::move(world)) {}

  void load(BenchKind kind, std::span<const Ray> rays) final {
    is_shadow_ = kind == BenchKind::shadow;
    rays_.assign(rays.begin(), rays.end());
    hits_.resize(rays.size());
    blockers_.resize(rays.size());
  }
  void trace() final {
    if (is_shadow_) {
      occluded();
    } else {
      closest();
    }
  }
  void read(std::span<RayResult> results) const final {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const RayResult found{blockers_[i] != no_index ? 0 : no_index, 0.0};
      results[i] = is_shadow_ ? found : RayResult{hits_[i].object, hits_[i].t};
    }
  }

 protected:
  static constexpr SideRule sides = SideRule::two_sided;

  virtual void closest() = 0;
  virtual void occluded() = 0;
  const World& world() const { return world_->world(); }

  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
  std::vector<std::uint32_t> blockers_;  // of shadow rays

 private:
  std::shared_ptr<const FastWorld> world_;
  bool is_shadow_ = false;
};

class OneByOneTracer final : public FastTracer {
 public:
  using FastTracer::FastTracer;

 private:
  void closest() override {
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      hits_[i] = fast_closest_hit(world(), rays_[i], sides);
    }
  }
  void occluded() override {
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      blockers_[i] = fast_any_hit(world(), rays_[i], sides);
    }
  }
};

class PacketTracer final : public FastTracer {
 public:
  using FastTracer::FastTracer;

 private:
  void closest() override { closest_hits(world(), rays_, sides, hits_); }
  void occluded() override { any_hits(world(), rays_, sides, blockers_); }
};

template <class Kind>
Peer fast(std::string name, std::string what, Peer::Width width) {
  Peer peer;
  peer.name = std::move(name);
  peer.what = std::move(what);
  peer.width = width;
  peer.enter = [](const World& world) -> MakeTracer {
    const auto fast_world = std::make_shared<const FastWorld>(world);
    return [fast_world] { return std::make_unique<Kind>(fast_world); };
  };
  return peer;
}

Peer scalar(std::string name, std::string what, const KernelChoice& choice) {
  Kernel kernel = make_kernel(choice);
  kernel.name = std::move(name);
  kernel.what = std::move(what);
  const bool is_default = choice == KernelChoice{};
  return peer_of(std::move(kernel), is_default ? Peer::Answers::robust : Peer::Answers::fast,
                 Peer::Width::one);
}

KernelChoice in_float(Traversal traversal) {
  return {FaceTest::moeller_float, QuadricTest::textbook_float, traversal, OffsetRule::fixed};
}

}  // namespace

Peer peer_of(Kernel kernel, Peer::Answers answers, Peer::Width width) {
  Peer peer;
  peer.name = kernel.name;
  peer.what = kernel.what;
  peer.answers = answers;
  peer.width = width;
  peer.enter = [kernel = std::move(kernel)](const World& world) -> MakeTracer {
    return [closest = kernel.closest(world), occluded = kernel.occluded(world)] {
      return std::make_unique<KernelTracer>(closest, occluded);
    };
  };
  return peer;
}

std::vector<Peer> own_peers() {
  Peer naive = scalar("naive", "the default's tests on every object", {});
  naive.build = BuildParams{.builder = Builder::naive};
  return {
      fast<OneByOneTracer>(
          "bspview",
          fmt::format("the default: exact, wide tree, one ray ({})", packet_instructions()),
          Peer::Width::one),
      fast<PacketTracer>("bspview packets",
                         fmt::format("the same, {} rays at a time", packet_width()),
                         Peer::Width::many),
      scalar("bspview binary", "the same answers by the binary tree that Delta counts", {}),
      scalar("bspview float", "Moeller-Trumbore in float, robust traversal",
             in_float(Traversal::robust)),
      scalar("bspview float havran", "Moeller-Trumbore in float, Havran's traversal TA-B",
             in_float(Traversal::havran)),
      std::move(naive),
  };
}

}  // namespace bspview
