// Where time and material went: per tool, per block, and as a rate along the machining time.
#pragma once

#include <functional>
#include <vector>

#include "core/path/toolpath.h"
#include "io/report.h"

namespace proveout {

/// A tool path and what each of its motions removed.
struct CutPath {
  std::string setup;  ///< name of the clamping; empty in a job without setups
  const Toolpath* path = nullptr;
  const std::vector<float>* removed_mm3 = nullptr;  ///< per motion; missing entries count as 0
  bool part_turns = false;      ///< the part turns: an edge goes round it on helices and spirals
  double wire_height_mm = 0.0;  ///< of the workpiece where a wire cuts it; 0: another process
};

/// How far the edge of a turning tool goes through the material while the part turns, mm: on a helix or
/// spiral at the mean radius of the chip, so that the removed volume over it is the section of the chip. The
/// length of the motion where the spindle stands, and of motions that take no time.
double lengthOfCut(const Toolpath& path, const Motion& motion, double removed_mm3);

/// Whether a motion of that length that removed so much has cut, and not only followed what it made before.
bool isChip(double removed_mm3, double length_mm);

/// Totals, the table of tools and the rate series. A dwell or tool change counts for the tool of the motion
/// that follows it. Paths follow each other in time.
ReportAccounting accountFor(const std::vector<CutPath>& paths);

/// Calls `row` for every execution of a block, in order: unbroken runs of motions and events that one block
/// made. `start_s` is the time of the path's start.
void forEachBlock(const CutPath& cut, double start_s, const std::function<void(const BlockFigures&)>& row);

}  // namespace proveout
