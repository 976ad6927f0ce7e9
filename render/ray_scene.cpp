#include "render/ray_scene.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>

#include "core/base/assert.h"

namespace proveout::render_detail {

namespace {

/// Units. Faces that lie in the cut are passed by this: the side behind them then decides.
constexpr float kPastCut = 1e-5F;
constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr std::size_t kLanes = RayPack::kRays;

std::array<float, kLanes> filled(float value) {
  std::array<float, kLanes> lanes;
  lanes.fill(value);
  return lanes;
}

struct ActiveLanes {
  alignas(32) std::array<int, kLanes> flags;
  explicit ActiveLanes(std::uint32_t lanes) {
    for (std::size_t k = 0; k < kLanes; ++k) flags[k] = -static_cast<int>(lanes >> k & 1U);
  }
};

void fillRays(RTCRay8& out, const RayPack& rays, const std::array<float, kLanes>& from,
              const std::array<float, kLanes>& to) {
  std::copy(rays.origin[0].begin(), rays.origin[0].end(), out.org_x);
  std::copy(rays.origin[1].begin(), rays.origin[1].end(), out.org_y);
  std::copy(rays.origin[2].begin(), rays.origin[2].end(), out.org_z);
  std::copy(rays.direction[0].begin(), rays.direction[0].end(), out.dir_x);
  std::copy(rays.direction[1].begin(), rays.direction[1].end(), out.dir_y);
  std::copy(rays.direction[2].begin(), rays.direction[2].end(), out.dir_z);
  std::copy(from.begin(), from.end(), out.tnear);
  std::copy(to.begin(), to.end(), out.tfar);
  std::fill(std::begin(out.time), std::end(out.time), 0.0F);
  std::fill(std::begin(out.mask), std::end(out.mask), 0xFFFFFFFFU);
  std::fill(std::begin(out.id), std::end(out.id), 0U);
  std::fill(std::begin(out.flags), std::end(out.flags), 0U);
}

}  // namespace

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Impl() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

Result<RayScene> RayScene::build(const TriMesh& mesh) {
  RayScene scene;
  const Box3 bounds = meshBounds(mesh);
  scene.center_ = bounds.center();
  scene.radius_ = std::max(0.5 * bounds.size().norm(), 1e-9);
  scene.floor_ = scene.toUnit(bounds.min).z();
  const auto owned = std::make_shared<Impl>();
  Impl& impl = *owned;
  scene.impl_ = owned;
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

RayScene RayScene::cut(const SectionCut& section) const {
  RayScene scene = *this;
  PROVEOUT_ASSERT(std::abs(section.side_x) == 1 && std::abs(section.side_y) == 1);
  scene.has_cut_ = true;
  scene.cut_at_ = toUnit({section.axis.x(), section.axis.y(), center_.z()});
  scene.cut_normals_ = {Eigen::Vector3f(static_cast<float>(section.side_x), 0, 0),
                        Eigen::Vector3f(0, static_cast<float>(section.side_y), 0)};
  return scene;
}

bool RayScene::cutAway(const Vec3& p) const {
  const Eigen::Vector3f d = toUnit(p) - cut_at_;
  return has_cut_ && d.dot(cut_normals_[0]) > 0 && d.dot(cut_normals_[1]) > 0;
}

bool RayScene::cutSpan(const RayPack& rays, std::size_t lane, CutSpan& span) const {
  if (!has_cut_) return false;
  span = {0.0F, kFar, -1};
  for (int i = 0; i < 2; ++i) {
    // The planes of the cut are those of constant x and y.
    const auto axis = static_cast<std::size_t>(i);
    const float side = cutNormal(i)[i];
    const float height = side * (rays.origin[axis][lane] - cut_at_[i]),
                slope = side * rays.direction[axis][lane];
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

std::uint32_t RayScene::nearest(const RayPack& rays, std::uint32_t lanes, const Lanes& from, const Lanes& to,
                                std::array<Hit, RayPack::kRays>& hits, std::uint32_t& back) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit8 query;
  fillRays(query.ray, rays, from, to);
  std::fill(std::begin(query.hit.geomID), std::end(query.hit.geomID), RTC_INVALID_GEOMETRY_ID);
  std::fill(std::begin(query.hit.instID[0]), std::end(query.hit.instID[0]), RTC_INVALID_GEOMETRY_ID);
  const ActiveLanes active(lanes);
  rtcIntersect8(active.flags.data(), impl_->scene, &context, &query);
  std::uint32_t met = 0;
  for (std::size_t k = 0; k < kLanes; ++k) {
    if ((lanes >> k & 1U) == 0 || query.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
    met |= 1U << k;
    hits[k] = {query.hit.primID[k], query.hit.u[k], query.hit.v[k], query.ray.tfar[k], -1};
    const float facing = rays.direction[0][k] * query.hit.Ng_x[k] + rays.direction[1][k] * query.hit.Ng_y[k] +
                         rays.direction[2][k] * query.hit.Ng_z[k];
    if (facing > 0) back |= 1U << k;
  }
  return met;
}

std::uint32_t RayScene::anyHit(const RayPack& rays, std::uint32_t lanes, const Lanes& from,
                               const Lanes& to) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay8 query;
  fillRays(query, rays, from, to);
  const ActiveLanes active(lanes);
  rtcOccluded8(active.flags.data(), impl_->scene, &context, &query);
  std::uint32_t met = 0;
  for (std::size_t k = 0; k < kLanes; ++k) met |= static_cast<std::uint32_t>(query.tfar[k] < 0) << k;
  return met & lanes;
}

RayScene::Stretches RayScene::split(const RayPack& rays, float reach) const {
  Stretches both{0, 0, filled(reach), filled(0.0F), {}};
  for (std::size_t k = 0; k < kLanes; ++k) {
    if (rays.active[k] == 0) continue;
    CutSpan& span = both.spans[k];
    if (!cutSpan(rays, k, span)) {
      both.first |= 1U << k;
      continue;
    }
    if (span.enter > 0) both.first |= 1U << k;
    if (span.face >= 0 && span.leave < reach) both.second |= 1U << k;
    both.to[k] = std::min(reach, span.enter);
    both.behind[k] = span.leave + kPastCut;
  }
  return both;
}

std::uint32_t RayScene::intersect(const RayPack& rays, std::array<Hit, RayPack::kRays>& hits) const {
  const Stretches both = split(rays, kFar);
  std::uint32_t back = 0;
  const std::uint32_t met =
      both.first == 0 ? 0 : nearest(rays, both.first, filled(0.0F), both.to, hits, back);
  const std::uint32_t second = both.second & ~met;
  if (second == 0) return met;
  back = 0;
  const std::uint32_t later = nearest(rays, second, both.behind, filled(kFar), hits, back);
  for (std::size_t k = 0; k < kLanes; ++k) {
    if ((later & back) >> k & 1U) hits[k] = {0, 0, 0, both.spans[k].leave, both.spans[k].face};
  }
  return met | later;
}

std::uint32_t RayScene::occluded(const RayPack& rays, float reach) const {
  const Stretches both = split(rays, reach);
  std::uint32_t met = both.first == 0 ? 0 : anyHit(rays, both.first, filled(0.0F), both.to);
  const std::uint32_t second = both.second & ~met;
  if (second == 0) return met;
  std::uint32_t back = 0;
  std::array<Hit, RayPack::kRays> hits;
  const std::uint32_t later = nearest(rays, second, both.behind, filled(kFar), hits, back);
  for (std::size_t k = 0; k < kLanes; ++k) {
    if ((later >> k & 1U) && ((back >> k & 1U) || hits[k].distance <= reach)) met |= 1U << k;
  }
  return met;
}

bool RayScene::occluded(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float reach) const {
  RayPack one;
  one.set(0, origin, direction);
  return occluded(one, reach) != 0;
}

}  // namespace proveout::render_detail
