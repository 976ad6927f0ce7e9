// The way that a program has counted already and the machine has not gone.
#pragma once

#include <bitset>

#include "core/geometry/types.h"

namespace proveout::nc {

/// A length offset whose axis has not moved since (G43 alone), or a plane that was turned about a point away
/// from the tool (G68, G69): the machine stands, and goes there with what the program says next.
struct HeldWay {
  Vec3 way = Vec3::Zero();  ///< X, Y, Z in program coordinates: where the program counts, minus the machine
  std::bitset<3> axes;      ///< that wait
  bool any() const { return axes.any(); }
  std::bitset<3> in_steps;   ///< of these: steps (G91) go it too; the others wait for an absolute word
  std::bitset<3> of_length;  ///< of these: they wait for a word of their own, whatever the plane does
};

}  // namespace proveout::nc
