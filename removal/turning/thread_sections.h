// Half sections of a part with its threads, at the angles that thread tools stand at.
#pragma once

#include <vector>

#include "removal/turning/section_area.h"

namespace proveout {

/// The outline of a thread's tool wherever it passes the half-plane at `angle`, rad.
std::vector<SectionPath> passesThrough(const ThreadSweep& thread, double angle);

/// Keeps the sections of a few angles, since the passes of a thread end at the same ones.
class ThreadSections {
 public:
  /// `section` less what `threads` cut at `angle`, rad. Both must be those of the calls before, but for
  /// threads that were added at the end and what cut() was told; else call clear() first. Valid up to the next call.
  const SectionArea& at(double angle, const SectionArea& section, const std::vector<ThreadSweep>& threads);
  /// The section has lost this; see SectionArea::subtract.
  void cut(const std::vector<SectionPath>& sweeps, MotionId motion, const std::vector<SectionPath>& spared);
  void clear();

 private:
  struct Known {
    double angle;
    std::size_t threads;  ///< so many have been cut
    std::size_t cuts;     ///< and so many of `cuts_`
    SectionArea area;
  };
  struct Cut {
    std::vector<SectionPath> sweeps;
    MotionId motion;
    std::vector<SectionPath> spared;
  };
  std::vector<Known> known_;
  std::vector<Cut> cuts_;  ///< of the section, since the first of `known_`
};

}  // namespace proveout
