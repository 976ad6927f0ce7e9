// What the rooms that all controls share may refuse, and the alarms that a control hands in for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proveout::nc {

/// What the rooms that several controls share refuse. Every control names each of them with the code and the
/// text of its manual; a room adds what is wrong in detail.
enum class SharedAlarm : std::uint8_t {
  kSyntax,
  kOutOfRange,        ///< subject: the address
  kIllegalAddress,    ///< subject: the address
  kAxisNumber,        ///< subject: the number
  kNotImplemented,    ///< subject: the function
  kDuplicateWord,     ///< subject: the word
  kRightBracket,      ///< none behind a formula
  kTerminator,        ///< subject: what stands where something else ends a formula
  kVariable,          ///< subject: the whole sentence
  kReadOnly,          ///< subject: the variable
  kValueLimit,        ///< subject: the variable, or none for the result of a formula
  kDivision,          ///< by zero
  kTangent,           ///< argument of a tangent
  kArcFunction,       ///< argument of an arc sine or cosine
  kLogarithm,         ///< argument
  kRoot,              ///< argument
  kBits,              ///< operand of a bit operation
  kParameterMissing,  ///< subject: which of a parameter function
  kContour,           ///< subject: the whole sentence
  kOpenLine,          ///< a line by its direction alone without an end; subject: the whole sentence
  kCircleRadius,      ///< the end is not on the circle
  kCorner,            ///< chamfer or rounding where none may stand
  kCornerTooLarge,    ///< chamfer or rounding that does not fit
  kNumberMissing,     ///< subject: an address without digits
  kSign,              ///< subject: an address with a sign where none may stand
  kPoint,             ///< subject: an address with a decimal point where none may stand
  kCharacter,         ///< subject: what starts no word
  // Controls of the ISO family.
  kMissingData,        ///< subject: the address
  kMirrorInTransform,  ///< mirroring switched while scaling or rotation is on
  kCircle,             ///< a circle that is not defined
  kCircleCentre,       ///< a centre word across the plane
  kNothingBehind,      ///< a chamfer or rounding without a motion behind it
  kThread,             ///< a thread that is not defined
  kAxis,               ///< subject: an axis that cannot stand here
  kTorque,             ///< Q: of a measuring move, of a tilted plane
  kNoTilt,             ///< a code that needs a tilted plane
  kNoLength,           ///< a code that needs a tool length
  kTipAndTarget,       ///< a distance from the tip beside an end point
  kInclination,        ///< subject: an angle that the tool cannot come to on the block's way
  kCompEndInArc,       ///< cutter compensation ends in an arc
  kCompStartInArc,     ///< or starts in one
  kPlaneInComp,        ///< the plane changes while cutter compensation is on
  kPlaneInRotation,    ///< or while a rotation is
  kCompNoIntersection,
  kCompInterference,
  kCompBuffer,      ///< more blocks wait than the control can hold
  kNoBottom,        ///< a cycle without its bottom or R point
  kProbeState,      ///< subject: the code that measuring does not go with
  kProbeInComp,     ///< the same of cutter compensation
  kProbeLimits,     ///< the probe answers outside of the expected way
  kIncremental,     ///< subject: an axis whose word cannot be incremental here
  kPlane,           ///< a plane that cannot be chosen here
  kSurfaceAxis,     ///< subject: the word that names no axis of constant surface speed
  kWhileWithoutDo,  ///< WHILE without DO
  kBlockNotFound,   ///< subject: the block
  kFileNotFound,
  kProgramNotFound,  ///< the file of a call
  kProgramTwice,     ///< two programs of a file have the number that is called
  kProgramExists,    ///< subject: the file
  kFileExists,
  kChamferAndRounding,  ///< both in one block
  kOrientation,         ///< the spindle cannot be oriented
  kIndexing,            ///< the spindle cannot be turned to an angle
  kInSmoothing,         ///< subject: what is not allowed during smoothing
  kParameterLocked,     ///< subject: the parameter
  kFormulaDepth,        ///< a formula is nested too deep
  kMixedBlock,          ///< a statement of the macro language beside words or another one
  kLoopNumber,          ///< subject: DO or END whose number no loop has
  kLoopDoubled,         ///< a loop inside of one of the same number
  kLoopPair,            ///< subject: DO1 or END1 that is missing
  kJumpTarget,          ///< subject: the block that GOTO names
  kNesting,             ///< subject: the whole sentence; calls are nested too deep
  kModalNesting,        ///< the same of modal macros
  // Ends and ways beyond limits; subject: the axis.
  kEndAbove,
  kEndBelow,
  kZoneEndAbove,
  kZoneEndBelow,
  kZoneEndInside2,
  kZoneEndInside3,
  kZoneEntry2,
  kZoneEntry3,
  kRanAbove,
  kRanBelow,
  kZoneRanAbove,
  kZoneRanBelow,
  kZoneRan2,
  kZoneRan3,
  kCount
};
inline constexpr std::size_t kSharedAlarms = static_cast<std::size_t>(SharedAlarm::kCount);

/// What a diagnostic is called: an alarm of the control's manual, or a name of the simulator's own that
/// stands behind the control's.
class DiagnosticName {
 public:
  DiagnosticName(SharedAlarm alarm) : alarm_(alarm) {}      // NOLINT: implicit on purpose
  DiagnosticName(const char* name) : name_(name) {}         // NOLINT
  DiagnosticName(const std::string& name) : name_(name) {}  // NOLINT
  SharedAlarm alarm() const { return alarm_; }              ///< kCount: it has a name
  std::string_view name() const { return name_; }

 private:
  SharedAlarm alarm_ = SharedAlarm::kCount;
  std::string_view name_;
};

/// The text of an alarm with its subject where `{}` stands; without a subject the mark and the blank or colon
/// before it go.
std::string withSubject(std::string_view text, std::string_view subject);
/// "what: detail", or what alone.
std::string withDetail(std::string what, std::string_view detail);

/// The shared alarms as one control tells them.
class AlarmTable {
 public:
  struct Row {
    SharedAlarm alarm;
    int number;             ///< of the manual; 0: it has a name
    std::string_view name;  ///< with number 0
    std::string_view text;  ///< `{}` is the subject
  };
  /// `control`: its name stands in front of the codes of diagnostics, "nct" in "nct-2064". What has no row
  /// goes by a name and a usual text.
  /// `names`: names of the simulator's own that the control has a number for.
  AlarmTable(std::string_view control, std::initializer_list<Row> rows,
             std::initializer_list<std::pair<std::string_view, int>> names = {});

  const std::string& code(SharedAlarm alarm) const { return codes_[static_cast<std::size_t>(alarm)]; }
  std::string code(const DiagnosticName& name) const;
  /// The code of an alarm by its number, of three digits at least: "nct-4001".
  std::string code(int number) const;
  /// Names of the simulator's own with the control's numbers for them.
  const std::vector<std::pair<std::string_view, int>>& names() const { return names_; }
  int number(SharedAlarm alarm) const { return rows_[static_cast<std::size_t>(alarm)].number; }
  /// "text of the manual: detail".
  std::string message(SharedAlarm alarm, std::string_view subject, std::string_view detail = {}) const;

 private:
  void take(const Row& row);

  std::string control_;
  std::vector<std::pair<std::string_view, int>> names_;
  std::vector<Row> rows_;           ///< by SharedAlarm
  std::vector<std::string> codes_;  ///< the same
};

}  // namespace proveout::nc
