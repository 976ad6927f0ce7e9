#include "core/nc/fanuc/alarms.h"

namespace proveout::nc {

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
          {SharedAlarm::kNoNumber, 5, {}, "no number behind the address {}"},
          {SharedAlarm::kSign, 6, {}, "illegal use of a sign at {}"},
          {SharedAlarm::kPoint, 7, {}, "illegal use of a decimal point at {}"},
          {SharedAlarm::kCharacter, 9, {}, "illegal NC address: {} does not start a word"},
          {SharedAlarm::kCompNoIntersection, 33, {}, "no intersection in cutter compensation"},
          {SharedAlarm::kCompEndInArc,
           34,
           {},
           "no circle allowed at the start or end of cutter compensation"},
          {SharedAlarm::kProbeState, 35, {}, "G31 cannot be used here: {}"},
          {SharedAlarm::kPlane, 28, {}, "illegal plane select"},
          {SharedAlarm::kCompInterference, 41, {}, "interference in cutter compensation"},
          {SharedAlarm::kCorner, 52, {}, "improper chamfer or corner: no G01 to G03 behind it"},
          {SharedAlarm::kCornerTooLarge, 55, {}, "missing move value in chamfer or corner: it does not fit"},
          {SharedAlarm::kNothingBehind, 51, {}, "missing move behind chamfer or corner"},
          {SharedAlarm::kChamferAndRounding, 53, {}, "too many addresses: chamfer and corner in one block"},
          {SharedAlarm::kContour, 57, {}, "no solution of block end: {}"},
          {SharedAlarm::kProgramNotFound, 76, {}, "program not found"},
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
          {"plane-in-comp", 37},
          {"virtual-forbidden", 146},
          {"virtual-comp", 146},
          {"comp-start-arc", 34},
      }};
  return kTable;
}

}  // namespace proveout::nc
