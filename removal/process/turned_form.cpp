#include "removal/process/turned_form.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/plane.h"
#include "removal/exact/swept_part.h"
#include "removal/turning/turned_field.h"

namespace proveout {
namespace {

/// Chords that turn by less belong to an arc, radians; those of a corner radius of 0.1 mm turn by 0.09.
constexpr double kArcTurn = 0.1;

/// The largest that chords of the grid leave the circles about the axis and the arcs of a loop by, mm.
double gridChordsOf(const SectionLoop& loop, double resolution_mm) {
  double most = 0.0;
  const auto add = [&](double radius) {
    // A chord of the grid leaves a circle by h^2 / (8 r), but never by more than its radius.
    if (radius > 0.0)
      most = std::max(
          most, std::min({resolution_mm * resolution_mm / (8.0 * radius), radius, 0.5 * resolution_mm}));
  };
  const std::size_t n = loop.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    add(loop.points[k].x());
    // Chords of an arc turn by a little from one to the next: their length over that angle is its radius.
    const Vec2 into = loop.points[k] - loop.points[(k + n - 1) % n],
               out = loop.points[(k + 1) % n] - loop.points[k];
    const double turn = std::abs(std::atan2(cross2(into, out), into.dot(out)));
    if (turn > 1e-6 && turn < kArcTurn) add(std::max(into.norm(), out.norm()) / turn);
  }
  return most;
}

}  // namespace

std::shared_ptr<const TurnedShape> TurnedForm::partAlone() const {
  TurnedShape part = shape_;
  part.bodies.resize(1);  // the part itself comes first
  return std::make_shared<const TurnedShape>(std::move(part));
}

std::optional<Result<std::unique_ptr<ExactPart>>> TurnedForm::exactPart() const {
  return makeTurnedPart(partAlone());
}

std::optional<StockShape> TurnedForm::asBlank(const RigidTransform& moved) const {
  return turnedStock(partAlone(), moved);
}

std::optional<double> TurnedForm::gridChords(double resolution_mm) const {
  double most = 0.0;
  if (const std::vector<SectionLoop>* loops = profile()) {
    for (const SectionLoop& loop : *loops) most = std::max(most, gridChordsOf(loop, resolution_mm));
  }
  return most;
}

std::vector<PartForm::Parted> TurnedForm::parted() const {
  std::vector<Parted> out;
  for (std::size_t k = 0; k < shape_.bodies.size(); ++k) {
    if (shape_.bodies[k].parted_by != kNoMotion) out.push_back({k, shape_.bodies[k].parted_by});
  }
  return out;
}

}  // namespace proveout
