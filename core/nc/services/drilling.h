// Fixed drilling cycles as elementary steps on the drill axis. Tables: NCT milling manual 18 (digest
// nct-3, 6.2 and 6.3). The dialect keeps the modal data, moves to the hole (operation 1), then carries out
// the steps.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

enum class DrillCode {
  kChipBreak,         ///< G73: peck with a short pull-back
  kTapLeft,           ///< G74: left-hand tapping
  kFineBore,          ///< G76: oriented stop, shift, rapid out
  kDrill,             ///< G81
  kDrillDwell,        ///< G82
  kPeck,              ///< G83: peck with return to R
  kTap,               ///< G84
  kRigidTap,          ///< G84.2: synchronous, right-hand
  kRigidTapLeft,      ///< G84.3: synchronous, left-hand
  kBoreFeedOut,       ///< G85
  kBoreStop,          ///< G86: spindle stop, rapid out
  kBackBoreManual,    ///< G87 without oriented spindle: stop for the operator at the bottom
  kBackBore,          ///< G87 with oriented spindle: bores upwards, R is the deeper one
  kBoreManual,        ///< G88
  kBoreDwellFeedOut,  ///< G89
};

/// Everything a cycle needs at one hole. Coordinates on the drill axis, mm.
struct DrillCycle {
  DrillCode code = DrillCode::kDrill;
  double initial = 0.0;  ///< initial point
  double r = 0.0;        ///< approach point
  double bottom = 0.0;
  bool return_to_r = false;        ///< G99; false: G98, return to the initial point
  double peck = 0.0;               ///< Q, mm, > 0; 0: in one go
  double clearance = 0.0;          ///< E: pull-back of kChipBreak, approach clearance of kPeck, mm, >= 0
  bool tap_returns_to_r = false;   ///< pecking rigid taps: false as kChipBreak, true as kPeck
  double dwell = 0.0;              ///< P; seconds or turns as the dialect says; 0: none
  Vec2 shift = Vec2::Zero();       ///< I, J (plane u, v) of kFineBore and kBackBore, incremental, mm
  double retract_factor = 1.0;     ///< feed out / feed in of kBoreFeedOut, kBoreDwellFeedOut and rigid taps
  double tap_return_factor = 1.0;  ///< feed to R and back between the pecks of rigid taps / feed in
  bool orient_before_rigid_tap = false;  ///< oriented stop before a rigid tap rather than closing the loop
  // What other controls than nct do besides.
  double peck_less = 0.0;  ///< kChipBreak, kPeck: every peck is so much shorter than the one before, mm, >= 0
  double peck_least = 0.0;      ///< with it: no peck is shorter, mm
  double to_r_every = 0.0;      ///< kChipBreak: out to R each time so much depth is cut, mm; 0: never
  bool dwell_of_pecks = false;  ///< kChipBreak, kPeck: the dwell stands at the bottom
  bool dwell_of_back = false;   ///< kBackBore: the dwell stands at its bottom
  bool dwell_at_r = false;      ///< taps: the dwell stands at R again
  bool stops_at_r = false;      ///< kBoreManual: out to R first, then to the initial point
};

enum class DrillStepKind {
  kRapid,           ///< to `position` on the drill axis
  kFeed,            ///< to `position` at feed * feed_factor
  kShift,           ///< rapid by `shift` in the plane
  kDwell,           ///< `dwell`
  kSpindleForward,  ///< M3
  kSpindleReverse,  ///< M4
  kSpindleStop,     ///< M5
  kSpindleOrient,   ///< M19
  kCloseLoop,       ///< spindle to position control
  kProgramStop,     ///< M0, the operator moves by hand
};

struct DrillStep {
  DrillStepKind kind = DrillStepKind::kRapid;
  int operation = 0;          ///< 2..10 of the manual's table
  double position = 0.0;      ///< mm on the drill axis; also set, unchanged, for steps that do not move it
  Vec2 shift = Vec2::Zero();  ///< kShift: incremental, mm
  double feed_factor = 1.0;   ///< kFeed
  double dwell = 0.0;         ///< kDwell
  bool locked = false;        ///< overrides and stop have no effect (tapping)
  bool thread = false;        ///< synchronous with the spindle or in a tap: a threading motion
};

enum class DrillError {
  kNone,
  kNotFinite,     ///< a number is NaN or infinite
  kBadPeck,       ///< peck or clearance negative
  kBadRetract,    ///< retract factor not above 0
  kTooManySteps,  ///< the peck is so small that the cycle exceeds `kMaxDrillSteps`
};
inline constexpr std::size_t kMaxDrillSteps = 1000000;  ///< guards memory: 0.1 um pecks over 30 mm

/// Fills `steps` (cleared first, capacity kept) with what follows operation 1. On error `steps` is empty.
DrillError expandDrillCycle(const DrillCycle& cycle, std::vector<DrillStep>& steps);

}  // namespace proveout
