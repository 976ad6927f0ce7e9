// Features of a part as an inspector names them, and the dimensions that they have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/cad_faces.h"

namespace proveout {

enum class FeatureKind : std::uint8_t { kHole, kBoss, kPocket, kSlot, kPlane, kCone, kSphere, kRound };
std::string_view featureKindName(FeatureKind kind);  ///< "hole", "boss", ..., "fillet"
std::optional<FeatureKind> featureKindNamed(std::string_view name);

/// What is told of a feature. Lengths mm, angles degrees.
enum class Quantity : std::uint8_t {
  kDiameter,      ///< of a cylinder
  kConeDiameter,  ///< of a cone where it meets a plane
  kRadius,        ///< of a sphere, a fillet, the tube of a torus
  kX,             ///< of an axis at the feature's middle, of a centre, a plane, the middle between two planes
  kY,
  kZ,
  kPosition,          ///< diameter of the zone around the model's axis or centre (ISO 1101 true position)
  kOffset,            ///< of a plane or a middle along the model's normal, where that is no axis of the frame
  kDepth,             ///< along the axis of a hole, from its entry; of a pocket from its rim
  kHeight,            ///< of a boss
  kWidth,             ///< between two parallel planes that face each other
  kLength,            ///< the same between the farther pair of a pocket's walls
  kAngle,             ///< whole angle of a cone; of an inclined plane to the XY plane
  kPerpendicularity,  ///< of an axis to the plane it starts from, diameter of its zone (ISO 1101)
  kFlatness,
  kCylindricity,
  kForm,         ///< of other faces: what the best fit leaves
  kThickness,    ///< of the part's walls at its least
  kInnerRadius,  ///< of the part's inner corners at its least
  kSkin,         ///< area of the blank's surface that is left
  kScallop,      ///< height of the crests between passes, at its largest
  kRoughness,    ///< arithmetic mean roughness Ra from step-over and tool, theoretical, micrometres
};
std::string_view quantityName(Quantity quantity);  ///< "diameter", "x", "true position", ...
std::optional<Quantity> quantityNamed(std::string_view name);
/// Whether the ideal is 0 and only the upper limit counts: position, form.
bool isZone(Quantity quantity);
bool isAngle(Quantity quantity);

struct Characteristic {
  Quantity quantity = Quantity::kDiameter;
  std::string part;                  ///< of a feature with several: "step of 12"; else empty
  std::vector<std::uint32_t> faces;  ///< indices of CadFaces that it is taken of, as its formula asks
  /// Where it is taken: the middle, and both ends of an axis.
  Vec3 at = Vec3::Zero(), from = Vec3::Zero(), to = Vec3::Zero();
  double nominal = 0.0;
  std::optional<double> measured;  ///< none: the part has too little of the feature
};

struct Feature {
  FeatureKind kind = FeatureKind::kPlane;
  std::string name;                  ///< for people: "blind hole of diameter 8 at X20.000 Y20.000"
  std::vector<std::uint32_t> faces;  ///< indices of CadFaces that are its own
  Vec3 at = Vec3::Zero();            ///< its middle, mm
  Box3 bounds;                       ///< of its faces
  bool missing = false;              ///< the part has no surface in place of most of it
  std::vector<Characteristic> characteristics;
};

}  // namespace proveout
