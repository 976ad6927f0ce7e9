// Half sections of a part with its threads, at the angles that thread tools stand at.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "removal/turning/section/section_area.h"

namespace proveout {

/// The outline of a thread's tool wherever it passes the half-plane at `angle`, rad.
std::vector<SectionPath> passesThrough(const ThreadSweep& thread, double angle);

/// Keeps the sections of a few angles, since the passes of a thread end at the same ones.
class ThreadSections {
 public:
  /// `section` less what `threads` cut at `angle`, rad, as far as `asked` can meet it: what lies farther off
  /// is left out. `section` and `threads` must be those of the calls before, but for threads that were added
  /// at the end and what cut() was told; else call clear() first. Valid up to the next call.
  const SectionArea& at(double angle, const std::vector<SectionPath>& asked, const SectionArea& section,
                        const std::vector<ThreadSweep>& threads);
  /// The section has lost this; see SectionArea::subtract.
  void cut(const std::vector<SectionPath>& sweeps, MotionId motion, const std::vector<SectionPath>& spared);
  void clear();

 private:
  /// Bounds in the plane (r, z), mm.
  using Window = Eigen::AlignedBox2d;
  struct Known {
    double angle;
    Window window;        ///< nothing outside is known
    std::size_t threads;  ///< so many have been cut
    std::size_t cuts;     ///< and so many of `cuts_`
    SectionArea area;
  };
  struct Cut {
    std::vector<SectionPath> sweeps;
    MotionId motion;
    std::vector<SectionPath> spared;
  };
  static Known within(double angle, const Window& window, const SectionArea& section);

  std::vector<Known> known_;
  std::vector<Cut> cuts_;  ///< of the section, since the first of `known_`
};

}  // namespace proveout
