#include "removal/compare/part/part_feature.h"

namespace proveout {

bool isOfPart(Quantity quantity) {
  switch (quantity) {
    case Quantity::kThickness:
    case Quantity::kInnerRadius:
    case Quantity::kSkin:
    case Quantity::kScallop:
    case Quantity::kRoughness:
      return true;
    default:
      return false;
  }
}

}  // namespace proveout
