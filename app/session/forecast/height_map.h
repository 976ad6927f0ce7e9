// A coarse height map of what a path leaves, from which a run's work is told before it is run.
#pragma once

#include <vector>

#include "core/geometry/types.h"
#include "core/tool/tool.h"

namespace proveout {

/// How high a tool stands over its tip: flat, then round, then straight.
struct Footprint {
  double radius = 0.0;       ///< mm; of the widest place
  double flat_radius = 0.0;  ///< mm
  double corner = 0.0;       ///< mm; radius of the round that follows
  double corner_end = 0.0;   ///< mm from the axis
  double rise = 0.0;         ///< behind it, mm a mm of radius

  /// Over the tip, mm, at the square of a distance from the axis.
  double heightAt2(double distance2) const;
};

/// What a spot was cut by, for how many triangles stay of it.
struct CutBy {
  float bend = 0.0F;     ///< 1 / mm: one over the tool's radius; 0: a flat end on a line leaves a plane
  float faces = 1.0F;    ///< so many times the surface that shows from above
  bool ruled = false;    ///< by a line that is long for its tool
  bool stepped = false;  ///< by the rim of a flat end on a short line that is not level: terraces
};

/// What is cut but level floors, mm2.
struct CutAreas {
  double all_mm2 = 0.0;
  double flat_mm2 = 0.0;     ///< of that by flat ends on long lines
  double ruled_mm2 = 0.0;    ///< and by other tools on long lines
  double stepped_mm2 = 0.0;  ///< of the rest: by rims of flat ends on short lines that are not level
  double bends_mm = 0.0;     ///< and of all of it: area over the radius of the tool
};

/// Of the part of a tool below its widest place. Tools that are wider below than above count as flat.
Footprint footprintOf(const Tool& tool);

/// Lowest point that the tools reach over each cell in plan view.
class HeightMap {
 public:
  static constexpr int kBands = 16;  ///< that threads may fill at the same time

  /// `cell`: mm.
  HeightMap(const Box3& blank, double cell);

  /// Whether the columns from `x_min` to `x_max`, mm, touch the band.
  bool touches(double x_min, double x_max, int band) const {
    return column(x_min) < firstOf(band + 1) && column(x_max) >= firstOf(band);
  }
  /// Lowers what lies within reach of the segment (plan view) to the height of the tool on its nearest point,
  /// in this band of columns.
  void lower(const Vec3& a, const Vec3& b, const Footprint& tool, const CutBy& made, int band);

  /// What cutting adds to the surface of the blank, mm2: slopes and walls more than the flat top that is
  /// gone; where all is cut through, top and bottom are gone.
  double addedArea() const;
  /// What is cut but level floors: slopes and walls. These are of what cut the lower side.
  CutAreas cutAreas() const;
  /// Area in plan view of ridges and grooves, mm2: where the surface rises or falls to both sides and bends,
  /// so that its triangles stay small. Feet of walls are none, nor what lines leave that are long for their
  /// tool.
  double unevenArea() const;

 private:
  int firstOf(int band) const { return nx_ * band / kBands; }
  int column(double x) const;
  int row(double y) const;
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(ny_) + static_cast<std::size_t>(y);
  }

  /// Of one column of cells.
  CutAreas cutOf(int x) const;

  Box3 blank_;
  double cell_;
  int nx_ = 1, ny_ = 1;
  std::vector<double> height_;
  std::vector<CutBy> made_;  ///< by what each cell was lowered last
};

}  // namespace proveout
