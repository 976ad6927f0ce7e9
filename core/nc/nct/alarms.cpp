#include "core/nc/nct/alarms.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace proveout::nc {
namespace {

constexpr auto kAlarms = std::to_array<Alarm>({
    {2001, "mirroring cannot be switched on or off in state G51 or G68"},
    {2002, "{} data out of range"},
    {2004, "missing data {}"},
    {2012, "circle radius difference error"},
    {2015, "circle definition error"},
    {2017, "illegal address {}"},
    {2018, "wrong physical axis number {}"},
    {2021, "thread cutting definition error"},
    {2035, "wrong axis data {}"},
    {2039, "Q specification error"},
    {2043, "G40 in circular interpolation"},
    {2047, "no intersection point G41, G42"},
    {2049, "interference error"},
    {2053, "no bottom point or R point"},
    {2055, "probe in state {}"},
    {2056, "end point in positive end position on axis {}"},
    {2057, "end point in negative end position on axis {}"},
    {2058, "end point in forbidden zone 2 {} +"},
    {2059, "end point in forbidden zone 2 {} -"},
    {2060, "end point in inner forbidden zone 2"},
    {2061, "end point in inner forbidden zone 3"},
    {2062, "entry into inner forbidden zone 2"},
    {2063, "entry into inner forbidden zone 3"},
    {2064, "syntax error"},
    {2082, "either chamfer or rounding"},
    {2085, "illegal chamfer or rounding"},
    {2088, "illegal plane selection"},
    {2090, "cutter compensation cannot be continued, buffer full"},
    {2092, "value limit exceeded: {}"},
    {2093, "division by 0"},
    {2097, "illegal incremental movement on axis {}"},
    {2104, "probe position out of limits"},
    {2110, "WHILE without DO"},
    {2116, "absolute value of the argument not less than 90"},
    {2117, "absolute value of the argument greater than 1"},
    {2118, "value of the argument not positive"},
    {2121, "right bracket not found"},
    {2121, "wrong terminator: {}"},
    {2122, "root of a negative value"},
    {2123, "function not implemented: {}"},
    {2125, "block {} not found"},
    {2129, "erroneous operation on #"},
    {2132, "file not found"},
    {2137, "G76, G87"},
    {2138, "spindle cannot be indexed"},
    {2144, "file {} already exists"},
    {2146, "the given file already exists"},
    {2147, "file {} not found"},
    {2156, "probe state error in channel {}"},
    {2161, "variable {} is read-only"},
    {2188, "{} not allowed during fine smoothing"},
    {2193, "parameter {} cannot be changed by G10"},
    {2194, "function PRM {} parameter missing"},
    {2501, "position error {}"},
    {3010, "ran onto positive end position on axis {}"},
    {3011, "ran onto negative end position on axis {}"},
    {3018, "ran onto positive limit switch on axis {}"},
    {3019, "ran onto negative limit switch on axis {}"},
    {3040, "forbidden zone 2 {} +"},
    {3041, "forbidden zone 2 {} -"},
    {3042, "inner forbidden zone 2"},
    {3043, "inner forbidden zone 3"},
    {3157, "servo error G31 {}"},
});

}  // namespace

std::span<const Alarm> nctAlarmTexts() { return kAlarms; }

namespace {

/// The n-th text of that number; empty: the table lacks it.
std::string_view textOf(int number, std::ptrdiff_t n = 0) {
  const auto found = std::lower_bound(kAlarms.begin(), kAlarms.end(), number,
                                      [](const Alarm& a, int wanted) { return a.number < wanted; });
  const bool there = kAlarms.end() - found > n && (found + n)->number == number;
  return there ? (found + n)->text : std::string_view();
}

AlarmTable::Row row(SharedAlarm alarm, int number) { return {alarm, number, {}, textOf(number)}; }

}  // namespace

const AlarmTable& nctAlarms() {
  static const AlarmTable kTable{
      "nct",
      {
          row(SharedAlarm::kMirrorInTransform, 2001),
          row(SharedAlarm::kOutOfRange, 2002),
          row(SharedAlarm::kMissingData, 2004),
          row(SharedAlarm::kCircleRadius, 2012),
          row(SharedAlarm::kCircle, 2015),
          row(SharedAlarm::kIllegalAddress, 2017),
          row(SharedAlarm::kAxisNumber, 2018),
          row(SharedAlarm::kThread, 2021),
          row(SharedAlarm::kAxis, 2035),
          row(SharedAlarm::kTorque, 2039),
          row(SharedAlarm::kCompEndInArc, 2043),
          row(SharedAlarm::kCompNoIntersection, 2047),
          row(SharedAlarm::kCompInterference, 2049),
          row(SharedAlarm::kNoBottom, 2053),
          row(SharedAlarm::kProbeState, 2055),
          row(SharedAlarm::kEndAbove, 2056),
          row(SharedAlarm::kEndBelow, 2057),
          row(SharedAlarm::kZoneEndAbove, 2058),
          row(SharedAlarm::kZoneEndBelow, 2059),
          row(SharedAlarm::kZoneEndInside2, 2060),
          row(SharedAlarm::kZoneEndInside3, 2061),
          row(SharedAlarm::kZoneEntry2, 2062),
          row(SharedAlarm::kZoneEntry3, 2063),
          row(SharedAlarm::kSyntax, 2064),
          row(SharedAlarm::kChamferAndRounding, 2082),
          row(SharedAlarm::kCorner, 2085),
          row(SharedAlarm::kPlane, 2088),
          row(SharedAlarm::kCompBuffer, 2090),
          row(SharedAlarm::kValueLimit, 2092),
          row(SharedAlarm::kDivision, 2093),
          row(SharedAlarm::kIncremental, 2097),
          row(SharedAlarm::kProbeLimits, 2104),
          row(SharedAlarm::kWhileWithoutDo, 2110),
          row(SharedAlarm::kTangent, 2116),
          row(SharedAlarm::kArcFunction, 2117),
          row(SharedAlarm::kLogarithm, 2118),
          row(SharedAlarm::kRightBracket, 2121),
          row(SharedAlarm::kRoot, 2122),
          row(SharedAlarm::kNotImplemented, 2123),
          row(SharedAlarm::kBlockNotFound, 2125),
          row(SharedAlarm::kBits, 2129),
          row(SharedAlarm::kFileNotFound, 2132),
          row(SharedAlarm::kOrientation, 2137),
          row(SharedAlarm::kIndexing, 2138),
          row(SharedAlarm::kProgramExists, 2144),
          row(SharedAlarm::kFileExists, 2146),
          row(SharedAlarm::kProgramNotFound, 2147),
          row(SharedAlarm::kReadOnly, 2161),
          row(SharedAlarm::kInSmoothing, 2188),
          row(SharedAlarm::kParameterLocked, 2193),
          row(SharedAlarm::kParameterMissing, 2194),
          row(SharedAlarm::kRanAbove, 3010),
          row(SharedAlarm::kRanBelow, 3011),
          row(SharedAlarm::kZoneRanAbove, 3040),
          row(SharedAlarm::kZoneRanBelow, 3041),
          row(SharedAlarm::kZoneRan2, 3042),
          row(SharedAlarm::kZoneRan3, 3043),
          {SharedAlarm::kTerminator, 2121, {}, textOf(2121, 1)},
          {SharedAlarm::kCornerTooLarge, 0, "corner-too-large", "chamfer or rounding too large"},
          {SharedAlarm::kDuplicateWord, 0, "duplicate-word", "two {} in one block"},
          {SharedAlarm::kVariable, 0, "variable", "{}"},
          {SharedAlarm::kContour, 0, "contour", "{}"},
      }};
  return kTable;
}

std::string alarmText(int number, std::string_view subject) {
  const std::string_view text = textOf(number);
  if (!text.empty()) return withSubject(text, subject);
  return subject.empty() ? "alarm of the program" : fmt::format("alarm of the program {}", subject);
}

}  // namespace proveout::nc
