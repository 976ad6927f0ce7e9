// What the rooms that all controls share may refuse, and the alarms that a control hands in for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// What lexer, macro language and contour stages refuse. Every control names each of them with the code and
/// the text of its manual; a room adds what is wrong in detail.
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
  kCircleRadius,      ///< the end is not on the circle
  kCorner,            ///< chamfer or rounding where none may stand
  kCornerTooLarge     ///< chamfer or rounding that does not fit
};
inline constexpr std::size_t kSharedAlarms = static_cast<std::size_t>(SharedAlarm::kCornerTooLarge) + 1;

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
    std::string code;       ///< of the diagnostic, "nct-2064"
    std::string_view text;  ///< `{}` is the subject
  };
  /// What has no row has neither code nor text: for controls that do not use the rooms that refuse it.
  AlarmTable(std::initializer_list<Row> rows);

  const std::string& code(SharedAlarm alarm) const { return rows_[static_cast<std::size_t>(alarm)].code; }
  /// "text of the manual: detail".
  std::string message(SharedAlarm alarm, std::string_view subject, std::string_view detail = {}) const;

 private:
  std::vector<Row> rows_;  ///< by SharedAlarm
};

}  // namespace proveout::nc
