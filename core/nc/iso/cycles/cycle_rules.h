// Drilling cycles as the makers have them: what their words mean, and what a control adds to the steps of a
// hole. planCycle() goes by the rules of nct; a control with others has a plan function of its own that hands
// them to planCycleBy().
#pragma once

#include "core/nc/iso/context/context.h"

namespace proveout::nc {

/// The defaults are nct's.
struct CycleRules {
  /// What a block without the level R does where the cycle has none yet.
  enum class NoLevel : std::uint8_t {
    kAlarm,
    kTold,  ///< the level is the start level, and a note says so
    kTaken  ///< the same without a note
  };

  AddressSet repeats = "L";    ///< say how many times; 0 keeps the words only
  AddressSet more_words = {};  ///< further words that the cycles read: they are not told as unused
  bool r_names_hole = false;   ///< R alone drills where the tool stands
  bool signed_peck = false;    ///< Q may be negative: `finish` says what it means
  bool percent_by_i = true;    ///< I of feed-out cycles and rigid taps: the feed out, percent of the feed in
  bool functions_first = false;  ///< M codes run before the way to the first hole; false: behind it
  NoLevel no_level = NoLevel::kAlarm;
  /// Name of the error of a cycle without a bottom; null: the shared alarm.
  const char* no_bottom = nullptr;

  /// What the cycle in force does at a hole. Null: by the code alone.
  DrillCode (*code)(const IsoContext&, const BlockPlan&) = nullptr;
  /// Seconds of a dwell P, and the name of the error if it is none. Null: the value counts seconds.
  bool (*dwell)(IsoContext&, const Word& p, double& seconds) = nullptr;
  /// In place of the checks of nct's parameters. False: reported.
  bool (*check)(IsoContext&, const BlockPlan&, DrillCode) = nullptr;
  /// The last word on the data of a hole. False: reported.
  bool (*finish)(IsoContext&, const BlockPlan&, DrillCycle&) = nullptr;
};

/// A block of a drilling cycle. `rules` must live as long as the process. False: reported.
bool planCycleBy(IsoContext& c, BlockPlan& plan, const CycleRules& rules);
/// A block whose holes are the points that the caller has put into c.hole_points (the plane's axes count);
/// words that the caller has claimed are not the cycle's. False: reported.
bool planCycleAtPoints(IsoContext& c, BlockPlan& plan, const CycleRules& rules);

}  // namespace proveout::nc
