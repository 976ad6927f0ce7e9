#include "render/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <limits>

namespace proveout::render_detail {

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

RayScene::RayScene() : impl_(std::make_unique<Impl>()) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;

Result<RayScene> RayScene::build(const TriMesh& mesh) {
  RayScene scene;
  const Box3 bounds = meshBounds(mesh);
  scene.center_ = bounds.center();
  scene.radius_ = std::max(0.5 * bounds.size().norm(), 1e-9);
  scene.floor_ = scene.toUnit(bounds.min).z();

  Impl& impl = *scene.impl_;
  impl.device = rtcNewDevice(nullptr);
  if (!impl.device) {
    return Error{ErrorKind::kInternal, fmt::format("ray tracer did not start: Embree error {}",
                                                   static_cast<int>(rtcGetDeviceError(nullptr)))};
  }
  impl.scene = rtcNewScene(impl.device);
  rtcSetSceneFlags(impl.scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(impl.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                              mesh.triangles.size()));
  if (!positions || !indices) {
    rtcReleaseGeometry(geometry);
    return Error{ErrorKind::kResourceLimit, "not enough memory to draw the mesh"};
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    Eigen::Map<Eigen::Vector3f>(positions + 3 * i) = scene.toUnit(mesh.positions[i].cast<double>());
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) indices[3 * i + c] = mesh.triangles[i][c];
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl.scene, geometry);
  rtcReleaseGeometry(geometry);
  // One thread builds the tree: the order of triangles in its leaves decides rays that hit an edge exactly,
  // and it depends on the number of builders.
  tbb::task_arena(1).execute([&] { rtcJoinCommitScene(impl.scene); });
  if (const RTCError error = rtcGetDeviceError(impl.device); error != RTC_ERROR_NONE) {
    const ErrorKind kind =
        error == RTC_ERROR_OUT_OF_MEMORY ? ErrorKind::kResourceLimit : ErrorKind::kInternal;
    return Error{kind, fmt::format("the mesh cannot be drawn: Embree error {}", static_cast<int>(error))};
  }
  return scene;
}

bool RayScene::intersect(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, Hit& hit) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit query;
  query.ray = {origin.x(),
               origin.y(),
               origin.z(),
               0.0F,
               direction.x(),
               direction.y(),
               direction.z(),
               0.0F,
               std::numeric_limits<float>::infinity(),
               0xFFFFFFFFu,
               0,
               0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = {query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar};
  return true;
}

bool RayScene::occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{origin.x(), origin.y(),  origin.z(), 0.0F, direction.x(), direction.y(), direction.z(), 0.0F,
             reach,      0xFFFFFFFFu, 0,          0};
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar < 0;
}

}  // namespace proveout::render_detail
