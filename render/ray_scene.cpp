#include "render/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>

namespace proveout::render_detail {

namespace {

/// Units. Faces that lie in the cut are passed by this: the side behind them then decides.
constexpr float kPastCut = 1e-5F;

}  // namespace

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

Result<RayScene> RayScene::build(const TriMesh& mesh, const std::optional<SectionCut>& section) {
  RayScene scene;
  const Box3 bounds = meshBounds(mesh);
  scene.center_ = bounds.center();
  scene.radius_ = std::max(0.5 * bounds.size().norm(), 1e-9);
  scene.floor_ = scene.toUnit(bounds.min).z();
  if (section) {
    scene.has_cut_ = true;
    scene.cut_at_ = scene.toUnit({section->axis.x(), section->axis.y(), scene.center_.z()});
    scene.cut_normals_ = {Eigen::Vector3f(static_cast<float>(section->side_x), 0, 0),
                          Eigen::Vector3f(0, static_cast<float>(section->side_y), 0)};
  }

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

bool RayScene::cutAway(const Vec3& p) const {
  const Eigen::Vector3f d = toUnit(p) - cut_at_;
  return has_cut_ && d.dot(cut_normals_[0]) > 0 && d.dot(cut_normals_[1]) > 0;
}

bool RayScene::cutSpan(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, CutSpan& span) const {
  if (!has_cut_) return false;
  span = {0.0F, std::numeric_limits<float>::infinity(), -1};
  for (int i = 0; i < 2; ++i) {
    const float height = (origin - cut_at_).dot(cutNormal(i)), slope = direction.dot(cutNormal(i));
    if (slope == 0) {
      if (height <= 0) return false;
      continue;
    }
    const float at = -height / slope;
    if (slope > 0) {
      span.enter = std::max(span.enter, at);
    } else if (at < span.leave) {
      span.leave = at;
      span.face = i;
    }
  }
  return span.enter < span.leave;
}

bool RayScene::nearest(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float from, float to,
                       Hit& hit, bool& back_face) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit query;
  query.ray = {origin.x(), origin.y(),  origin.z(), from, direction.x(), direction.y(), direction.z(), 0.0F,
               to,         0xFFFFFFFFu, 0,          0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = {query.hit.primID, query.hit.u, query.hit.v, query.ray.tfar};
  back_face = direction.dot(Eigen::Vector3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z)) > 0;
  return true;
}

bool RayScene::anyHit(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float from,
                      float to) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray{origin.x(), origin.y(),  origin.z(), from, direction.x(), direction.y(), direction.z(), 0.0F,
             to,         0xFFFFFFFFu, 0,          0};
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar < 0;
}

bool RayScene::intersect(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, Hit& hit) const {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  bool back_face = false;
  CutSpan span;
  if (!cutSpan(origin, direction, span)) return nearest(origin, direction, 0.0F, kFar, hit, back_face);
  if (span.enter > 0 && nearest(origin, direction, 0.0F, span.enter, hit, back_face)) return true;
  if (span.face < 0 || !nearest(origin, direction, span.leave + kPastCut, kFar, hit, back_face)) return false;
  if (back_face) hit = {0, 0, 0, span.leave, span.face};
  return true;
}

bool RayScene::occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const {
  CutSpan span;
  if (!cutSpan(origin, direction, span)) return anyHit(origin, direction, 0.0F, reach);
  if (span.enter > 0 && anyHit(origin, direction, 0.0F, std::min(reach, span.enter))) return true;
  if (span.face < 0 || span.leave >= reach) return false;
  Hit hit;
  bool back_face = false;
  const float infinite = std::numeric_limits<float>::infinity();
  if (!nearest(origin, direction, span.leave + kPastCut, infinite, hit, back_face)) return false;
  return back_face || hit.distance <= reach;
}

}  // namespace proveout::render_detail
