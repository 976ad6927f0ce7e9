#include "removal/sweep/swept_body.h"

#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "removal/grid/edge_root.h"

namespace proveout {

double searchCut(const SweptField& field, const Vec3& a, const Vec3& direction, double inside) {
  PROVEOUT_ASSERT_DEAR(std::abs(direction.norm() - 1.0) < 1e-9);
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto f = [&](double s) { return field.distance(a + s * direction, kNever); };
  const double at_a = f(0.0), at_inside = f(inside);
  if (at_a <= 0.0) return 0.0;
  if (at_inside >= 0.0) return inside;  // touched within rounding
  return edgeRoot(f, 0.0, at_a, inside, at_inside, 1e-9);
}

void SweptBody::cutEdges(EdgeCuts& cuts) const {
  std::visit([&](const auto& kind) { kind.cutEdges(of_, cuts); }, kind_);
}

double SweptBody::highestReach() const {
  return std::visit([](const auto& kind) { return kind.highestReach(); }, kind_);
}

double SweptBody::coveredTop() const {
  return std::visit([](const auto& kind) { return kind.coveredTop(); }, kind_);
}

double SweptBody::mostDepth(double x, double y) const {
  return std::visit([&](const auto& kind) { return kind.mostDepth(x, y); }, kind_);
}

bool SweptBody::holdsEdges(double h, const Vec2& middle, double reach) const {
  return std::visit([&](const auto& kind) { return kind.holdsEdges(h, middle, reach); }, kind_);
}

EdgeCut SweptBody::levelCut(const Vec3& a, double dx, double dy, double inside) const {
  PROVEOUT_ASSERT_DEAR(std::abs(dx * dx + dy * dy - 1.0) < 1e-9);
  return std::visit([&](const auto& kind) { return kind.levelCut(of_, a, dx, dy, inside); }, kind_);
}

SweptSurface SweptBody::surface(const Vec3& p, int axis, bool below, double start) const {
  if (const auto closed = closedSurface(p, axis, below)) return *closed;
  const auto seen = [](const SweepSample& sample) { return SweptSurface{sample.gradient, sample.element}; };
  if (of_.whole == nullptr) return seen(field().sample(p));
  if (start < 0.0) start = std::visit([&](const auto& kind) { return kind.startAt(of_, p); }, kind_);
  return seen(of_.whole->sampleOnSurface(p, start));
}

std::optional<SweptSurface> SweptBody::closedSurface(const Vec3& p, int axis, bool below) const {
  return std::visit([&](const auto& kind) { return kind.closedSurface(of_, p, axis, below); }, kind_);
}

std::optional<double> SweptBody::simpleBend(int element) const {
  if (element >= ConvexProfile::kEdgeIds) return std::nullopt;
  const int number = element - profile().firstElementId();
  if (number >= profile().elementCount()) return std::nullopt;
  const ConvexProfile::Element& e = profile().element(number);
  return std::visit([&](const auto& kind) { return kind.simpleBend(e); }, kind_);
}

Vec3 SweptBody::directionAt(const Vec3& p) const {
  return std::visit([&](const auto& kind) { return kind.directionAt(p); }, kind_);
}

SweptField SweptBody::field() const {
  return std::visit([&](const auto& kind) { return kind.field(of_); }, kind_);
}

double SweptBody::distance(const Vec3& p, double cutoff) const {
  return of_.whole != nullptr ? of_.whole->distance(p, cutoff) : field().distance(p, cutoff);
}

bool SweptBody::holds(const Vec3& a, const Vec3& b) const {
  return of_.whole != nullptr ? of_.whole->holds(a, b) : field().holds(a, b);
}

double SweptBody::wholeCut(const Vec3& a, const Vec3& direction, double inside) const {
  if (of_.whole != nullptr) return searchCut(*of_.whole, a, direction, inside);
  return searchCut(field(), a, direction, inside);
}

bool SweptBody::isAskedWhole() const {
  return std::visit([&](const auto& kind) { return kind.isAskedWhole(of_); }, kind_);
}

const ColumnSolid* SweptBody::uprightSolid() const {
  return std::visit([](const auto& kind) { return kind.uprightSolid(); }, kind_);
}

std::optional<double> SweptBody::ownLength() const {
  return std::visit([](const auto& kind) { return kind.ownLength(); }, kind_);
}

ToolPlace SweptBody::placeAt(double t) const {
  PROVEOUT_ASSERT_DEAR(t >= 0.0 && t <= 1.0);
  return std::visit([&](const auto& kind) { return kind.placeAt(t); }, kind_);
}

}  // namespace proveout
