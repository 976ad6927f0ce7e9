// Sends what the wire does to the path, with its times, and counts it.
#pragma once

#include "core/nc/control/control_settings.h"
#include "core/nc/control/run_summary.h"
#include "core/nc/services/contour/contour_corner.h"
#include "core/nc/wedm/wedm_parameters.h"
#include "core/path/toolpath.h"

namespace proveout::nc {

/// How a motion goes, besides where.
struct WedmPace {
  bool rapid = false;
  bool slow_end = false;  ///< G34: slower in the last 3 mm
  bool compensated = false;
  WireState wire;
  int condition = 0;
  SourceRef source;
};

class WedmOutput {
 public:
  /// All must outlive the output.
  WedmOutput(MotionSink& sink, InterpretSummary& summary, const ControlSettings& settings,
             const WedmParameters& parameters)
      : sink_(sink), summary_(summary), settings_(settings), parameters_(parameters) {}

  /// The tracks in the main and in the secondary plane, workpiece frame. Nothing is sent where both stand.
  void move(const ContourElement& main, const ContourElement& second, const WedmPace& pace);
  void event(EventKind what, double time_s, const SourceRef& source);
  /// Largest lean during the motion, radians.
  double tilt(const ContourElement& main, const ContourElement& second) const;

 private:
  double rapidTime(const ContourElement& main, const ContourElement& second) const;
  void checkTravel(const ContourElement& main, const ContourElement& second, const SourceRef& source);

  MotionSink& sink_;
  InterpretSummary& summary_;
  const ControlSettings& settings_;
  const WedmParameters& parameters_;
};

}  // namespace proveout::nc
