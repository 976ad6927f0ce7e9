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
  /// threads that were added at the end; else call clear() first. Valid up to the next call.
  const SectionArea& at(double angle, const SectionArea& section, const std::vector<ThreadSweep>& threads);
  void clear() { known_.clear(); }

 private:
  struct Known {
    double angle;
    std::size_t threads;  ///< so many have been cut
    SectionArea area;
  };
  std::vector<Known> known_;
};

}  // namespace proveout
