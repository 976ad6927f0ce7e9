#include "core/nc/text/alarms.h"

#include <array>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

/// Names and texts for what a control has no number for.
constexpr auto kUsual = std::to_array<AlarmTable::Row>({
    {SharedAlarm::kSyntax, 0, "syntax", "syntax error"},
    {SharedAlarm::kOutOfRange, 0, "out-of-range", "{} data out of range"},
    {SharedAlarm::kIllegalAddress, 0, "illegal-address", "illegal address {}"},
    {SharedAlarm::kAxisNumber, 0, "axis-number", "wrong axis number {}"},
    {SharedAlarm::kNotImplemented, 0, "not-implemented", "function not implemented: {}"},
    {SharedAlarm::kDuplicateWord, 0, "duplicate-word", "two {} in one block"},
    {SharedAlarm::kRightBracket, 0, "right-bracket", "right bracket not found"},
    {SharedAlarm::kTerminator, 0, "terminator", "wrong end of a formula: {}"},
    {SharedAlarm::kVariable, 0, "variable", "{}"},
    {SharedAlarm::kReadOnly, 0, "read-only", "variable {} is read-only"},
    {SharedAlarm::kValueLimit, 0, "value-limit", "value limit exceeded: {}"},
    {SharedAlarm::kDivision, 0, "division", "division by 0"},
    {SharedAlarm::kTangent, 0, "tangent", "argument of a tangent"},
    {SharedAlarm::kArcFunction, 0, "arc-function", "argument of an arc function"},
    {SharedAlarm::kLogarithm, 0, "logarithm", "argument of a logarithm"},
    {SharedAlarm::kRoot, 0, "root", "root of a negative value"},
    {SharedAlarm::kBits, 0, "bits", "operand of a bit operation"},
    {SharedAlarm::kParameterMissing, 0, "parameter-missing", "{} parameter of a function missing"},
    {SharedAlarm::kContour, 0, "contour", "{}"},
    {SharedAlarm::kOpenLine, 0, "contour", "{}"},
    {SharedAlarm::kCircleRadius, 0, "circle-radius", "circle radius difference error"},
    {SharedAlarm::kCorner, 0, "corner", "illegal chamfer or rounding"},
    {SharedAlarm::kCornerTooLarge, 0, "corner-too-large", "chamfer or rounding too large"},
    {SharedAlarm::kNumberMissing, 0, "no-number", "{} has no value"},
    {SharedAlarm::kSign, 0, "sign", "misplaced sign at {}"},
    {SharedAlarm::kPoint, 0, "point", "misplaced decimal point at {}"},
    {SharedAlarm::kCharacter, 0, "character", "{} does not start a word"},
    {SharedAlarm::kMissingData, 0, "missing-data", "missing data {}"},
    {SharedAlarm::kMirrorInTransform, 0, "mirror-in-transform",
     "mirroring cannot be switched while scaling or rotation is on"},
    {SharedAlarm::kCircle, 0, "circle", "circle definition error"},
    {SharedAlarm::kCircleCentre, 0, "circle-centre", "circle definition error"},
    {SharedAlarm::kNothingBehind, 0, "nothing-behind", "illegal chamfer or rounding"},
    {SharedAlarm::kThread, 0, "thread", "thread definition error"},
    {SharedAlarm::kAxis, 0, "axis", "wrong axis data {}"},
    {SharedAlarm::kTorque, 0, "torque", "torque of a measuring move"},
    {SharedAlarm::kNoTilt, 0, "no-tilt", "no tilted plane is in force"},
    {SharedAlarm::kNoLength, 0, "no-length", "H is not programmed"},
    {SharedAlarm::kTipAndTarget, 0, "tip-and-target", "R cannot be programmed with an end point"},
    {SharedAlarm::kInclination, 0, "inclination", "inadmissible inclination angle {}"},
    {SharedAlarm::kCompEndInArc, 0, "comp-end-in-arc", "cutter compensation ends in an arc"},
    {SharedAlarm::kCompStartInArc, 0, "comp-start-arc", "cutter compensation starts in an arc"},
    {SharedAlarm::kPlaneInComp, 0, "plane-in-comp", "the plane cannot change in cutter compensation"},
    {SharedAlarm::kPlaneInRotation, 0, "plane-in-rotation", "the plane cannot change in a rotation"},
    {SharedAlarm::kCompNoIntersection, 0, "comp-no-intersection",
     "no intersection point of compensated blocks"},
    {SharedAlarm::kCompInterference, 0, "comp-interference", "interference of compensated blocks"},
    {SharedAlarm::kCompBuffer, 0, "comp-buffer", "cutter compensation cannot be continued, buffer full"},
    {SharedAlarm::kNoBottom, 0, "no-bottom", "no bottom point or R point"},
    {SharedAlarm::kProbeState, 0, "probe-state", "measuring in state {}"},
    {SharedAlarm::kProbeInComp, 0, "probe-state", "measuring in state {}"},
    {SharedAlarm::kProbeLimits, 0, "probe-limits", "probe position out of limits"},
    {SharedAlarm::kIncremental, 0, "incremental", "illegal incremental word {}"},
    {SharedAlarm::kPlane, 0, "plane", "illegal plane selection"},
    {SharedAlarm::kSurfaceAxis, 0, "out-of-range", "{} data out of range"},
    {SharedAlarm::kWhileWithoutDo, 0, "while-without-do", "WHILE without DO"},
    {SharedAlarm::kBlockNotFound, 0, "block-not-found", "block {} not found"},
    {SharedAlarm::kFileNotFound, 0, "file-not-found", "file not found"},
    {SharedAlarm::kProgramNotFound, 0, "program-not-found", "program not found"},
    {SharedAlarm::kProgramTwice, 0, "program-twice", "two programs of one number"},
    {SharedAlarm::kProgramExists, 0, "program-exists", "file {} already exists"},
    {SharedAlarm::kFileExists, 0, "file-exists", "the given file already exists"},
    {SharedAlarm::kChamferAndRounding, 0, "chamfer-and-rounding", "either chamfer or rounding"},
    {SharedAlarm::kOrientation, 0, "orientation", "spindle cannot be oriented"},
    {SharedAlarm::kIndexing, 0, "indexing", "spindle cannot be indexed"},
    {SharedAlarm::kInSmoothing, 0, "in-smoothing", "{} not allowed during smoothing"},
    {SharedAlarm::kParameterLocked, 0, "parameter-locked", "parameter {} cannot be changed by the program"},
    {SharedAlarm::kFormulaDepth, 0, "syntax", "syntax error"},
    {SharedAlarm::kMixedBlock, 0, "syntax", "syntax error"},
    {SharedAlarm::kLoopNumber, 0, "out-of-range", "{} data out of range"},
    {SharedAlarm::kLoopDoubled, 0, "syntax", "syntax error"},
    {SharedAlarm::kLoopPair, 0, "block-not-found", "block {} not found"},
    {SharedAlarm::kJumpTarget, 0, "block-not-found", "block {} not found"},
    {SharedAlarm::kNesting, 0, "nesting", "{}"},
    {SharedAlarm::kModalNesting, 0, "nesting", "{}"},
    {SharedAlarm::kEndAbove, 0, "end-above", "end point beyond the positive end of axis {}"},
    {SharedAlarm::kEndBelow, 0, "end-below", "end point beyond the negative end of axis {}"},
    {SharedAlarm::kZoneEndAbove, 0, "zone-end-above", "end point in forbidden zone 2 {} +"},
    {SharedAlarm::kZoneEndBelow, 0, "zone-end-below", "end point in forbidden zone 2 {} -"},
    {SharedAlarm::kZoneEndInside2, 0, "zone-end-inside-2", "end point in inner forbidden zone 2"},
    {SharedAlarm::kZoneEndInside3, 0, "zone-end-inside-3", "end point in inner forbidden zone 3"},
    {SharedAlarm::kZoneEntry2, 0, "zone-entry-2", "entry into inner forbidden zone 2"},
    {SharedAlarm::kZoneEntry3, 0, "zone-entry-3", "entry into inner forbidden zone 3"},
    {SharedAlarm::kRanAbove, 0, "ran-above", "ran onto the positive end of axis {}"},
    {SharedAlarm::kRanBelow, 0, "ran-below", "ran onto the negative end of axis {}"},
    {SharedAlarm::kZoneRanAbove, 0, "zone-ran-above", "forbidden zone 2 {} +"},
    {SharedAlarm::kZoneRanBelow, 0, "zone-ran-below", "forbidden zone 2 {} -"},
    {SharedAlarm::kZoneRan2, 0, "zone-ran-2", "inner forbidden zone 2"},
    {SharedAlarm::kZoneRan3, 0, "zone-ran-3", "inner forbidden zone 3"},
});

}  // namespace

std::string withSubject(std::string_view text, std::string_view subject) {
  const std::size_t mark = text.find("{}");
  if (mark == std::string_view::npos) return std::string(text);
  std::string out(text.substr(0, mark));
  out += subject;
  std::string_view rest = text.substr(mark + 2);
  if (subject.empty()) {
    if (!out.empty() && out.back() == ' ') out.pop_back();
    if (out.empty() && !rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
    if (!out.empty() && out.back() == ':') out.pop_back();
  }
  return out + std::string(rest);
}

std::string withDetail(std::string what, std::string_view detail) {
  if (detail.empty()) return what;
  what += ": ";
  what += detail;
  return what;
}

AlarmTable::AlarmTable(std::string_view control, std::initializer_list<Row> rows,
                       std::initializer_list<std::pair<std::string_view, int>> names)
    : control_(control), names_(names), rows_(kSharedAlarms), codes_(kSharedAlarms) {
  static_assert(kUsual.size() == kSharedAlarms);
  for (const Row& row : kUsual) take(row);
  for (const Row& row : rows) take(row);
}

void AlarmTable::take(const Row& row) {
  PROVEOUT_ASSERT(row.alarm < SharedAlarm::kCount && (row.number != 0 || !row.name.empty()));
  const auto at = static_cast<std::size_t>(row.alarm);
  rows_[at] = row;
  codes_[at] = row.number != 0 ? code(row.number) : control_ + "-" + std::string(row.name);
}

std::string AlarmTable::code(int number) const {
  const std::string digits = std::to_string(number);
  return control_ + "-" + (digits.size() < 3 ? std::string(3 - digits.size(), '0') : "") + digits;
}

std::string AlarmTable::code(const DiagnosticName& name) const {
  if (name.alarm() != SharedAlarm::kCount) return code(name.alarm());
  for (const auto& [own, number] : names_) {
    if (own == name.name()) return code(number);
  }
  return control_ + "-" + std::string(name.name());
}

std::string AlarmTable::message(SharedAlarm alarm, std::string_view subject, std::string_view detail) const {
  return withDetail(withSubject(rows_[static_cast<std::size_t>(alarm)].text, subject), detail);
}

}  // namespace proveout::nc
