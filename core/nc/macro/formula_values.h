// What the operators of formulas make of their sides.
#pragma once

#include <cmath>

#include "core/nc/macro/formula_language.h"
#include "core/nc/macro/value.h"

namespace proveout::nc {

/// Powers, remainders and bits.
Refusal calculateRarely(Operation operation, const FormulaRules& rules, double a, double b, double& out);

/// Of the operators that are neither relations nor of truths. kDivision, kBits or kValueLimit where the rules
/// refuse sides or result.
inline Refusal calculate(Operation operation, const FormulaRules& rules, double a, double b, double& out) {
  switch (operation) {
    case Operation::kAdd:
      out = a + b;
      break;
    case Operation::kSubtract:
      out = a - b;
      break;
    case Operation::kMultiply:
      out = a * b;
      break;
    case Operation::kDivide:
      if (b == 0.0 && rules.refuses_zero) return SharedAlarm::kDivision;
      out = a / b;
      break;
    default:
      if (const Refusal refused = calculateRarely(operation, rules, a, b, out)) return refused;
  }
  if (rules.refuses_infinite && !std::isfinite(out)) return SharedAlarm::kValueLimit;
  return {};
}

/// Numbers that differ by less than `tolerance` are equal.
bool related(Operation relation, double a, double b, double tolerance);
/// The same with vacant values.
bool related(Operation relation, VacantRelation vacant, const Value& a, const Value& b, double tolerance);

/// kAnd, kOr and kXor of two truths.
constexpr bool combined(Operation operation, bool a, bool b) {
  return operation == Operation::kAnd ? a && b : operation == Operation::kXor ? a != b : a || b;
}

}  // namespace proveout::nc
