// What the wire is to do, kept back until it is known how the corners go: contours of both planes, offsets,
// taper (digest wedm, D2.5).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/nc/services/wire_offset.h"
#include "core/nc/services/wire_taper.h"
#include "core/nc/wedm/wedm_output.h"
#include "core/nc/wedm/wedm_report.h"

namespace proveout::nc {

/// A programmed motion. Lengths mm, workpiece frame.
struct WedmRecord {
  ContourElement main;    ///< in the main plane
  ContourElement second;  ///< in the secondary plane, without the lean of a taper
  double offset = 0.0;    ///< signed, to the left
  bool offset_on = false;
  bool starts_offset = false;  ///< the first motion with it
  double lean = 0.0;           ///< of the taper in the secondary plane, signed, to the left
  bool taper_on = false;
  OuterJoin outer = OuterJoin::kArc;
  double extension = 0.0, overcut = 0.0, overcut_dwell = 0.0;  ///< mm, s
  double round = 0.0;                                          ///< radius of the corner behind it; 0: none
  std::optional<double> round_2;                               ///< of the secondary plane
  WedmPace pace;
  Columns columns;  ///< of the block

  struct Event {
    EventKind what;
    double time_s = 0.0;
    SourceRef source;
  };
  std::vector<Event> events;  ///< behind it

  bool plain() const { return !offset_on && !taper_on; }
};

class WedmChain {
 public:
  /// All must outlive the chain.
  WedmChain(WedmOutput& output, WedmReport& report, const WedmParameters& parameters)
      : output_(output), report_(report), parameters_(parameters) {}

  /// False: an error was reported, and what was kept back is dropped.
  bool add(WedmRecord record);
  void event(EventKind what, double time_s, const SourceRef& source);
  /// G92 while an offset is on: the last motion takes it off, the next one builds it up again.
  void interruptOffset();
  /// Sends all of it. False: an error was reported.
  bool flush();
  /// Motions that are kept back.
  std::size_t kept() const { return records_.size(); }

 private:
  /// More would fill the memory.
  static constexpr std::size_t kMostKept = 300'000;

  WedmOutput& output_;
  WedmReport& report_;
  const WedmParameters& parameters_;
  std::vector<WedmRecord> records_;
  bool offset_before_ = false;  ///< the last motion had the offset on
};

}  // namespace proveout::nc
