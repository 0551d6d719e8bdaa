#ifdef BSPVIEW_EMBREE
#include "core/eval/embree_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/timer.h"
#include "core/scene/triangulate.h"

namespace bspview {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
constexpr Triangle whole{0, 1, 2};

/// Centre and radius.
using Point = std::array<float, 4>;

Point point(Vec3 centre, float radius) {
  return {centre.x, centre.y, centre.z, std::abs(radius)};
}

template <class Element>
void set_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                std::span<const Element> elements) {
  void* buffer =
      rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
  std::copy(elements.begin(), elements.end(), static_cast<Element*>(buffer));
}

std::vector<std::uint32_t> objects_of_kind(const Scene& scene, ObjectKind kind) {
  std::vector<std::uint32_t> objects;
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    if (scene.objects[id].kind == kind && !is_degenerate(scene, id)) objects.push_back(id);
  }
  return objects;
}

/// Adds what Embree allocates or frees to a count; see rtcSetDeviceMemoryMonitorFunction.
bool count_bytes(void* count, ssize_t bytes, bool) {
  *static_cast<std::atomic<std::size_t>*>(count) += static_cast<std::size_t>(bytes);
  return true;
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, EmbreeMode mode, EmbreeBuild build)
    : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
  rtcSetSceneFlags(scene_,
                   mode == EmbreeMode::robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  rtcSetSceneBuildQuality(scene_, build.quality);
  attach_faces(scene);
  attach_spheres(scene);
  attach_cones(scene);
  rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
  const Timer timer;
  // A device of fewer threads would hold the whole program to them as long as it lives.
  with_threads(build.threads, [&] { rtcJoinCommitScene(scene_); });
  build_seconds_ = timer.seconds();
  rtcSetDeviceMemoryMonitorFunction(device_, nullptr, nullptr);
}

EmbreeScene::~EmbreeScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreeScene::attach(RTCGeometry geometry, std::vector<std::uint32_t> objects) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_, geometry, static_cast<unsigned>(objects_.size()));
  rtcReleaseGeometry(geometry);
  objects_.push_back(std::move(objects));
}

void EmbreeScene::attach_faces(const Scene& scene) {
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> objects;
  const auto add = [&](std::uint32_t id, const Triangle& corners) {
    const std::uint32_t first = scene.faces[scene.objects[id].shape].first_vertex;
    triangles.push_back({first + corners[0], first + corners[1], first + corners[2]});
    objects.push_back(id);
  };
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    const Object& object = scene.objects[id];
    if (object.kind == ObjectKind::triangle) add(id, whole);
    if (object.kind != ObjectKind::polygon || is_degenerate(scene, id)) continue;
    for (const Triangle& one : triangulate_polygon(vertices_of(scene, scene.faces[object.shape]))) {
      add(id, one);
    }
  }
  if (triangles.empty()) return;
  RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  set_buffer<Vec3>(mesh, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, scene.vertices);
  set_buffer<Triangle>(mesh, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles);
  attach(mesh, std::move(objects));
}

void EmbreeScene::attach_spheres(const Scene& scene) {
  std::vector<std::uint32_t> objects = objects_of_kind(scene, ObjectKind::sphere);
  if (objects.empty()) return;
  std::vector<Point> points;
  for (const std::uint32_t id : objects) {
    const Sphere& sphere = scene.spheres[scene.objects[id].shape];
    points.push_back(point(sphere.centre, sphere.radius));
  }
  RTCGeometry spheres = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  set_buffer<Point>(spheres, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, points);
  attach(spheres, std::move(objects));
}

void EmbreeScene::attach_cones(const Scene& scene) {
  std::vector<std::uint32_t> objects = objects_of_kind(scene, ObjectKind::cone);
  if (objects.empty()) return;
  std::vector<Point> ends;
  std::vector<std::uint32_t> first_ends;
  for (const std::uint32_t id : objects) {
    const Cone& cone = scene.cones[scene.objects[id].shape];
    first_ends.push_back(static_cast<std::uint32_t>(ends.size()));
    ends.push_back(point(cone.base, cone.base_radius));
    ends.push_back(point(cone.apex, cone.apex_radius));
  }
  // Where a neighbour is said to follow, no cap is put.
  const std::vector<std::uint8_t> flags(
      objects.size(), RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT);
  RTCGeometry cones = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
  set_buffer<Point>(cones, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, ends);
  set_buffer<std::uint32_t>(cones, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, first_ends);
  set_buffer<std::uint8_t>(cones, RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, flags);
  attach(cones, std::move(objects));
}

RTCRay embree_ray(const Ray& ray) {
  RTCRay query{};
  query.org_x = ray.origin.x;
  query.org_y = ray.origin.y;
  query.org_z = ray.origin.z;
  query.dir_x = ray.direction.x;
  query.dir_y = ray.direction.y;
  query.dir_z = ray.direction.z;
  query.tnear = ray.t_min;
  query.tfar = ray.t_max;
  query.mask = ~0u;
  return query;
}

}  // namespace bspview
#endif
