// What the recognisers share: how faces lie to each other, names, characteristics.
#pragma once

#include <string>
#include <vector>

#include "removal/compare/features/dimensions.h"
#include "removal/compare/features/face_network.h"
#include "removal/compare/features/recognition.h"

namespace proveout {

/// What is being recognised: the network, and which faces belong to a feature already.
struct FeatureSearch {
  FeatureSearch(const FaceNetwork& of, const FaceAccuracy& how)
      : network(of), accuracy(how), taken(of.size(), false) {}
  const FaceNetwork& network;
  const FaceAccuracy& accuracy;
  std::vector<bool> taken;
  std::vector<Feature> features;

  const CadFace& face(std::uint32_t f) const { return network.face(f); }
  bool parallel(const Vec3& a, const Vec3& b) const { return a.cross(b).norm() <= accuracy.near_rad; }
  bool across(const CadFace& plane, const Vec3& axis) const {
    return plane.kind == SurfaceKind::kPlane && parallel(plane.axis, axis);
  }
  /// Whether the round face turns about the line.
  bool coaxial(const CadFace& round, const Vec3& origin, const Vec3& axis) const;
  /// Takes the faces and fills in nominal values; characteristics without one are dropped.
  void add(Feature feature);
};

/// The axis of the frame that a direction is along; -1: none.
int frameAxis(const Vec3& direction);
/// What tells the place of a plane with that normal: x, y, z, or its offset.
Quantity placeQuantity(const Vec3& normal);
/// "X20.000 Y5.000": the coordinates across the axis, or all three where it is none of the frame's.
std::string placeText(const Vec3& at, const Vec3& axis);
/// x, y, z of a round's axis or centre across the frame's axes, at `at`, and its true position.
void addPlace(std::uint32_t face, const std::string& part, const Characteristic& where, const CadFace& round,
              std::vector<Characteristic>& out);

/// The plane that a round comes out of at an outer edge, or by a round of that edge, and that looks
/// `outwards`; kNoFace: there is none.
std::uint32_t outerPlane(const FeatureSearch& search, std::uint32_t round, const Vec3& outwards);

/// Recognisers, in the order in which they have to come.
void findHoles(FeatureSearch& search);
void findBosses(FeatureSearch& search);
void findPockets(FeatureSearch& search);
void findSlots(FeatureSearch& search);
void findSingleFaces(FeatureSearch& search);

}  // namespace proveout
