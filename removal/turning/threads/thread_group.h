// Thread passes whose tools go side by side: all the layers and steps of one start of a worm.
#pragma once

#include <cstddef>
#include <vector>

#include "removal/turning/section/section_area.h"

namespace proveout {

/// Numbers of passes that begin, turn and move alike, so that at any time their tools stand beside each other
/// as they began; each pass is in one group, groups and passes in their order.
std::vector<std::vector<std::size_t>> threadGroups(const std::vector<ThreadSweep>& threads);

/// What the outlines of a group have in common with a band of radii, the first pass of the group being at its
/// start. Exact as sections are: outlines are chords, coordinates nanometres.
class GroupOutline {
 public:
  /// All of the outlines.
  GroupOutline(const std::vector<ThreadSweep>& threads, const std::vector<std::size_t>& group);
  /// Only what lies between two radii, mm.
  GroupOutline(const std::vector<ThreadSweep>& threads, const std::vector<std::size_t>& group, double low,
               double high);

  /// Adds the outline of the group's k-th pass. Whether that made the union larger.
  bool add(std::size_t k);
  /// Borders of the union, counter-clockwise about it, and clockwise of what is free inside of it, seen from
  /// the first pass's control point. The motion of an edge is the k that it was added with.
  std::vector<SectionLoop> borders() const;
  /// By k: whether the pass has an edge of the union's border within the band.
  std::vector<bool> onBorder() const;

 private:
  void makeBox(double low, double high);

  std::vector<SectionPath> outlines_;  ///< placed in the box
  Vec2 shift_ = Vec2::Zero();          ///< from the first control point to the box
  SectionArea left_;                   ///< of the box, which all of the union lies in
};

/// The numbers k of the passes that make the union of the group in the band; the others leave it as it is.
std::vector<std::size_t> passesThatCount(const std::vector<ThreadSweep>& threads,
                                         const std::vector<std::size_t>& group, double low, double high);

}  // namespace proveout
