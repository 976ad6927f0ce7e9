#include "io/finding_kind.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"

namespace proveout {

namespace {

constexpr std::size_t kKinds = static_cast<std::size_t>(FindingKind::kCount);

using enum FindingKind;
using enum Severity;
using Check = JunitCheck;

constexpr std::array<FindingKindInfo, kKinds> kRows{{
    {kGouge, "gouge", kError, Check::kGouge, true, "the part lies below nominal by more than its tolerance"},
    {kExcess, "excess", kError, Check::kExcess, true,
     "the part lies above nominal by more than its tolerance"},
    {kUndecided, "undecided", kWarning, Check::kResolution, true,
     "a deviation so close to its tolerance that the grid, or the facets of the nominal, cannot tell"},
    {kCharacteristic, "characteristic", kError, Check::kOwn, true,
     "a dimension of a feature is outside of its tolerance, or cannot be measured"},
    {kRapidContact, "rapid_contact", kError, Check::kRapidContact, false, "the tool touched stock in rapid"},
    {kShankContact, "shank_contact", kError, Check::kShankContact, false, "the shank touched stock"},
    {kHolderContact, "holder_contact", kError, Check::kHolderContact, false, "the holder touched stock"},
    {kFixtureContact, "fixture_contact", kError, Check::kFixtureContact, false,
     "the tool, its shank or its holder touched a fixture"},
    {kSpindleOff, "spindle_off", kError, Check::kSpindle, false, "stock was cut with a standing spindle"},
    {kSpindleDirection, "spindle_direction", kError, Check::kSpindle, false,
     "a cutter was turned against its hand"},
    {kInsertContact, "insert_contact", kError, Check::kOwn, false,
     "a side of a lathe insert that does not cut in that direction ran into the part, or a blade or a tooth "
     "went in deeper than its `edge_length`"},
    {kAxisCrossing, "axis_crossing", kError, Check::kOwn, false,
     "an insert went past the spindle axis and took material on the other side, or a drill or mill cut a "
     "turning part off the axis"},
    {kCutOffPiece, "cut_off_piece", kError, Check::kOwn, false,
     "a feed motion met a body that was cut off before and is not held any more"},
    {kThreading, "threading", kError, Check::kOwn, false,
     "a wire was to be threaded where no hole, or too small a hole, is"},
    {kWireSupply, "wire_supply", kError, Check::kOwn, false,
     "a wire cut while it did not run, or without fluid or a cutting condition"},
    {kFreeSlug, "free_slug", kWarning, Check::kOwn, false,
     "a piece came free, and the wire goes on through where it may still lie"},
    {kStuckSlug, "stuck_slug", kWarning, Check::kOwn, false,
     "a piece came free, and its leaning walls keep it from falling out"},
    {kBridge, "bridge", kWarning, Check::kOwn, false,
     "a piece still hangs on by a bridge: its contour is not closed"},
    {kNoseDeviation, "nose_deviation", kWarning, Check::kOwn, false,
     "the nose of an insert is not compensated"},
    {kToolData, "tool_data", kError, Check::kOwn, false, "what the operator entered is not the tool"},
    {kFeedRate, "feed_rate", kWarning, Check::kOwn, false,
     "a feed per revolution above the nose radius of the insert, or the width of the blade; a feed above "
     "`max_feed` of the machine, or a feed per tooth above `max_feed_per_tooth` of the tool"},
    {kSpindleSpeed, "spindle_speed", kWarning, Check::kOwn, false,
     "a spindle speed above `max_rpm` of the machine or of the tool"},
    {kCycleTime, "cycle_time", kWarning, Check::kOwn, false,
     "a single motion takes more than half an hour, or the motions of a program more than a day"},
    {kDwell, "dwell", kWarning, Check::kOwn, false,
     "a single dwell takes more than a minute, or all of them more than half a minute and more than the "
     "motions"},
    {kToolChange, "tool_change", kWarning, Check::kOwn, false,
     "a tool change called without a retract: below the top of the blank or a fixture and beside or in it, "
     "or inside "
     "what a turning blank sweeps"},
    {kDrillSideways, "drill_sideways", kWarning, Check::kOwn, false, "a drill cut sideways through material"},
    {kProgramUnit, "program_unit", kWarning, Check::kOwn, false,
     "the program fits the blank only in the other unit, inch or millimetre"},
    {kPartOff, "part_off", kNote, Check::kOwn, false, "a motion cut a body off"},
    {kCoarseNominal, "coarse_nominal", kNote, Check::kOwn, false,
     "the facets of the nominal leave its curved faces by more than a fifth of the smaller tolerance"},
    {kNotCompared, "not_compared", kNote, Check::kOwn, false,
     "a region that the job leaves out of the comparison, or surface that a scan does not show"},
    {kNominalPlacement, "nominal_placement", kError, Check::kOwn, false,
     "the nominal does not lie where the part does, and is not compared"},
    {kOvertravel, "overtravel", kError, Check::kOvertravel, false, "an axis left its limits"},
    {kClampedAxis, "clamped_axis", kError, Check::kOwn, false,
     "an axis turned in a feed motion that is clamped while a tool cuts, or stood between its teeth"},
    {kForbiddenZone, "forbidden_zone", kError, Check::kProgram, false,
     "an axis would enter an area that the control forbids"},
    {kAlarm, "alarm", kError, Check::kProgram, false, "the control refused the program"},
    {kNoPart, "no_part", kError, Check::kOwn, false, "nothing of the blank is left"},
    {kThinFeature, "thin_feature", kWarning, Check::kOwn, false, "what the grid cannot hold"},
    {kNothingCut, "nothing_cut", kWarning, Check::kOwn, false, "the program cut nothing"},
    {kLoosePiece, "loose_piece", kWarning, Check::kOwn, false, "the stock is in several pieces"},
    {kUncertainPart, "uncertain_part", kWarning, Check::kOwn, false,
     "several bodies may be the part, and nothing says which of them is"},
    {kPartial, "partial", kWarning, Check::kOwn, false,
     "only a part of the program or of the setups was run"},
    {kMesh, "mesh", kError, Check::kMeshClosed, false, "the exported mesh is not a closed 2-manifold"},
    {kOutput, "output", kError, Check::kOwn, false,
     "a mesh, picture, table or another file of the report could not be written"},
}};

/// Rows are found by their place.
constexpr bool inOrder() {
  for (std::size_t i = 0; i < kKinds; ++i) {
    if (static_cast<std::size_t>(kRows[i].kind) != i || kRows[i].name.empty()) return false;
  }
  return true;
}
static_assert(inOrder());

constexpr std::array<std::string_view, static_cast<std::size_t>(Check::kOwn)> kChecks{
    "program", "overtravel", "rapid contact", "shank contact", "holder contact", "fixture contact",
    "spindle", "gouge",      "excess",        "resolution",    "mesh closed"};
static_assert(!kChecks.back().empty());

}  // namespace

std::span<const FindingKindInfo> findingKinds() { return kRows; }

const FindingKindInfo& findingKindInfo(FindingKind kind) {
  PROVEOUT_ASSERT(static_cast<std::size_t>(kind) < kRows.size());
  return kRows[static_cast<std::size_t>(kind)];
}

std::string_view findingKindName(FindingKind kind) { return findingKindInfo(kind).name; }

bool isDeviation(FindingKind kind) { return findingKindInfo(kind).deviation; }

std::optional<FindingKind> findingKindNamed(std::string_view name) {
  const auto found =
      std::find_if(kRows.begin(), kRows.end(), [&](const FindingKindInfo& row) { return row.name == name; });
  return found == kRows.end() ? std::nullopt : std::optional(found->kind);
}

std::vector<std::string> findingKindNames() {
  std::vector<std::string> names;
  for (const FindingKindInfo& row : kRows) names.emplace_back(row.name);
  return names;
}

bool isBinding(FindingKind kind) {
  switch (kind) {
    case kUndecided:
    case kNotCompared:
    case kNominalPlacement:
    case kForbiddenZone:
    case kAlarm:
    case kNoPart:
    case kPartial:
    case kMesh:
    case kOutput:
      return true;
    default:
      return false;
  }
}

std::string_view checkName(JunitCheck check) {
  return check == JunitCheck::kOwn ? std::string_view() : kChecks[static_cast<std::size_t>(check)];
}

std::string_view checkName(FindingKind kind) {
  const FindingKindInfo& info = findingKindInfo(kind);
  return info.check == JunitCheck::kOwn ? info.name : checkName(info.check);
}

}  // namespace proveout
