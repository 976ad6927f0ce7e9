// The contour of G70, G71, G72 as the cycles cut it.
#pragma once

#include "core/nc/linuxcnc/cycles/profile.h"

namespace proveout::nc {

/// From (Z, X) to (u, v) and back: u goes on along the contour, v is the height over the material.
class LcnRoughFrame {
 public:
  /// `depth`: the axis of (Z, X) that levels step along, 0: Z, 1: X. `way` and `side`, +1 or -1: where Z or
  /// X goes on, and where the tool is.
  LcnRoughFrame(int depth, double way, double side) : depth_(depth), way_(way), side_(side) {}

  Vec2 in(const Vec2& zx) const { return {way_ * zx[1 - depth_], side_ * zx[depth_]}; }
  Vec2 out(const Vec2& uv) const {
    Vec2 zx;
    zx[1 - depth_] = way_ * uv.x();
    zx[depth_] = side_ * uv.y();
    return zx;
  }
  ContourElement in(const ContourElement& e) const {
    return turned(e, [this](const Vec2& p) { return in(p); });
  }
  ContourElement out(const ContourElement& e) const {
    return turned(e, [this](const Vec2& p) { return out(p); });
  }

 private:
  template <class To>
  ContourElement turned(const ContourElement& e, To to) const {
    ContourElement other = e;
    other.from = to(e.from);
    other.to = to(e.to);
    other.center = to(e.center);
    const bool mirrored = way_ * side_ * (depth_ == 1 ? 1.0 : -1.0) < 0.0;
    if (mirrored) other.sweep = -e.sweep;
    return other;
  }

  int depth_;
  double way_, side_;
};

/// A contour in the frame that it is cut in.
struct LcnRoughContour {
  LcnRoughFrame frame;
  PlaneContour elements;  ///< (u, v); the first one leads to the begin of the contour
};

/// Does the contour behind its begin go one way along Z (0) or X (1)? Corners count as they are.
bool lcnGoesOneWay(const LinuxCncProfile& profile, int axis);
/// The contour with its corners cut. False: reported.
bool lcnRoughContour(IsoContext& c, LinuxCncProfile profile, int depth, std::optional<LcnRoughContour>& out);
/// Keeps the contour off by a distance, mm, towards the tool. False: reported.
bool lcnKeepOff(IsoContext& c, double distance, PlaneContour& elements);

}  // namespace proveout::nc
