#include "app/session/nominal/placement_hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/geometry/place_text.h"

namespace proveout {
namespace {

constexpr double kAgreement = 0.01;

/// The unit of a mesh whose numbers, read with `unit`, came out too small by `scale`.
std::optional<MeshUnit> unitBehind(MeshUnit unit, double scale) {
  for (const MeshUnit other : {MeshUnit::kMillimetre, MeshUnit::kInch, MeshUnit::kMetre}) {
    const double wanted = scale * meshUnitInMm(unit);
    if (std::abs(meshUnitInMm(other) - wanted) < 1e-9 * wanted) return other;
  }
  return std::nullopt;
}

bool isLarge(const Box3& box) { return !box.empty() && box.size().minCoeff() > 0.0; }

/// Along X, Y and Z.
bool sizesAgree(const Box3& body, const Box3& wanted) {
  if (!isLarge(body) || !isLarge(wanted)) return false;
  return ((body.size() - wanted.size()).array().abs() <= kAgreement * wanted.size().array()).all();
}

std::string scaleText(double scale, MeshUnit unit) {
  std::string text =
      scale > 1.0 ? fmt::format("scaled by {:g}", scale) : fmt::format("scaled by 1/{:g}", 1.0 / scale);
  if (const auto right = unitBehind(unit, scale))
    text += fmt::format(" (unit \"{}\" in place of \"{}\")", meshUnitName(*right), meshUnitName(unit));
  return text;
}

std::string turnText(const Vec3& rotate_deg) {
  constexpr char kAxes[] = "XYZ";
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (rotate_deg[axis] == 0.0) continue;
    text += fmt::format("{}by {:g} about {}", text.empty() ? "turned " : ", then ", rotate_deg[axis],
                        kAxes[axis]);
  }
  return text;
}

std::string moveText(const Vec3& move) {
  return fmt::format("moved by X{:g} Y{:g} Z{:g}", toMicrometre(move.x()), toMicrometre(move.y()),
                     toMicrometre(move.z()));
}

std::string numbers(const Vec3& v, std::string_view between) {
  return fmt::format("{:g}{}{:g}{}{:g}", toMicrometre(v.x()), between, toMicrometre(v.y()), between,
                     toMicrometre(v.z()));
}

}  // namespace

const std::vector<Vec3>& quarterTurns() {
  static const std::vector<Vec3> turns = [] {
    std::vector<Vec3> out;
    std::vector<Eigen::Matrix3d> known;
    for (int axes = 0; axes <= 3; ++axes) {  // that turn
      for (int k = 0; k < 64; ++k) {
        constexpr double kAngle[] = {0.0, 90.0, -90.0, 180.0};
        const Vec3 angles(kAngle[k >> 4 & 3], kAngle[k >> 2 & 3], kAngle[k & 3]);
        if ((angles.array() != 0.0).count() != axes) continue;
        const Eigen::Matrix3d turn = rotationXyzDeg(angles);
        if (std::find(known.begin(), known.end(), turn) != known.end()) continue;
        known.push_back(turn);
        out.push_back(angles);
      }
    }
    return out;
  }();
  return turns;
}

bool boundsAgree(const Box3& body, const Box3& wanted) {
  return sizesAgree(body, wanted) &&
         (body.center() - wanted.center()).cwiseAbs().maxCoeff() <= kAgreement * wanted.size().maxCoeff();
}

Box3 placedBounds(const MeshPlacement& placement, const Box3& box) {
  return placement.motion()(Box3{placement.scale * box.min, placement.scale * box.max});
}

std::optional<MeshPlacement> evidentPlacement(const Box3& body, const Box3& wanted) {
  if (!isLarge(body) || !isLarge(wanted) || boundsAgree(body, wanted)) return std::nullopt;
  for (const Vec3& turn : quarterTurns()) {
    for (const double factor : kUnitFactors) {
      MeshPlacement change{factor, turn, Vec3::Zero()};
      const Box3 turned = placedBounds(change, body);
      if (!sizesAgree(turned, wanted)) continue;
      if (!boundsAgree(turned, wanted)) change.move = wanted.center() - turned.center();
      return change;
    }
  }
  return std::nullopt;
}

std::string placementText(const MeshPlacement& placement, MeshUnit unit) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " and ") + part; };
  if (placement.scale != 1.0) add(scaleText(placement.scale, unit));
  if (!placement.rotate_deg.isZero(0.0)) add(turnText(placement.rotate_deg));
  if (!placement.move.isZero(0.0)) add(moveText(placement.move));
  return text;
}

std::string placementKeys(const MeshPlacement& given, const MeshPlacement& change, MeshUnit unit) {
  const MeshPlacement whole = chained(given, change);
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  const auto right = change.scale != 1.0 ? unitBehind(unit, change.scale) : std::nullopt;
  if (right) {
    add(fmt::format("unit = \"{}\"", meshUnitName(*right)));
  } else if (change.scale != 1.0) {
    add(fmt::format("scale = {:.9g}", whole.scale));
  }
  if (!change.rotate_deg.isZero(0.0)) add(fmt::format("rotate = [{}]", numbers(whole.rotate_deg, ", ")));
  if (whole.move != given.move) add(fmt::format("move = [{}]", numbers(whole.move, ", ")));
  return text;
}

std::string placementOptions(const MeshPlacement& given, const MeshPlacement& change) {
  const MeshPlacement whole = chained(given, change);
  std::string text;
  if (!change.rotate_deg.isZero(0.0)) text += " --nominal-rotate " + numbers(whole.rotate_deg, ",");
  if (whole.move != given.move) text += " --nominal-at " + numbers(whole.move, ",");
  return text.empty() ? text : text.substr(1);
}

}  // namespace proveout
