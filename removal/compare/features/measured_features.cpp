#include "removal/compare/features/measured_features.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/parallel_for.h"
#include "removal/compare/features/dimensions.h"

namespace proveout {
namespace measure_detail {

/// How far a ring of lines along a hole is free, mm, at most `length`; `start`: on its axis.
double freeLength(const ExactPart& part, const CadFace& hole, const Vec3& start, const Vec3& into,
                  double length) {
  constexpr int kLines = 12;
  constexpr double kShare = 0.8, kStill = 1e-6;  // of the radius; mm
  constexpr int kSteps = 10'000;
  const Vec3 u = hole.axis.unitOrthogonal(), v = hole.axis.cross(u);
  double least = length;
  for (int k = 0; k < kLines; ++k) {
    const double angle = 2.0 * kPi * k / kLines;
    const Vec3 p = start + kShare * hole.radius * (std::cos(angle) * u + std::sin(angle) * v);
    double t = 0.0;
    for (int step = 0; step < kSteps && t < least; ++step) {
      const double free = part.at(p + t * into, length).value;
      if (free <= kStill) break;
      t += free;
    }
    least = std::min(least, t);
  }
  return least;
}

class Measurer {
 public:
  Measurer(const CadFaces& faces, const std::vector<FaceFit>& fits, const ExactPart& part)
      : faces_(faces), part_(part), fit_of_(faces.faces.size(), nullptr) {
    for (const FaceFit& fit : fits) fit_of_[fit.face] = &fit;
  }

  void measure(Feature& feature) const {
    feature.missing = isMissing(feature);
    if (feature.missing) return;
    for (Characteristic& c : feature.characteristics) {
      const bool known =
          std::all_of(c.faces.begin(), c.faces.end(), [&](std::uint32_t f) { return isThere(f); });
      if (known) c.measured = valueIn(c);
    }
  }

 private:
  bool isThere(std::uint32_t f) const { return fit_of_[f] != nullptr && !fit_of_[f]->gone(); }
  const CadFace& fitted(std::uint32_t f) const { return fit_of_[f]->fitted; }

  /// The faces that make it are gone: the walls of a hole or a boss, all that is measured of another feature.
  bool isMissing(const Feature& feature) const {
    const bool round = feature.kind == FeatureKind::kHole || feature.kind == FeatureKind::kBoss;
    std::size_t there = 0, gone = 0;
    for (const Characteristic& c : feature.characteristics)
      if (!round || c.quantity == Quantity::kDiameter) ++(isThere(c.faces.front()) ? there : gone);
    return there == 0 && gone > 0;
  }

  std::optional<double> valueIn(const Characteristic& c) const {
    const FaceFit& first = *fit_of_[c.faces.front()];
    const CadFace& model = faces_.faces[c.faces.front()];
    switch (c.quantity) {
      case Quantity::kFlatness:
      case Quantity::kCylindricity:
      case Quantity::kForm:
        return first.form_mm;
      case Quantity::kPosition:
        return first.placed ? std::optional(positionOf(c, model, first.fitted)) : std::nullopt;
      case Quantity::kX:
      case Quantity::kY:
      case Quantity::kZ:
        if (model.kind != SurfaceKind::kPlane && !first.placed) return std::nullopt;
        break;
      case Quantity::kPerpendicularity:
        if (!first.tilted) return std::nullopt;
        break;
      case Quantity::kDepth:
        if (c.faces.size() == 3) return depthIn(c);
        break;
      default:
        break;
    }
    return valueOf(c, [this](std::uint32_t f) -> const CadFace& { return fitted(f); });
  }

  /// Depth of a hole. A plane that it comes out of is there though the hole may not reach it.
  std::optional<double> depthIn(const Characteristic& c) const {
    const auto depth = valueOf(c, [this](std::uint32_t f) -> const CadFace& { return fitted(f); });
    const CadFace &entry = faces_.faces[c.faces[1]], &end = faces_.faces[c.faces[2]];
    const bool through = entry.kind == SurfaceKind::kPlane && end.kind == SurfaceKind::kPlane &&
                         entry.axis.dot(end.axis) < 0.0;
    if (!depth || !through) return depth;
    const CadFace& hole = fitted(c.faces[0]);
    const CadFace& from = fitted(c.faces[1]);
    const double slope = from.axis.dot(hole.axis);
    const Vec3 start = hole.origin + (from.origin - hole.origin).dot(from.axis) / slope * hole.axis;
    const Vec3 into = slope > 0.0 ? Vec3(-hole.axis) : hole.axis;
    constexpr double kInside = 1e-3;  // of the length: where inclined planes cut the ring off
    const double free = freeLength(part_, hole, start, into, *depth);
    return free >= (1.0 - kInside) * *depth ? depth : std::optional(free);
  }

  const CadFaces& faces_;
  const ExactPart& part_;
  std::vector<const FaceFit*> fit_of_;
};

}  // namespace measure_detail

void measureFeatures(const CadFaces& faces, const std::vector<FaceFit>& fits, const ExactPart& part,
                     std::vector<Feature>& features) {
  const measure_detail::Measurer measurer(faces, fits, part);
  parallelFor(std::size_t{0}, features.size(), [&](std::size_t k) { measurer.measure(features[k]); });
}

}  // namespace proveout
