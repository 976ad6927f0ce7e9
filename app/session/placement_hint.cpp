#include "app/session/placement_hint.h"

#include <fmt/format.h>

#include <cmath>

#include "core/geometry/place_text.h"

namespace proveout {
namespace {

constexpr double kAgreement = 0.01;
constexpr double kUnitFactors[] = {25.4, 1.0 / 25.4, 1000.0, 1.0 / 1000.0};

bool sizesAgree(const Box3& body, double scale, const Box3& wanted) {
  const Vec3 off = (scale * body.size() - wanted.size()).cwiseAbs();
  return (off.array() <= kAgreement * wanted.size().array()).all();
}

/// The unit of a mesh whose numbers, read with `unit`, came out too small by `scale`.
std::optional<MeshUnit> unitBehind(MeshUnit unit, double scale) {
  for (const MeshUnit other : {MeshUnit::kMillimetre, MeshUnit::kInch, MeshUnit::kMetre}) {
    const double wanted = scale * meshUnitInMm(unit);
    if (std::abs(meshUnitInMm(other) - wanted) < 1e-9 * wanted) return other;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Placement> evidentPlacement(const Box3& body, const Box3& wanted) {
  if (body.empty() || wanted.empty() || !(body.size().minCoeff() > 0.0) || !(wanted.size().minCoeff() > 0.0))
    return std::nullopt;
  Placement placement;
  bool found = sizesAgree(body, 1.0, wanted);
  for (const double factor : kUnitFactors) {
    if (found || !sizesAgree(body, factor, wanted)) continue;
    found = true;
    placement.scale = factor;
  }
  if (!found) return std::nullopt;
  placement.shift = wanted.center() - placement.scale * body.center();
  if (placement.shift.cwiseAbs().maxCoeff() <= kAgreement * wanted.size().maxCoeff())
    placement.shift.setZero();
  if (placement.scale == 1.0 && placement.shift.isZero(0.0)) return std::nullopt;
  return placement;
}

std::string placementText(const Placement& placement, MeshUnit unit, const std::string& wanted) {
  std::string text;
  if (placement.scale != 1.0) {
    text = placement.scale > 1.0 ? fmt::format("scaled by {:g}", placement.scale)
                                 : fmt::format("scaled by 1/{:g}", 1.0 / placement.scale);
    if (const auto right = unitBehind(unit, placement.scale))
      text += fmt::format(" (unit \"{}\" in place of \"{}\")", meshUnitName(*right), meshUnitName(unit));
  }
  const Vec3& shift = placement.shift;
  if (!shift.isZero(0.0)) {
    text += fmt::format("{}moved by X{:g} Y{:g} Z{:g}", text.empty() ? "" : " and ", toMicrometre(shift.x()),
                        toMicrometre(shift.y()), toMicrometre(shift.z()));
  }
  return fmt::format("{} its bounds would agree with those of {}", text, wanted);
}

}  // namespace proveout
