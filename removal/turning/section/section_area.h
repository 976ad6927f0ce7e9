// Polygons of a half section with exact set operations, each edge knowing the motion that made it.
// Coordinates are rounded to nanometres once; what follows is integer arithmetic that closes every polygon.
#pragma once

#include <memory>
#include <vector>

#include "removal/turning/section/section.h"

namespace proveout {

/// A closed polygon in the plane (r, z), mm.
using SectionPath = std::vector<Vec2>;

/// A piece of a section without edge labels.
struct SectionPiece {
  SectionPath outline;
  double volume_mm3 = 0.0;    ///< of the solid of revolution, of the outline alone
  double thickness_mm = 0.0;  ///< area over half of the perimeter: about the mean width of a long piece
};

class SectionArea {
 public:
  SectionArea();
  explicit SectionArea(const std::vector<SectionLoop>& loops);
  ~SectionArea();
  SectionArea(const SectionArea&);
  SectionArea& operator=(const SectionArea&);
  SectionArea(SectionArea&&) noexcept;
  SectionArea& operator=(SectionArea&&) noexcept;

  bool empty() const;
  Vec2 min() const;  ///< of the bounds; of an empty area 0
  Vec2 max() const;
  double volume() const;  ///< mm3, of the solid of revolution
  std::size_t points() const;

  /// Takes the union of `sweeps` (non-zero winding), less the union of `spared`, away; edges that this makes
  /// belong to `motion`. Returns the volume taken, mm3. What is thinner than 0.1 micrometres everywhere is
  /// rounding and stays.
  double subtract(const std::vector<SectionPath>& sweeps, MotionId motion,
                  const std::vector<SectionPath>& spared = {});
  /// The same for many sweeps, a few at a time: sets of overlapping polygons cost the square of their number.
  double subtractMany(const std::vector<SectionPath>& sweeps, MotionId motion);
  /// False where the sweeps surely have nothing in common with the area; quicker than common().
  bool mayMeet(const std::vector<SectionPath>& sweeps) const;
  /// What the union of `sweeps`, less the union of `spared`, has in common with the area.
  std::vector<SectionPiece> common(const std::vector<SectionPath>& sweeps,
                                   const std::vector<SectionPath>& spared = {}) const;
  /// Distance of a point to the nearest edge, mm.
  double depthOf(const Vec2& p) const;

  /// Whether it has more than one border.
  bool apart() const;
  /// The connected pieces, each with its border first and then its hollows, from low z to high z; of
  /// equally low ones the larger first. Pieces thinner than 0.1 micrometres are rounding and left out.
  std::vector<SectionBody> bodies() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proveout
