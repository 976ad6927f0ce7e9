// Reads a formula and gives its value, by the table of its language: precedence climbing.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/characters.h"
#include "core/nc/macro/formula_language.h"
#include "core/nc/macro/formula_text.h"
#include "core/nc/macro/formula_values.h"
#include "core/nc/macro/value.h"

namespace proveout::nc {

/// Why a formula cannot be read, or has no value. The control makes its message of it.
struct FormulaFault {
  enum class Kind : std::uint8_t {
    kNoOperand,        ///< something else stands here, or the text ends
    kTooDeep,          ///< nested deeper than the language allows
    kNoBracket,        ///< the one that opens at `begin` is not closed
    kSecondPoint,      ///< in a number
    kNoDigits,         ///< a number of a point alone
    kBeyondRange,      ///< a number that no double holds
    kNoArgument,       ///< the argument of function `name` is not where it should be
    kNoSecond,         ///< the second one
    kOperation,        ///< `refusal` says what the operator refused
    kFunction,         ///< the same of function `name` of `argument`
    kNoCondition,      ///< it has no bracket
    kNoRelation,       ///< a condition without one
    kConditionGoesOn,  ///< behind its one relation, in the bracket that opens at `begin`
  };
  Kind kind = Kind::kNoOperand;
  std::size_t begin = 0;  ///< of what is at fault, behind blanks
  std::size_t entry = 0;  ///< the same in front of the blanks
  std::size_t end = 0;    ///< behind what was read of it, in front of blanks
  int rank = 0;           ///< of the operator
  SharedAlarm refusal = SharedAlarm::kSyntax;
  std::string_view name = {};
  double argument = 0.0;
};

/// One formula on its way from text to value. `Control` derives from this and has
///   bool fail(const FormulaFault&)   keeps the message and gives false; true: a number that is too large
///                                    counts as 0;
///   bool variable(Value&)            what begins with the mark of variables, at pos();
///   bool special(int, const FormulaFunction&, Value&)  rows with a number, at their name;
///   bool otherName(Value&)           a name that has no row;
/// and, where the defaults below do not serve, what is declared under "what a control may have anew".
template <class Control>
class FormulaParser {
 public:
  /// All must outlive the parser; `reads` gets the origins of the variables that are read.
  FormulaParser(const FormulaLanguage& language, std::string_view text, std::size_t pos,
                std::vector<std::uint32_t>& reads)
      : i(pos), text_(text), language_(language), rules_(language.rules), reads_(reads) {}

  std::size_t pos() const { return i; }
  /// A whole formula. False: fail() was called; so below.
  bool formula(Value& out) { return climb(rules_.formula_rank, out); }
  /// Signs and what they belong to.
  bool operand(Value& out);
  /// `[formula]`; the bracket is at pos().
  bool bracket(Value& out);
  /// `[formula relation formula]`, or a whole formula that is true or not: see FormulaRules.
  bool condition(bool& holds);

 protected:
  using Kind = FormulaFault::Kind;

  /// A variable, a number, a bracket or a function.
  bool primary(Value& out);
  bool number(double& out);

  char peek() const { return i < text_.size() ? text_[i] : '\0'; }
  bool at(std::string_view word) const {
    return rules_.either_case ? keywordAt(text_, i, word) : text_.substr(i).starts_with(word);
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++i;
    return true;
  }
  void passBlanks() {
    const char c = peek();  // mostly none of them
    if (isBlank(c) || c == '(') i = rules_.comments ? skipBlanks(text_, i) : behindBlanks(text_, i);
  }
  bool isNameLetter(char c) const { return rules_.either_case ? isLetter(c) : c >= 'A' && c <= 'Z'; }
  /// Behind the letters from pos() on.
  std::size_t behindLetters() const {
    std::size_t end = i;
    while (end < text_.size() && isNameLetter(text_[end])) ++end;
    return end;
  }
  bool failAt(Kind kind, std::size_t begin) { return self().fail({kind, begin, begin, i}); }

  // What a control may have anew.
  /// Operator `op` has been read behind `before` (null: it is the first) in a part of the formula that takes
  /// operators of `lowest` and higher ranks.
  void taken(const FormulaOperator& /*op*/, const FormulaOperator* /*before*/, int /*lowest*/) {}
  /// How a relation came out.
  void compared(const Value& /*left*/, const Value& /*right*/, bool /*holds*/) {}
  bool isTrue(double value) const { return value != 0.0; }
  /// Numbers that differ by less are equal.
  double tolerance() const { return 0.0; }
  /// A number from `begin` to pos() is read. False: it is refused.
  bool numberRead(std::size_t /*begin*/) { return true; }

  std::size_t i;  ///< the next character
  std::string_view text_;
  const FormulaLanguage& language_;
  const FormulaRules& rules_;
  std::vector<std::uint32_t>& reads_;
  int depth_ = 0;

 private:
  Control& self() { return static_cast<Control&>(*this); }

  bool climb(int lowest, Value& out);
  bool joined(int lowest, Value& out);
  bool joins(const FormulaOperator& op) const;
  bool content(Value& out) {
    return rules_.joins_relations && bracket_rank_ < rules_.formula_rank ? joinedContent(out)
                                                                         : climb(bracket_rank_, out);
  }
  bool joinedContent(Value& out) {
    const bool outside = std::exchange(relation_here_, false);
    const bool good = joined(0, out);
    // A bracket with relations is one itself to what stands around it.
    relation_here_ = outside || relation_here_;
    return good;
  }
  const FormulaOperator* operatorHere();
  bool combine(const FormulaOperator& op, std::size_t entry, std::size_t begin, Value& left,
               const Value& right);
  bool named(Value& out);
  const FormulaFunction* functionHere() const;
  bool apply(const FormulaFunction& function, Value& out);
  bool arguments(const FormulaFunction& function, Value& first, Value& second, bool& both);
  bool divisor(Value& out, bool& found);
  /// One formula in brackets, or two with a comma between; `second` null: one.
  bool list(Value& first, Value* second, bool& both);
  bool closeBracket(std::size_t begin);
  bool relation(Operation& out);

  int bracket_rank_ = rules_.formula_rank;  ///< lowest rank of the operators in brackets
  bool relation_here_ = false;              ///< the bracket in hand has a relation up to here
  std::size_t looked_at_ = std::string_view::npos;
  const FormulaOperator* here_ = nullptr;  ///< that stands at looked_at_
};

template <class Control>
const FormulaOperator* FormulaParser<Control>::operatorHere() {
  if (i == looked_at_) return here_;  // what ends a product is asked about by the sum as well
  looked_at_ = i;
  here_ = nullptr;
  const char c = upper(peek());
  for (const FormulaOperator& op : language_.operators.from(c)) {
    if (op.text[0] != c) break;
    if (op.text.size() != 1 && !at(op.text)) continue;
    here_ = &op;
    break;
  }
  return here_;
}

template <class Control>
bool FormulaParser<Control>::climb(int lowest, Value& out) {
  const std::size_t entry = i;
  passBlanks();
  const std::size_t begin = i;
  if (!operand(out)) return false;
  const FormulaOperator* before = nullptr;
  while (true) {
    const std::size_t behind = i;
    passBlanks();
    const FormulaOperator* const op = operatorHere();
    if (op == nullptr || op->rank < lowest) {
      if (!rules_.takes_blanks) i = behind;
      return true;
    }
    if (relation_here_ && joins(*op)) return true;
    relation_here_ = relation_here_ || isRelation(op->operation);
    i += op->text.size();
    self().taken(*op, before, lowest);
    Value right;
    if (!climb(op->from_right ? op->rank : op->rank + 1, right)) return false;
    if (!combine(*op, entry, begin, out, right)) return false;
    before = op;
  }
}

/// Whether a relation follows the operator, which stands at pos(), in the bracket in hand.
template <class Control>
bool FormulaParser<Control>::joins(const FormulaOperator& op) const {
  if (!rules_.joins_relations || !isBitOperation(op.operation)) return false;
  int depth = 0;
  bool letter = true;  // in front of here, so that words begin behind something else
  for (std::size_t k = i + op.text.size(); k < text_.size() && depth >= 0; k = skipBlanks(text_, k + 1)) {
    const char c = text_[k];
    depth += c == rules_.open ? 1 : c == rules_.close ? -1 : 0;
    if (!letter && isNameLetter(c)) {
      for (const FormulaOperator& other : language_.operators.from(upper(c))) {
        if (other.text[0] != upper(c)) break;
        if (isRelation(other.operation) && keywordAt(text_, k, other.text)) return true;
      }
    }
    letter = isLetter(c) || c == '_';
  }
  return false;
}

/// Relations that bit operators join. `lowest`: of the ranks of the operators.
template <class Control>
bool FormulaParser<Control>::joined(int lowest, Value& out) {
  const std::size_t entry = i;
  passBlanks();
  const std::size_t begin = i;
  if (!climb(bracket_rank_, out)) return false;
  while (true) {
    passBlanks();
    const FormulaOperator* const op = operatorHere();
    if (op == nullptr || op->rank < lowest || !isBitOperation(op->operation)) return true;
    i += op->text.size();
    relation_here_ = false;
    Value right;
    if (!joined(op->rank + 1, right) || !combine(*op, entry, begin, out, right)) return false;
    relation_here_ = true;
  }
}

template <class Control>
bool FormulaParser<Control>::combine(const FormulaOperator& op, std::size_t entry, std::size_t begin,
                                     Value& left, const Value& right) {
  double out = 0.0;
  if (isRelation(op.operation)) {
    const bool same = op.operation == Operation::kEqual || op.operation == Operation::kUnequal;
    const double near = rules_.exact_order && !same ? 0.0 : self().tolerance();
    const bool holds = related(op.operation, rules_.vacant, left, right, near);
    self().compared(left, right, holds);
    out = holds ? 1.0 : 0.0;
  } else if (op.operation >= Operation::kOr) {
    out = combined(op.operation, self().isTrue(left.number), self().isTrue(right.number)) ? 1.0 : 0.0;
  } else if (const Refusal refused = calculate(op.operation, rules_, left.number, right.number, out)) {
    return self().fail({Kind::kOperation, begin, entry, i, op.rank, *refused});
  }
  left = {out, false};
  return true;
}

template <class Control>
bool FormulaParser<Control>::operand(Value& out) {
  const std::size_t entry = i;
  passBlanks();
  const std::size_t begin = i;
  const bool counts_signs = rules_.depth == FormulaDepth::kBrackets;
  int signs = 0;
  bool minus = false;
  for (char c = peek(); c == '+' || c == '-'; c = peek()) {
    if (signs > 0 && !rules_.many_signs) break;
    minus = minus != (c == '-');
    if (counts_signs && depth_ + signs >= rules_.most_depth) return failAt(Kind::kTooDeep, i);
    ++signs;
    ++i;
    passBlanks();
  }
  if (!counts_signs && depth_ >= rules_.most_depth) return self().fail({Kind::kTooDeep, begin, entry, i});
  const int levels = counts_signs ? signs : 1;
  depth_ += levels;
  if (!primary(out)) return false;
  depth_ -= levels;
  if (signs > 0) out = {minus ? -out.number : out.number, false};
  return true;
}

template <class Control>
bool FormulaParser<Control>::primary(Value& out) {
  const char c = peek();
  if (c == rules_.variable && c != '\0') return self().variable(out);
  if (isDigit(c) || c == '.') {
    out.vacant = false;
    return number(out.number);
  }
  if (c == rules_.open) return bracket(out);
  if (isNameLetter(c)) return named(out);
  return failAt(Kind::kNoOperand, i);
}

template <class Control>
bool FormulaParser<Control>::number(double& out) {
  const std::size_t begin = i;
  const PlainNumber read = plainNumberAt(text_, begin);
  i = read.end;
  if (peek() == '.' && !rules_.point_ends) return failAt(Kind::kSecondPoint, begin);
  if (read.digits == 0) return failAt(Kind::kNoDigits, begin);
  if (read.exact()) {
    out = read.value();
  } else if (std::from_chars(text_.data() + begin, text_.data() + i, out, std::chars_format::fixed).ec !=
             std::errc()) {
    return failAt(Kind::kBeyondRange, begin);
  }
  return self().numberRead(begin);
}

template <class Control>
bool FormulaParser<Control>::bracket(Value& out) {
  bool both = false;
  return list(out, nullptr, both);
}

template <class Control>
bool FormulaParser<Control>::list(Value& first, Value* second, bool& both) {
  const std::size_t begin = i++;
  const int levels = rules_.depth == FormulaDepth::kBrackets ? 1 : 0;
  if (levels > 0 && depth_ >= rules_.most_depth) return failAt(Kind::kTooDeep, begin);
  depth_ += levels;
  if (!content(first)) return false;
  if (second != nullptr) {
    passBlanks();
    both = take(',');
    if (both && !climb(bracket_rank_, *second)) return false;
  }
  depth_ -= levels;
  return closeBracket(begin);
}

template <class Control>
bool FormulaParser<Control>::closeBracket(std::size_t begin) {
  const std::size_t end = i;
  passBlanks();
  return take(rules_.close) || self().fail({Kind::kNoBracket, begin, begin, end});
}

template <class Control>
const FormulaFunction* FormulaParser<Control>::functionHere() const {
  const char c = upper(peek());
  const std::size_t letters = rules_.prefix_names ? 0 : behindLetters() - i;
  for (const FormulaFunction& function : language_.functions.from(c)) {
    if (function.text[0] != c) break;
    if (at(function.text) && (rules_.prefix_names || function.text.size() == letters)) return &function;
  }
  return nullptr;
}

template <class Control>
bool FormulaParser<Control>::named(Value& out) {
  const FormulaFunction* const function = functionHere();
  if (function == nullptr) return self().otherName(out);
  return function->special > 0 ? self().special(function->special, *function, out) : apply(*function, out);
}

template <class Control>
bool FormulaParser<Control>::arguments(const FormulaFunction& function, Value& first, Value& second,
                                       bool& both) {
  const std::size_t begin = i;
  i += function.text.size();
  if (rules_.argument == FormulaArgument::kOperand && function.two == nullptr) return operand(first);
  const std::size_t end = i;
  if (rules_.argument != FormulaArgument::kBracketAtOnce) passBlanks();
  if (peek() != rules_.open)
    return self().fail({Kind::kNoArgument, begin, begin, end, 0, SharedAlarm::kSyntax, function.text});
  if (function.two == nullptr) return bracket(first);
  const bool lists = function.second.find(',') != std::string_view::npos;
  if (!list(first, lists ? &second : nullptr, both)) return false;
  return both || function.second.find('/') == std::string_view::npos || divisor(second, both);
}

/// The second argument of f[x]/[y]; what else stands behind the slash is divided by.
template <class Control>
bool FormulaParser<Control>::divisor(Value& out, bool& found) {
  const std::size_t behind = i;
  if (rules_.quotient_blanks) passBlanks();
  if (take('/')) {
    if (rules_.quotient_blanks) passBlanks();
    found = peek() == rules_.open;
    if (found) return bracket(out);
  }
  i = behind;
  return true;
}

template <class Control>
bool FormulaParser<Control>::apply(const FormulaFunction& function, Value& out) {
  const std::size_t begin = i;
  Value x, y;
  bool both = false;
  if (!arguments(function, x, y, both)) return false;
  FormulaFault fault{Kind::kFunction, begin, begin, i, 0, {}, function.text, x.number};
  if (!both && function.one == nullptr) {
    fault.kind = Kind::kNoSecond;
    return self().fail(fault);
  }
  double value = 0.0;
  Refusal refused = both ? function.two(x.number, y.number, value) : function.one(x.number, value);
  if (!refused && rules_.refuses_infinite && !std::isfinite(value)) refused = SharedAlarm::kValueLimit;
  if (refused) {
    fault.refusal = *refused;
    return self().fail(fault);
  }
  out = {value, false};
  return true;
}

template <class Control>
bool FormulaParser<Control>::relation(Operation& out) {
  passBlanks();
  const FormulaOperator* const op = operatorHere();
  if (op == nullptr || !isRelation(op->operation)) return failAt(Kind::kNoRelation, i);
  i += op->text.size();
  out = op->operation;
  return true;
}

template <class Control>
bool FormulaParser<Control>::condition(bool& holds) {
  passBlanks();
  const std::size_t begin = i;
  if (peek() != rules_.open) return failAt(Kind::kNoCondition, begin);
  Value left, right;
  if (rules_.whole_conditions) {
    bracket_rank_ = 0;
    const bool good = bracket(left);
    bracket_rank_ = rules_.formula_rank;
    if (good && left.vacant && rules_.refuses_vacant_condition) return failAt(Kind::kNoCondition, begin);
    holds = good && self().isTrue(left.number);
    return good;
  }
  ++i;
  Operation asked = Operation::kEqual;
  if (!formula(left) || !relation(asked) || !formula(right)) return false;
  passBlanks();
  if (!take(rules_.close)) return failAt(Kind::kConditionGoesOn, begin);
  holds = related(asked, rules_.vacant, left, right, self().tolerance());
  self().compared(left, right, holds);
  return true;
}

}  // namespace proveout::nc
