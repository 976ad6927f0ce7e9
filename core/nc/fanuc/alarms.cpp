#include "core/nc/fanuc/alarms.h"

#include <algorithm>
#include <array>

namespace proveout::nc {
namespace {

/// Alarms that rules of Fanuc-like controls raise by their number, in fail().
constexpr auto kRaisedByNumber = std::to_array<int>({
    7,   23,  27,  29,  30,  31,  42,  45,  46,  49,  50,  54,  61,  62,  63,   64,   65,   66,   69,   92,
    129, 141, 142, 145, 175, 176, 200, 201, 202, 203, 206, 241, 242, 243, 5115, 5116, 5117, 5118, 5123, 5432,
});

}  // namespace

const AlarmTable& fanucAlarms() {
  static const AlarmTable kTable{
      "fanuc",
      {
          {SharedAlarm::kOutOfRange, 3, {}, "too many digits or value out of range: {}"},
          {SharedAlarm::kIllegalAddress, 9, {}, "illegal address {}"},
          {SharedAlarm::kNotImplemented, 10, {}, "improper G-code: {}"},
          {SharedAlarm::kCircleRadius, 20, {}, "over tolerance of radius"},
          {SharedAlarm::kCircle, 22, {}, "no radius and no centre of an arc"},
          {SharedAlarm::kCircleCentre, 21, {}, "illegal plane axis commanded"},
          {SharedAlarm::kNumberMissing, 5, {}, "no number behind the address {}"},
          {SharedAlarm::kSign, 6, {}, "illegal use of a sign at {}"},
          {SharedAlarm::kPoint, 7, {}, "illegal use of a decimal point at {}"},
          {SharedAlarm::kCharacter, 9, {}, "illegal NC address: {} does not start a word"},
          {SharedAlarm::kCompNoIntersection, 33, {}, "no intersection in cutter compensation"},
          {SharedAlarm::kCompEndInArc,
           34,
           {},
           "no circle allowed at the start or end of cutter compensation"},
          {SharedAlarm::kCompStartInArc,
           34,
           {},
           "no circle allowed at the start or end of cutter compensation"},
          {SharedAlarm::kPlaneInComp, 37, {}, "the plane cannot change in cutter compensation"},
          {SharedAlarm::kPlaneInRotation, 144, {}, "illegal plane selected"},
          {SharedAlarm::kProbeInComp, 35, {}, "G31 cannot be specified in cutter compensation: {}"},
          {SharedAlarm::kProbeState, 36, {}, "G31 cannot be used here: {}"},
          {SharedAlarm::kPlane, 28, {}, "illegal plane select"},
          {SharedAlarm::kSurfaceAxis, 190, {}, "illegal axis select: {} of G96"},
          {SharedAlarm::kCompInterference, 41, {}, "interference in cutter compensation"},
          {SharedAlarm::kCorner, 52, {}, "improper chamfer or corner: no G01 to G03 behind it"},
          {SharedAlarm::kCornerTooLarge, 55, {}, "missing move value in chamfer or corner: it does not fit"},
          {SharedAlarm::kNothingBehind, 51, {}, "missing move behind chamfer or corner"},
          {SharedAlarm::kChamferAndRounding, 53, {}, "too many addresses: chamfer and corner in one block"},
          {SharedAlarm::kOpenLine, 56, {}, "no end point and no angle behind a line by its angle: {}"},
          {SharedAlarm::kContour, 57, {}, "no solution of block end: {}"},
          {SharedAlarm::kProgramNotFound, 76, {}, "program not found"},
          {SharedAlarm::kProgramTwice, 73, {}, "program number already in use"},
          {SharedAlarm::kFileNotFound, 76, {}, "program not found"},
          {SharedAlarm::kBlockNotFound, 78, {}, "number not found: {}"},
          {SharedAlarm::kValueLimit, 111, {}, "calculated data overflow: {}"},
          {SharedAlarm::kDivision, 112, {}, "divided by zero"},
          {SharedAlarm::kSyntax, 114, {}, "format error"},
          {SharedAlarm::kVariable, 115, {}, "illegal variable number: {}"},
          {SharedAlarm::kReadOnly, 116, {}, "write protected variable {}"},
          {SharedAlarm::kRightBracket, 125, {}, "format error in macro: bracket is missing"},
          {SharedAlarm::kFormulaDepth, 118, {}, "parenthesis nesting error"},
          {SharedAlarm::kMixedBlock, 127, {}, "NC and macro statement in same block"},
          {SharedAlarm::kLoopNumber, 126, {}, "illegal loop number of {}"},
          {SharedAlarm::kLoopDoubled, 124, {}, "missing END statement"},
          {SharedAlarm::kLoopPair, 124, {}, "missing {}"},
          {SharedAlarm::kJumpTarget, 128, {}, "illegal macro sequence number {}"},
          {SharedAlarm::kNesting, 77, {}, "{}"},
          {SharedAlarm::kModalNesting, 122, {}, "{}"},
          {SharedAlarm::kTerminator, 114, {}, "format error: {}"},
          {SharedAlarm::kTangent, 119, {}, "illegal argument"},
          {SharedAlarm::kArcFunction, 119, {}, "illegal argument"},
          {SharedAlarm::kLogarithm, 119, {}, "illegal argument"},
          {SharedAlarm::kRoot, 119, {}, "illegal argument"},
          {SharedAlarm::kBits, 119, {}, "illegal argument"},
          {SharedAlarm::kWhileWithoutDo, 124, {}, "missing END statement or DO"},
          {SharedAlarm::kDuplicateWord, 5074, {}, "address duplication error: {}"},
      },
      {
          {"feed", 11},
          {"virtual-forbidden", 146},
          {"virtual-comp", 146},
          {"polar-start", 145},
      }};
  return kTable;
}

std::vector<int> fanucAlarmNumbers() {
  std::vector<int> all(kRaisedByNumber.begin(), kRaisedByNumber.end());
  const AlarmTable& table = fanucAlarms();
  for (std::size_t k = 0; k < kSharedAlarms; ++k) {
    if (const int number = table.number(static_cast<SharedAlarm>(k)); number != 0) all.push_back(number);
  }
  for (const auto& named : table.names()) all.push_back(named.second);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace proveout::nc
