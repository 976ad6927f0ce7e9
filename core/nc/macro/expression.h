// Formulas of the macro language: evaluated where they stand in the line, without copies.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/nc/macro/formula_language.h"
#include "core/nc/macro/formula_text.h"
#include "core/nc/macro/value.h"
#include "core/nc/macro/variables.h"
#include "core/nc/origins/value_origins.h"
#include "core/nc/text/alarms.h"
#include "core/nc/text/lexer.h"

namespace proveout::nc {

/// What formulas ask of the control around them.
class MacroEnvironment {
 public:
  virtual ~MacroEnvironment() = default;
  /// Number of the channel's axis of that name (upper case), or -1.
  virtual int axisNumber(std::string_view name) const = 0;

  struct ParameterAnswer {
    std::optional<SharedAlarm> alarm;  ///< nothing: the value is good
    std::string_view subject;          ///< of the alarm
    double value = 0.0;
  };
  /// Into how many increments ROUND divides a unit in the value of a word; elsewhere it gives whole numbers.
  virtual double stepsPerUnit(Address /*address*/) const { return 1.0; }
  /// PRM: `bit` -1 and `index` 0 where the program gives none.
  virtual ParameterAnswer parameter(int number, int bit, int index) const = 0;
};

/// Functions of a language that MacroEvaluator reads itself (FormulaFunction::special).
enum MacroSpecial : int {
  kMacroAxisNumber = 1,  ///< AXNUM[name]
  kMacroParameter,       ///< PRM[number, bit]/[index]
  kMacroRound            ///< ROUND[value]: see MacroEnvironment::stepsPerUnit
};

/// Evaluates formulas of a language whose variables are #n against the variables. Errors carry the control's
/// alarm and the columns; a result that is no finite number is kValueLimit. Brackets and functions nest 64
/// deep at most (kSyntax).
class MacroEvaluator : public ExpressionHook {
 public:
  /// What is handed in must outlive the evaluator.
  MacroEvaluator(VariableStore& variables, const MacroEnvironment& environment, const AlarmTable& alarms,
                 const FormulaLanguage& language)
      : variables_(variables), environment_(environment), alarms_(alarms), language_(language) {}
  /// `origins` must outlive the evaluator. Without, values have no origins.
  void setOrigins(ValueOrigins& origins) { origins_ = &origins; }

  /// The value of a word: a sign, and a variable, a bracket or a function. A vacant variable stays vacant,
  /// with a sign too.
  bool evaluate(std::string_view text, std::size_t& pos, Value& value, LexError& error) override;
  bool evaluateWord(Address address, std::string_view text, std::size_t& pos, Value& value,
                    LexError& error) override;
  /// A whole formula from `pos` on.
  bool formula(std::string_view text, std::size_t& pos, Value& value, LexError& error);
  /// `[formula relation formula]` from `pos` on (IF, WHILE). Vacant equals vacant alone and is greater than
  /// every number (manual 23.1.6).
  bool condition(std::string_view text, std::size_t& pos, bool& holds, LexError& error);
  /// How far apart the sides of the last condition stood; NaN where one was vacant.
  double distance() const { return distance_; }
  /// `#i=formula` from `pos` on. The text behind the formula is handed to the variables as the note. An error
  /// without a code has been reported already.
  bool assign(std::string_view text, std::size_t& pos, LexError& error);
  /// `#n`, `#[formula]` or `#_NAME[formula]` from `pos` on, without reading it.
  bool variable(std::string_view text, std::size_t& pos, int& number, LexError& error);

 private:
  VariableStore& variables_;
  const MacroEnvironment& environment_;
  const AlarmTable& alarms_;
  const FormulaLanguage& language_;
  ValueOrigins* origins_ = nullptr;
  double distance_ = 0.0;
  std::vector<std::uint32_t> reads_;  ///< origins of the variables of the formula in hand
};

}  // namespace proveout::nc
