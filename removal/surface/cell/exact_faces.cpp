#include "removal/surface/cell/exact_faces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/mesh/triangle_tree.h"
#include "removal/grid/blank_field.h"

namespace proveout {

namespace {

/// Of distances, in cells: a hundredth of a micrometre on a grid of 0.2 mm.
constexpr double kFootTolerance = 5e-5;

/// A body this near to a point, in cells, reaches it.
constexpr double kTouch = 1e-3;

/// How far, in cells, a face of the blank is looked for.
constexpr double kBlankReach = 3.0;

/// An element that makes cones leans from the axes by at least this (sine).
constexpr double kSlanted = 0.02;

/// Rounding of normals of one face, as a sine.
constexpr double kFaceSlack = 1e-6;

/// By how much a face that a tool swept in passing may miss being at right angles to the motion (sine):
/// rounding of normals.
constexpr double kPerpendicular = 2e-3;

/// Cosine of the angle by which neighbouring elements may turn where they meet and still have a common
/// tangent there.
constexpr double kTangentCos = 0.9999;

MotionId motionOf(std::uint64_t face) { return static_cast<MotionId>(face >> 16); }
/// Number of the profile's element; of a rim, that of the element it belongs to.
int elementOf(std::uint64_t face) { return static_cast<int>(face & (ConvexProfile::kEdgeIds - 1)); }

bool holds(const ConvexProfile& profile, int element) {
  return element >= profile.firstElementId() &&
         element < profile.firstElementId() + ConvexProfile::kMaxElements;
}

Vec2 directionOf(const ConvexProfile::Element& e, bool at_end) {
  if (!e.arc) return {e.dr, e.dz};
  const Vec2 out = Vec2((at_end ? e.br : e.ar) - e.cr, (at_end ? e.bz : e.az) - e.cz) / e.radius;
  return {-out.y(), out.x()};
}

/// Whether the element is straight and makes cones.
bool isSlanted(const ConvexProfile::Element& e) {
  return !e.arc && std::min(std::abs(e.dr), std::abs(e.dz)) > kSlanted;
}

/// Whether the element of this id and the next one meet with a common tangent.
bool isTangentToNext(const ConvexProfile& profile, int element) {
  const int i = element - profile.firstElementId();
  if (i < 0 || i + 1 >= profile.elementCount()) return false;
  return directionOf(profile.element(i), true).dot(directionOf(profile.element(i + 1), false)) > kTangentCos;
}

/// The face with the motion by which the blank knows it, also after a path was run.
std::uint64_t faceOfBlank(std::uint64_t face) {
  const MotionId motion = motionOf(face);
  if (motion == kNoMotion || motion < kEarlierMotions) return face;
  return std::uint64_t{motion - kEarlierMotions} << 16 | (face & 0xFFFF);
}
/// Bodies below ExactFaces::kNoBody stand for faces of the blank.
std::int64_t bodyOfFace(std::uint64_t face) {
  return ExactFaces::kNoBody - 1 - static_cast<std::int64_t>(faceOfBlank(face));
}
std::uint64_t faceOfBody(std::int64_t body) {
  return static_cast<std::uint64_t>(ExactFaces::kNoBody - 1 - body);
}

}  // namespace

const Pass* ExactFaces::passOf(std::uint64_t face) const {
  if (record_ == nullptr) return nullptr;
  const int element = elementOf(face);
  for (const Pass& pass : record_->table.of(motionOf(face))) {
    if (pass.cuts() && holds(pass.body.profile(), element)) return &pass;
  }
  return nullptr;
}

ExactFaces::Source ExactFaces::findSource(std::uint64_t face) const {
  if (blank_ != nullptr)
    return {static_cast<std::int64_t>(faceOfBlank(face)), blank_->isSimple(faceOfBlank(face))};
  const Pass* pass = passOf(face);
  if (pass == nullptr && cut_ != nullptr) return {bodyOfFace(face), cut_->isSimple(face)};
  if (pass == nullptr) return {kNoBody, true};
  const std::optional<double> bend = pass->body.simpleBend(static_cast<int>(face & 0xFFFF));
  const ConvexProfile& profile = pass->body.profile();
  const ConvexProfile::Element& e = profile.element(elementOf(face) - profile.firstElementId());
  return {pass - record_->table.passes.data(), bend.has_value(), h_ * bend.value_or(0.0), !e.arc,
          isSlanted(e)};
}

ExactFaces::Source ExactFaces::source(std::uint64_t face) {
  KnownFace& known = known_[(face ^ face >> 16) % known_.size()];  // motion and element
  if (known.face != face) known = {face, findSource(face)};
  return known.source;
}

ExactFaces::Body& ExactFaces::bodyOf(std::int64_t number) {
  for (Body& b : kept_) {
    if (b.number == number) return b;
  }
  const Pass& pass = record_->table.passes[static_cast<std::size_t>(number)];
  const Body body{number, pass.body.field()};
  if (kept_.size() < kKept) return kept_.emplace_back(body);
  Body& b = kept_[oldest_];
  oldest_ = (oldest_ + 1) % kKept;
  return b = body;
}

ExactFaces::Foot ExactFaces::footOnField(std::uint64_t face, const Vec3& q) const {
  const BlankField& field = blank_ != nullptr ? *blank_ : *cut_;
  const auto at = field.facePoint(face, corner_ + h_ * q, kBlankReach * h_);
  if (!at) return {q, Vec3::Zero(), 0};  // faces nothing
  return {(at->p - corner_) / h_, at->normal, static_cast<int>(face & 0xFFFF)};
}

ExactFaces::Foot ExactFaces::foot(std::int64_t body, const Vec3& q) {
  if (blank_ != nullptr) return footOnField(static_cast<std::uint64_t>(body), q);
  if (body < kNoBody) return footOnField(faceOfBody(body), q);
  Body& b = bodyOf(body);
  const SweepSample s = b.field.sampleOutside(corner_ + h_ * q, kFootTolerance * h_, b.start);
  return {q - s.gradient * (s.value / h_), -s.gradient, s.element};
}

Vec3 ExactFaces::directionAt(std::int64_t body, const Vec3& q) const {
  return record_->table.passes[static_cast<std::size_t>(body)].body.directionAt(corner_ + h_ * q);
}

int ExactFaces::sweepEndAt(std::int64_t body, const Vec3& q, const Vec3& normal) const {
  if (blank_ != nullptr || body <= kNoBody) return 0;
  const double along = directionAt(body, q).dot(normal);
  return std::abs(along) < kPerpendicular ? 0 : along > 0.0 ? 1 : -1;
}

bool ExactFaces::isRounded(std::int64_t body) const {
  if (blank_ != nullptr || body <= kNoBody) return false;
  const ConvexProfile& profile = record_->table.passes[static_cast<std::size_t>(body)].body.profile();
  bool arc = false;
  for (int i = 0; i < profile.elementCount(); ++i) arc = arc || profile.element(i).arc;
  return arc;
}

double ExactFaces::distanceTo(std::int64_t body, const Vec3& q, double most) {
  constexpr double kTold = 1e-3;
  return bodyOf(body).field.distance(corner_ + h_ * q, most * h_, kTold * h_) / h_;
}

bool ExactFaces::isFarther(std::int64_t body, const Vec3& q, double by) {
  constexpr double kTold = 0.05;
  return bodyOf(body).field.distance(corner_ + h_ * q, by * h_, kTold * by * h_) > by * h_;
}

double ExactFaces::blankValue(const Vec3& q) const { return blank_->value(corner_ + h_ * q) / h_; }

bool ExactFaces::isReachedByOthers(std::int64_t body, const Vec3& q) {
  return record_ != nullptr &&
         record_->cutters().comesTo(corner_ + h_ * q, kTouch * h_, static_cast<std::uint32_t>(body));
}

bool ExactFaces::isCovered(const Vec3& q, double depth) {
  return record_ != nullptr && record_->cutters().comesTo(corner_ + h_ * q, -depth * h_);
}

bool ExactFaces::isOffCutBlank(const Vec3& q, double by) const {
  if (impl_.cut_blank != nullptr) return std::abs(impl_.cut_blank->value(corner_ + h_ * q)) > by * h_;
  if (impl_.blank_mesh == nullptr) return false;
  return impl_.blank_mesh->nearest(corner_ + h_ * q, TriangleTree::kNone, by * h_).triangle ==
         TriangleTree::kNone;
}

bool ExactFaces::isOnFace(const Foot& foot, std::uint64_t face) const {
  const int element = static_cast<int>(face & 0xFFFF);
  const int end = foot.element & ~ConvexProfile::kEdgeIds, first = element & ~ConvexProfile::kEdgeIds;
  if (element >= ConvexProfile::kEdgeIds) {
    // A rim is named after the first of the two elements that meet there.
    return end == first || end == first + 1;
  }
  if (foot.element == element) return true;
  const Pass* const pass = std::abs(end - first) == 1 ? passOf(face) : nullptr;
  if (pass == nullptr) return false;
  const ConvexProfile& profile = pass->body.profile();
  // Going upright, the rim of a floor leaves the wall that the flank leaves.
  const ConvexProfile::Element& e = profile.element(first - profile.firstElementId());
  const Vec3 axis = pass->body.axis();
  return !e.arc && !axis.isZero() && std::abs(foot.normal.dot(axis) - e.dr) < kFaceSlack;
}

bool ExactFaces::isOnTangentNeighbour(const Foot& foot, std::uint64_t face) const {
  const int end = foot.element & ~ConvexProfile::kEdgeIds, first = elementOf(face);
  const Pass* const pass = std::abs(end - first) == 1 ? passOf(face) : nullptr;
  return pass != nullptr && isTangentToNext(pass->body.profile(), std::min(end, first));
}

/// The straight element of a tool that made both faces, with its axis in the same direction. Null where
/// there is none.
const ConvexProfile::Element* ExactFaces::straightElementOf(std::uint64_t face, std::uint64_t other) const {
  if ((face & 0xFFFF) != (other & 0xFFFF) || (face & ConvexProfile::kEdgeIds) != 0) return nullptr;
  const Pass *const a = passOf(face), *const b = passOf(other);
  if (a == nullptr || b == nullptr || &a->body.profile() != &b->body.profile()) return nullptr;
  if (a->body.axis() != b->body.axis() || a->body.axis().isZero()) return nullptr;
  const ConvexProfile& profile = a->body.profile();
  const ConvexProfile::Element& e = profile.element(elementOf(face) - profile.firstElementId());
  return e.arc ? nullptr : &e;
}

bool ExactFaces::areOfOneCone(std::uint64_t face, std::uint64_t other) const {
  const ConvexProfile::Element* const e = straightElementOf(face, other);
  return e != nullptr && isSlanted(*e);
}

bool ExactFaces::areOfOneCylinder(std::uint64_t face, std::uint64_t other) const {
  const ConvexProfile::Element* const e = straightElementOf(face, other);
  return e != nullptr && e->dr == 0.0;
}

bool ExactFaces::areOfLeaningCylinder(std::uint64_t face, std::uint64_t other) const {
  return areOfOneCylinder(face, other) && std::abs(passOf(face)->body.axis().z()) < 1.0 - kFaceSlack;
}

bool ExactFaces::areTangentNeighbours(std::uint64_t face, std::uint64_t other) const {
  if (motionOf(face) != motionOf(other) || ((face | other) & ConvexProfile::kEdgeIds) != 0) return false;
  const int a = elementOf(face), b = elementOf(other);
  const Pass* const pass = std::abs(a - b) == 1 ? passOf(face) : nullptr;
  return pass != nullptr && isTangentToNext(pass->body.profile(), std::min(a, b));
}

}  // namespace proveout
