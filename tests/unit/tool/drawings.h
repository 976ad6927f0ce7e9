// Tools of every type with their outlines as drawn: dense polylines from textbook formulas, which know
// nothing of profiles.
#pragma once

#include <string>
#include <vector>

#include "core/tool/tool_solid.h"

namespace proveout::test {

struct Drawing {
  std::string name;
  Tool tool;
  /// (r, z) from the tip to the end of the cutting part, without the flat ends on the axis.
  std::vector<Vec2> outline;
  double hollow = 0.0;  ///< mm by which the tool may be thicker: simplified hollow arcs

  /// Radius at height z; 0 <= z <= the last z. At a step the larger one.
  double radiusAt(double z) const;
  /// Distance of (r, z) from the surface, flat ends included, mm >= 0.
  double surfaceDistance(double r, double z) const;
  double volume() const;  ///< mm3, of the frustums of the outline
};

/// One or two tools of each type, arcs drawn with `steps` chords a quarter turn. Numbers from 1 up.
std::vector<Drawing> drawings(int steps);

}  // namespace proveout::test
