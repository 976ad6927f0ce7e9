#include "core/nc/macro/formula_values.h"

#include <limits>

namespace proveout::nc {

namespace {

double modulo(Operation operation, double a, double b) {
  const double rest = std::fmod(a, b);
  return operation == Operation::kModuloPositive && rest < 0.0 ? rest + std::abs(b) : rest;
}

}  // namespace

Refusal calculateRarely(Operation operation, const FormulaRules& rules, double a, double b, double& out) {
  switch (operation) {
    case Operation::kModulo:
    case Operation::kModuloPositive:
      if (b == 0.0 && rules.refuses_zero) return SharedAlarm::kDivision;
      out = modulo(operation, a, b);
      return {};
    case Operation::kPower:
      out = std::pow(a, b);
      return {};
    case Operation::kBitOr:
      return applyLogic(LogicOperator::kOr, a, b, out);
    case Operation::kBitXor:
      return applyLogic(LogicOperator::kXor, a, b, out);
    case Operation::kBitAnd:
      return applyLogic(LogicOperator::kAnd, a, b, out);
    default:
      return SharedAlarm::kNotImplemented;
  }
}

bool related(Operation relation, double a, double b, double tolerance) {
  const bool equal = a == b || std::abs(a - b) < tolerance;
  switch (relation) {
    case Operation::kEqual:
      return equal;
    case Operation::kUnequal:
      return !equal;
    case Operation::kLess:
      return a < b && !equal;
    case Operation::kLessEqual:
      return a < b || equal;
    case Operation::kGreater:
      return a > b && !equal;
    case Operation::kGreaterEqual:
      return a > b || equal;
    default:
      return false;
  }
}

bool related(Operation relation, VacantRelation vacant, const Value& a, const Value& b, double tolerance) {
  constexpr double kAbove = std::numeric_limits<double>::infinity();
  const bool asks_same = relation == Operation::kEqual || relation == Operation::kUnequal;
  const bool above =
      vacant == VacantRelation::kAboveAll || (vacant == VacantRelation::kOnlyEqual && asks_same);
  const auto side = [above](const Value& v) { return !v.vacant ? v.number : above ? kAbove : 0.0; };
  return related(relation, side(a), side(b), tolerance);
}

}  // namespace proveout::nc
