// The last stage of a path: how long each motion takes, with look-ahead over speeds.
//
// Motions wait here until what follows can no longer change their speeds; whatever else comes along meanwhile
// keeps its place between them. Without limits of acceleration nothing waits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/nc/control/run_summary.h"
#include "core/nc/kinematics/feed_limits.h"
#include "core/nc/services/bell_profile.h"
#include "core/nc/services/speed_plan.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// Slow stretches at inside corners (G62).
struct CornerSlowdown {
  double before = 0.0, after = 0.0;  ///< mm along the path
  double factor = 1.0;               ///< of the feed, above 0
  double angle_deg = 0.0;            ///< corners with a smaller angle between their sides
};

/// How one motion joins its neighbours.
struct MotionJoin {
  bool stops = false;     ///< stands still at its end (G9, G61, rapids)
  bool unbroken = false;  ///< no slow-down between blocks (G63)
  int inside = 0;  ///< G62 with cutter compensation: +1 corners to the left are inside, -1 to the right
  Vec3 normal = Vec3::UnitZ();  ///< of the plane, machine frame, where `inside` counts
};

class TimeStage {
 public:
  /// Motions that are looked ahead over; twice as many wait at most.
  static constexpr std::size_t kWindow = 512;

  /// Both must outlive the stage.
  TimeStage(MotionSink& sink, InterpretSummary& summary) : sink_(sink), summary_(summary) {}

  void configure(const MotionLimits& limits, int axes);
  const MotionLimits& limits() const { return limits_; }
  void setCornerSlowdown(const CornerSlowdown& slowdown) { slowdown_ = slowdown; }

  /// Whether motions with such a join need their pace; without it their time_s is final.
  bool wantsPace(const MotionJoin& join) const {
    return limits_.accelerations || join.inside != 0 || !waiting_.empty();
  }
  /// A motion whose time_s is final. Nothing may be waiting.
  void pass(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
    count(motion);
    sink_.motion(motion, arc, axis);
  }
  /// A motion to be timed.
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis, MotionPace pace,
              const MotionJoin& join);
  /// An event; `stands`: the axes stand still for it.
  void event(PathEvent event, bool stands);
  void diagnostic(const Diagnostic& diagnostic);
  /// Everything out; the axes come to a stand.
  void flush();

  /// Time until the last motion that came in has ended, at least: what waits counts as if nothing slowed it
  /// down. Never falls.
  double reached_s() const { return summary_.cycle_s + least_s_; }
  /// Times since the start if the axes came to a stand now. Changes no plan.
  struct Elapsed {
    double cycle_s, cutting_s;
  };
  Elapsed elapsed() const;

 private:
  struct Waiting {
    Motion motion;
    ArcGeometry arc;
    AxisSweep axis;
    bool has_arc = false, has_axis = false;
    double least_s = 0.0;  ///< time without accelerations
  };
  /// A stretch of a waiting motion.
  struct Stretch {
    SpeedElement element;
    std::uint32_t motion = 0;  ///< index into waiting_
    bool corner = false;       ///< may be slowed down at corners
    bool slow = false;         ///< is
  };
  struct Aside {
    std::size_t before = 0;  ///< index into waiting_
    std::optional<PathEvent> event;
    std::optional<Diagnostic> diagnostic;
  };

  void count(const Motion& motion);
  double entrySpeed(const MotionPace& pace, const MotionJoin& join) const;
  bool insideCorner(const MotionPace& pace, const MotionJoin& join) const;
  void addStretches(const MotionPace& pace, const MotionJoin& join, double entry);
  void slowBefore();
  void slowDown(Stretch& stretch) const;
  void emit(std::size_t motions);
  std::size_t timeByPlan(std::size_t motions);
  void timeByBell(std::size_t motions);
  void planStretches();
  void holdSpeeds();
  void hold(std::size_t boundary, double speed, bool before, bool behind);
  void send(std::size_t motions);
  const std::vector<SpeedElement>& elements() const;
  Elapsed elapsedByBell() const;

  MotionSink& sink_;
  InterpretSummary& summary_;
  MotionLimits limits_;
  CornerSlowdown slowdown_;
  int axes_ = kMainAxes;

  std::vector<Waiting> waiting_;
  std::vector<Stretch> stretches_;
  std::vector<Aside> asides_;
  double least_s_ = 0.0;    ///< of all that wait
  double entry_ = 0.0;      ///< speed where the first stretch begins, mm/s
  double slow_left_ = 0.0;  ///< of the stretch behind the last inside corner, mm
  bool moving_ = false;     ///< a motion ended without a stop
  MotionPace last_;
  MotionJoin last_join_;
  BellProfile bell_;
  double bell_time_ = 0.0;  ///< when the last motion that was sent arrived, in bell_
  mutable std::vector<SpeedElement> elements_;
  mutable std::vector<double> speeds_;
};

}  // namespace proveout::nc
