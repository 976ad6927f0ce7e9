// The kinds of findings, and all that is told of a kind as such: one table, which the written reports, the
// checks of junit.xml and the documentation follow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"

namespace proveout {

/// In the order of their rows in docs/reference/report.md.
enum class FindingKind : std::uint8_t {
  kGouge,
  kExcess,
  kUndecided,
  kCharacteristic,
  kRapidContact,
  kShankContact,
  kHolderContact,
  kFixtureContact,
  kSpindleOff,
  kSpindleDirection,
  kInsertContact,
  kAxisCrossing,
  kCutOffPiece,
  kThreading,
  kWireSupply,
  kFreeSlug,
  kStuckSlug,
  kBridge,
  kNoseDeviation,
  kToolData,
  kFeedRate,
  kSpindleSpeed,
  kCycleTime,
  kDwell,
  kToolChange,
  kDrillSideways,
  kProgramUnit,
  kPartOff,
  kCoarseNominal,
  kNotCompared,
  kNominalPlacement,
  kOvertravel,
  kClampedAxis,
  kForbiddenZone,
  kAlarm,
  kNoPart,
  kThinFeature,
  kNothingCut,
  kLoosePiece,
  kUncertainPart,
  kPartial,
  kMesh,
  kOutput,
  kCount
};

/// The checks of a run, in the order of their test cases in junit.xml. kOwn: the kind has a case of its own
/// behind them, in runs where it was found.
enum class JunitCheck : std::uint8_t {
  kProgram,
  kOvertravel,
  kRapidContact,
  kShankContact,
  kHolderContact,
  kFixtureContact,
  kSpindle,
  kGouge,
  kExcess,
  kResolution,
  kMeshClosed,
  kOwn
};

struct FindingKindInfo {
  FindingKind kind;
  std::string_view name;     ///< in report.json: "rapid_contact"
  Severity severity;         ///< where the finding has no reason for another one
  JunitCheck check;          ///< that a finding of severity error fails
  bool deviation;            ///< it comes from the comparison with nominal: its place is on the finished part
  std::string_view meaning;  ///< with these words its row in docs/reference/report.md begins
};

/// A row a kind, in the order of the enumeration.
std::span<const FindingKindInfo> findingKinds();
const FindingKindInfo& findingKindInfo(FindingKind kind);
std::string_view findingKindName(FindingKind kind);  ///< "gouge", "rapid_contact", ...
bool isDeviation(FindingKind kind);
/// The kind of that name. Nothing: there is none.
std::optional<FindingKind> findingKindNamed(std::string_view name);
/// Names of all kinds.
std::vector<std::string> findingKindNames();
/// Kinds that say that a result is missing, or not whole: whoever turned them off, or took them as known,
/// would believe the rest.
bool isBinding(FindingKind kind);

/// The name of a check's test case, "rapid contact"; "" for kOwn.
std::string_view checkName(JunitCheck check);
/// The name of the test case that the kind belongs to: of kOwn the kind's own name.
std::string_view checkName(FindingKind kind);

}  // namespace proveout
