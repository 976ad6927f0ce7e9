// Half sections of a part with threads at one angle after the other. Each edge knows what it lies on, so that
// a corner is found again in the section beside.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "removal/turning/section/section_area.h"

namespace proveout::thread_detail {

/// What an edge lies on: a run of the border or of a thread tool's outline, straight within the tolerance.
struct EdgeName {
  static constexpr std::int32_t kSection = -1;
  std::int32_t sweep = kSection;
  std::int32_t turn = 0;  ///< of the sweep: whole turns about Z at angle 0; of the section 0
  std::int32_t run = 0;
  auto operator<=>(const EdgeName&) const = default;
};

/// Where edges of two names meet, (r, z) in mm.
struct Corner {
  Vec2 at;
  EdgeName in, out;
  std::uint32_t vertex = 0;  ///< for who makes a mesh of it
};
using CornerLoop = std::vector<Corner>;  ///< material on its left

struct Slice {
  std::vector<CornerLoop> loops;
  double taken_mm3 = 0.0;    ///< by the threads, of the solid of revolution that has this section
  double left_out_mm = 0.0;  ///< thickness of the thickest loop that was left out
  bool sound = true;         ///< false: a loop has too few corners to make a surface of
};

/// An angle at which a tool, or a group of passes, stands where its way begins or ends: beyond it a pass is
/// there or is not.
struct PassEnd {
  double phi;  ///< in [0, 2 pi), rad
  std::int32_t sweep, turn;
  bool appears;  ///< towards larger angles
};

class ThreadSlicer {
 public:
  /// `tolerance`: corners that a border or an outline does not need within as much are left out, mm; loops
  /// beside the largest one no thicker than `thinnest` mm (area over half of the perimeter) too.
  ThreadSlicer(const SectionBody& body, const std::vector<ThreadSweep>& threads, double tolerance,
               double thinnest);

  /// By angle; ends that lie together within 1e-4 rad have one angle.
  const std::vector<PassEnd>& ends() const { return ends_; }
  /// The section at `phi` in [0, 2 pi); `ends`: those at this angle, of which the first `passed` lie behind.
  Slice slice(double phi, std::span<const PassEnd> ends = {}, std::size_t passed = 0) const;
  /// The motion that made an edge.
  MotionId motionOf(const EdgeName& name) const;

 private:
  /// A pass, or passes that go together as one whose outline is the union of theirs.
  struct Sweep {
    ThreadSweep thread;             ///< the first pass; its outline is not kept
    double start, turn;             ///< rad
    std::vector<Vec2> outline;      ///< chords, counter-clockwise
    std::vector<std::int32_t> run;  ///< of the chord from a point to the next
    std::vector<MotionId> made_by;  ///< by run
    Vec2 low, high;                 ///< of the outline

    double partAt(double phi, std::int32_t turns) const { return (phi + 2.0 * kPi * turns - start) / turn; }
  };
  struct Pass {
    std::int32_t turn;
    Vec2 at;
  };

  void addGroup(const std::vector<ThreadSweep>& threads, const std::vector<std::size_t>& group,
                double tolerance);
  void addPass(const ThreadSweep& thread, double tolerance);
  /// `outline`: seen from the control point of `thread`, counter-clockwise, with the motion of each chord.
  void addSweep(const ThreadSweep& thread, const SectionLoop& outline, double tolerance);
  void addEnds(std::int32_t sweep);
  void leaveOutThin(Slice& slice) const;
  bool reaches(const Sweep& sweep, const Vec2& at) const;
  std::vector<Pass> passes(std::int32_t sweep, double phi, std::span<const PassEnd> ends,
                           std::size_t passed) const;
  /// What the middle of an edge of the sweep's groove lies on. `hint`: pass and chord of the edge before.
  struct Hint {
    std::size_t pass = 0, chord = 0;
  };
  EdgeName nameOf(const Vec2& middle, std::int32_t sweep, const std::vector<Pass>& passes, Hint& hint) const;

  double thinnest_;
  SectionArea section_;            ///< its edges are labelled by their numbers
  std::vector<std::int32_t> run_;  ///< of the edges, by number
  std::vector<MotionId> of_run_;   ///< motion of each run
  std::vector<Sweep> sweeps_;
  std::vector<PassEnd> ends_;
};

}  // namespace proveout::thread_detail
