#include "core/eval/bench/peer.h"
#include "core/eval/kernels.h"

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
      peer_of(make_fast_kernel(), Peer::Answers::robust, Peer::Width::one),
      peer_of(make_packet_kernel(), Peer::Answers::robust, Peer::Width::many),
      scalar("bspview binary", "the same answers by the binary tree that Delta counts", {}),
      scalar("bspview float", "Moeller-Trumbore in float, robust traversal",
             in_float(Traversal::robust)),
      scalar("bspview float havran", "Moeller-Trumbore in float, Havran's traversal TA-B",
             in_float(Traversal::havran)),
      std::move(naive),
  };
}

}  // namespace bspview
