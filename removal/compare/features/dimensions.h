// The value that a characteristic has on given faces: those of the model, or those that fit the part.
#pragma once

#include <functional>

#include "removal/compare/features/feature.h"

namespace proveout {

/// A face by its index.
using FaceAt = std::function<const CadFace&(std::uint32_t)>;

/// mm, degrees for angles. None: the faces do not meet as the quantity asks (an axis that runs along its
/// plane). Formulas by quantity, with the faces f0, f1, ...:
/// kDiameter, kRadius: of f0. kConeDiameter: of the cone f0 on the plane f1. kX, kY, kZ: of the axis or the
/// centre of f0 at `at`, of the plane f0, or the middle between the planes f0 and f1 there. kOffset: the same
/// along the model's normal `to - from`, from `at`. kPosition: see positionOf. kDepth: along the axis of f0
/// from f1 to f2, both as a plane or a round end; with two faces as kHeight. kHeight, kWidth, kLength:
/// between the planes f0 and f1 at `at`, along the model's normal `to - from`. kAngle: of the cone f0; of the
/// normal of the plane f0 to Z. kPerpendicularity: of the axis f0, from `from` to `to`, to the plane f1.
std::optional<double> valueOf(const Characteristic& c, const FaceAt& face);

/// Diameter of the zone around the model's axis, from `from` to `to`, or centre `at`, that holds the other
/// one.
double positionOf(const Characteristic& c, const CadFace& model, const CadFace& fitted);

}  // namespace proveout
