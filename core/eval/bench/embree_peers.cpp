#include "core/eval/bench/peer.h"

#ifdef BSPVIEW_EMBREE
#include <fmt/format.h>

#include <array>

#include "core/eval/embree_scene.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif
#endif

namespace bspview {

#ifdef BSPVIEW_EMBREE
namespace {

/// Flushes denormal numbers to zero while it lives, as Embree's manual asks of its callers.
class FlushedDenormals {
#ifdef __SSE__
 public:
  FlushedDenormals() {
    _mm_setcsr(before_ | flush_to_zero_and_denormals_are_zero);
  }
  FlushedDenormals(const FlushedDenormals&) = delete;
  FlushedDenormals& operator=(const FlushedDenormals&) = delete;
  ~FlushedDenormals() {
    _mm_setcsr(before_);
  }

 private:
  static constexpr unsigned flush_to_zero_and_denormals_are_zero = 0x8040;
  const unsigned before_ = _mm_getcsr();
#endif
};

RTCRayHit with_hit(const RTCRay& ray) {
  RTCRayHit query{};
  query.ray = ray;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return query;
}

/// What all share: the scene, and what the kind of rays asks for.
class EmbreeTracer : public Tracer {
 public:
  explicit EmbreeTracer(std::shared_ptr<const EmbreeScene> scene) : scene_(std::move(scene)) {}

  void load(BenchKind kind, std::span<const Ray> rays) final {
    is_shadow_ = kind == BenchKind::shadow;
    rtcInitIntersectContext(&context_);
    context_.flags = kind == BenchKind::scattered ? RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT
                                                  : RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    fill(rays);
  }
  void trace() final {
    const FlushedDenormals flushed;
    is_shadow_ ? occluded() : closest();
  }

 protected:
  virtual void fill(std::span<const Ray> rays) = 0;
  virtual void closest() = 0;
  virtual void occluded() = 0;

  RTCScene scene() const { return scene_->get(); }
  bool is_shadow() const { return is_shadow_; }
  RayResult result(unsigned geometry, unsigned primitive, float t) const {
    const std::uint32_t object = scene_->object(geometry, primitive);
    return object == no_index ? RayResult{} : RayResult{object, t};
  }
  /// Embree marks shadow rays that hit something by t = -inf.
  static RayResult shadow_result(float t) { return {t < 0.0f ? 0 : no_index, 0.0}; }

  RTCIntersectContext context_{};

 private:
  std::shared_ptr<const EmbreeScene> scene_;
  bool is_shadow_ = false;
};

/// Rays one after the other in memory.
class EmbreeArray : public EmbreeTracer {
 public:
  using EmbreeTracer::EmbreeTracer;

  void read(std::span<RayResult> results) const final {
    for (std::size_t i = 0; i < results.size(); ++i) {
      results[i] = is_shadow()
                       ? shadow_result(rays_[i].tfar)
                       : result(hits_[i].hit.geomID, hits_[i].hit.primID, hits_[i].ray.tfar);
    }
  }

 protected:
  void fill(std::span<const Ray> rays) final {
    rays_.clear();
    hits_.clear();
    for (const Ray& ray : rays) {
      if (is_shadow()) {
        rays_.push_back(embree_ray(ray));
      } else {
        hits_.push_back(with_hit(embree_ray(ray)));
      }
    }
  }

  std::vector<RTCRay> rays_;     // shadow rays
  std::vector<RTCRayHit> hits_;  // others
};

class EmbreeSingle final : public EmbreeArray {
 public:
  using EmbreeArray::EmbreeArray;

 private:
  void closest() override {
    for (RTCRayHit& query : hits_) rtcIntersect1(scene(), &context_, &query);
  }
  void occluded() override {
    for (RTCRay& query : rays_) rtcOccluded1(scene(), &context_, &query);
  }
};

class EmbreeStream final : public EmbreeArray {
 public:
  using EmbreeArray::EmbreeArray;

 private:
  static constexpr std::size_t stream_size = 64;
  static unsigned size_at(std::size_t first, std::size_t count) {
    return static_cast<unsigned>(std::min(stream_size, count - first));
  }

  void closest() override {
    for (std::size_t i = 0; i < hits_.size(); i += stream_size) {
      rtcIntersect1M(scene(), &context_, &hits_[i], size_at(i, hits_.size()), sizeof(RTCRayHit));
    }
  }
  void occluded() override {
    for (std::size_t i = 0; i < rays_.size(); i += stream_size) {
      rtcOccluded1M(scene(), &context_, &rays_[i], size_at(i, rays_.size()), sizeof(RTCRay));
    }
  }
};

class EmbreePacket final : public EmbreeTracer {
 public:
  using EmbreeTracer::EmbreeTracer;

  void read(std::span<RayResult> results) const override {
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::size_t k = i % width;
      if (is_shadow()) {
        results[i] = shadow_result(rays_[i / width].tfar[k]);
        continue;
      }
      const RTCRayHit8& packet = hits_[i / width];
      results[i] = result(packet.hit.geomID[k], packet.hit.primID[k], packet.ray.tfar[k]);
    }
  }

 private:
  static constexpr std::size_t width = 8;
  struct alignas(32) Lanes {
    std::array<int, width> valid{};  // -1: a ray
  };

  void fill(std::span<const Ray> rays) override {
    const std::size_t packets = (rays.size() + width - 1) / width;
    lanes_.assign(packets, {});
    rays_.assign(packets, {});
    for (std::size_t i = 0; i < rays.size(); ++i) {
      lanes_[i / width].valid[i % width] = -1;
      put(embree_ray(rays[i]), rays_[i / width], i % width);
    }
    hits_.clear();
    if (is_shadow()) return;
    for (const RTCRay8& packet : rays_) {
      RTCRayHit8& query = hits_.emplace_back();
      query.ray = packet;
      std::fill_n(query.hit.geomID, width, RTC_INVALID_GEOMETRY_ID);
    }
  }
  static void put(const RTCRay& ray, RTCRay8& packet, std::size_t k) {
    packet.org_x[k] = ray.org_x;
    packet.org_y[k] = ray.org_y;
    packet.org_z[k] = ray.org_z;
    packet.dir_x[k] = ray.dir_x;
    packet.dir_y[k] = ray.dir_y;
    packet.dir_z[k] = ray.dir_z;
    packet.tnear[k] = ray.tnear;
    packet.tfar[k] = ray.tfar;
    packet.mask[k] = ray.mask;
  }

  void closest() override {
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      rtcIntersect8(lanes_[i].valid.data(), scene(), &context_, &hits_[i]);
    }
  }
  void occluded() override {
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      rtcOccluded8(lanes_[i].valid.data(), scene(), &context_, &rays_[i]);
    }
  }

  std::vector<Lanes> lanes_;
  std::vector<RTCRay8> rays_;
  std::vector<RTCRayHit8> hits_;  // empty for shadow rays
};

template <class Kind>
Peer embree_peer(const std::string& how, const std::string& what, EmbreeMode mode) {
  const bool robust = mode == EmbreeMode::robust;
  Peer peer;
  peer.name = fmt::format("Embree {}{}", how, robust ? " robust" : "");
  peer.what = fmt::format("Embree " RTC_VERSION_STRING ", {}, {} mode", what,
                          robust ? "robust" : "default");
  peer.answers = robust ? Peer::Answers::robust : Peer::Answers::fast;
  peer.width = std::is_same_v<Kind, EmbreeSingle> ? Peer::Width::one : Peer::Width::many;
  peer.foreign = true;
  peer.enter = [mode](const World& world) -> MakeTracer {
    const auto scene = std::make_shared<const EmbreeScene>(world.scene, mode);
    return [scene] { return std::make_unique<Kind>(scene); };
  };
  return peer;
}

}  // namespace

std::vector<Peer> embree_peers() {
  std::vector<Peer> peers;
  for (const EmbreeMode mode : {EmbreeMode::robust, EmbreeMode::standard}) {
    peers.push_back(embree_peer<EmbreeSingle>("1 ray", "one ray at a time", mode));
    peers.push_back(embree_peer<EmbreePacket>("8 rays", "packets of 8 rays", mode));
    peers.push_back(embree_peer<EmbreeStream>("stream", "streams of 64 rays", mode));
  }
  return peers;
}
#else
std::vector<Peer> embree_peers() {
  return {};
}
#endif

}  // namespace bspview
