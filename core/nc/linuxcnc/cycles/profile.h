// The contour of G70, G71, G72: the motions of a subroutine.
#pragma once

#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/services/contour/contour_elements.h"

namespace proveout::nc {

/// A contour in (Z, X), radii, mm, program coordinates. The first element leads from where the cycle starts
/// to the begin of the contour.
struct LinuxCncProfile {
  PlaneContour elements;
  std::vector<double> fillets;   ///< A: radius of the corner behind each element, mm; 0: none
  std::vector<double> chamfers;  ///< C: of the corner behind each element, mm; 0: none

  void add(const ContourElement& e);
  Vec2 start() const { return elements.front().from; }
  Vec2 begin() const { return elements.front().to; }
  Vec2 end() const { return elements.back().to; }
};

/// The motions of the lines; `start`: (Z, X) of the cycle. False: reported.
bool readLinuxCncProfile(IsoContext& c, const BlockPlan& plan, const std::vector<LinuxCncContourLine>& lines,
                         const Vec2& start, LinuxCncProfile& out);
/// Cuts the corners as A and C of the lines say. A chamfer goes between the points that an arc of that radius
/// would touch. False: one does not fit, reported.
bool cutLinuxCncCorners(IsoContext& c, LinuxCncProfile& profile);

}  // namespace proveout::nc
