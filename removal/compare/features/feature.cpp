#include "removal/compare/features/feature.h"

#include <algorithm>
#include <array>

namespace proveout {
namespace {

constexpr std::array<std::string_view, 8> kKinds = {"hole",  "boss", "pocket", "slot",
                                                    "plane", "cone", "sphere", "fillet"};
constexpr std::array<std::string_view, 22> kQuantities = {"diameter",
                                                          "cone diameter",
                                                          "radius",
                                                          "x",
                                                          "y",
                                                          "z",
                                                          "position",
                                                          "offset",
                                                          "depth",
                                                          "height",
                                                          "width",
                                                          "length",
                                                          "angle",
                                                          "perpendicularity",
                                                          "flatness",
                                                          "cylindricity",
                                                          "form",
                                                          "wall thickness",
                                                          "inner radius",
                                                          "unmachined area",
                                                          "scallop height",
                                                          "roughness"};

template <typename Names>
std::optional<std::size_t> placeIn(const Names& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

std::string_view featureKindName(FeatureKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

std::optional<FeatureKind> featureKindNamed(std::string_view name) {
  const auto place = placeIn(kKinds, name);
  return place ? std::optional(static_cast<FeatureKind>(*place)) : std::nullopt;
}

std::string_view quantityName(Quantity quantity) { return kQuantities[static_cast<std::size_t>(quantity)]; }

std::optional<Quantity> quantityNamed(std::string_view name) {
  const auto place = placeIn(kQuantities, name);
  return place ? std::optional(static_cast<Quantity>(*place)) : std::nullopt;
}

bool isZone(Quantity quantity) {
  switch (quantity) {
    case Quantity::kPosition:
    case Quantity::kPerpendicularity:
    case Quantity::kFlatness:
    case Quantity::kCylindricity:
    case Quantity::kForm:
    case Quantity::kSkin:
    case Quantity::kScallop:
    case Quantity::kRoughness:
      return true;
    default:
      return false;
  }
}

bool isAngle(Quantity quantity) { return quantity == Quantity::kAngle; }

}  // namespace proveout
