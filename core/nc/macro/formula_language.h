// The language of formulas of a control as a table: operators, functions, brackets, and how blanks, signs,
// numbers and vacant values count. FormulaParser reads formulas by it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>

#include "core/nc/macro/functions.h"

namespace proveout::nc {

enum class Operation : std::uint8_t {
  kEnd,  ///< ends the formula, as a comment does
  kAdd,
  kSubtract,
  kMultiply,
  kDivide,
  kModulo,          ///< has the sign of the dividend
  kModuloPositive,  ///< is never negative
  kPower,
  kBitOr,  ///< of 32-bit integers, as applyLogic has it; so below
  kBitXor,
  kBitAnd,
  kOr,  ///< of truths: 1 or 0; so below
  kXor,
  kAnd,
  kEqual,  ///< from here on relations: 1 or 0
  kUnequal,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual
};

constexpr bool isRelation(Operation operation) { return operation >= Operation::kEqual; }

constexpr bool isBitOperation(Operation operation) {
  return operation >= Operation::kBitOr && operation <= Operation::kBitAnd;
}

struct FormulaOperator {
  std::string_view text;  ///< upper case
  int rank = 0;           ///< what binds closer has a higher one; kEnd: below all
  Operation operation = Operation::kEnd;
  bool from_right =
      false;  ///< a ** b ** c is a ** (b ** c); false: operators of a rank go from left to right
};

struct FormulaFunction {
  std::string_view text;  ///< upper case
  /// Null: a second argument must follow.
  Refusal (*one)(double x, double& out) = nullptr;
  /// Null: takes one argument only.
  Refusal (*two)(double x, double y, double& out) = nullptr;
  /// How a second argument is written: '/' f[x]/[y], ',' f[x,y]; one of them or both.
  std::string_view second = "/";
  /// Above 0: what stands behind the name is read by the control itself, which gets this number.
  int special = 0;
};

/// What the argument of a function is.
enum class FormulaArgument : std::uint8_t {
  kOperand,       ///< SIN30, SIN-#1, SIN[30]
  kBracket,       ///< SIN (30)
  kBracketAtOnce  ///< SIN(30)
};

/// What is counted against the greatest depth.
enum class FormulaDepth : std::uint8_t {
  kOperands,  ///< operands inside operands
  kBrackets   ///< brackets, and signs in front of operands
};

/// What vacant values are in relations; elsewhere they count as 0.
enum class VacantRelation : std::uint8_t {
  kZero,       ///< 0 as elsewhere
  kAboveAll,   ///< equal to each other and above every number
  kOnlyEqual,  ///< equal to each other and to no number; 0 where more and less are asked
};

struct FormulaRules {
  char open = '[', close = ']';
  char variable = '#';            ///< the control reads what begins with it
  bool either_case = true;        ///< false: capitals only
  bool comments = true;           ///< (comments) count as blanks
  bool many_signs = true;         ///< false: one sign in front of an operand at most
  bool prefix_names = true;       ///< SINA is SIN of A; false: a name is all letters that stand together
  bool point_ends = false;        ///< a second point ends a number; false: is refused
  bool takes_blanks = false;      ///< a formula goes on behind the blanks that follow it
  bool quotient_blanks = true;    ///< f[x] / [y] with blanks
  bool refuses_zero = true;       ///< as a divisor; false: the quotient is infinite
  bool refuses_infinite = true;   ///< results of every step; false: the control looks at the last one
  bool whole_conditions = false;  ///< conditions are formulas with all operators; false: one relation
  /// In a bracket with relations, bit operators between two of these join them, lower than the relations:
  /// [#1 EQ 1 AND #2 GT 3].
  bool joins_relations = false;
  bool bracket_names = false;  ///< #[_NAME] too
  bool refuses_vacant_condition =
      false;             ///< a condition without a value is an error; false: it does not hold
  bool exact_order = false;  ///< the tolerance of numbers counts for equal and unequal alone
  int formula_rank = 0;  ///< operators below stand in conditions only
  int most_depth = 64;
  FormulaDepth depth = FormulaDepth::kOperands;
  FormulaArgument argument = FormulaArgument::kOperand;
  VacantRelation vacant = VacantRelation::kZero;
};

/// Rows that begin with the same character stand together, longer ones before those that they begin with.
template <class Row>
class FormulaRows {
 public:
  constexpr FormulaRows() = default;
  template <std::size_t kCount>
  constexpr explicit FormulaRows(const std::array<Row, kCount>& rows) : rows_(rows) {
    static_assert(kCount < kNone);
    first_.fill(kNone);
    for (std::size_t k = 0; k < kCount; ++k) {
      std::uint8_t& first = first_[static_cast<unsigned char>(rows[k].text[0]) % kCharacters];
      if (first == kNone) first = static_cast<std::uint8_t>(k);
      const bool apart = k > 0 && first != k && rows[k - 1].text[0] != rows[k].text[0];
      for (std::size_t shorter = first; shorter < k; ++shorter)
        if (apart || rows[k].text.starts_with(rows[shorter].text)) throw std::logic_error("order of rows");
    }
  }
  /// Rows from the first one that begins with `c` on; none: empty.
  constexpr std::span<const Row> from(char c) const {
    const auto at = static_cast<unsigned char>(c);
    if (at >= kCharacters || first_[at] == kNone) return {};
    return rows_.subspan(first_[at]);
  }

 private:
  static constexpr std::size_t kCharacters = 128;
  static constexpr std::uint8_t kNone = 0xFF;
  std::span<const Row> rows_;
  std::array<std::uint8_t, kCharacters> first_{};
};

/// The arrays handed in must outlive the language.
struct FormulaLanguage {
  FormulaRules rules;
  FormulaRows<FormulaOperator> operators;
  FormulaRows<FormulaFunction> functions;
};

}  // namespace proveout::nc
