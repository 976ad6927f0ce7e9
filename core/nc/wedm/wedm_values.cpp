// Numbers and expressions of the wire EDM control (digest wedm, D3): without a point they count least
// increments.
#include <fmt/core.h>

#include <cmath>

#include "core/nc/wedm/wedm_plan.h"

namespace proveout::nc {

namespace {

constexpr double kLeastMm = 0.001, kLeastInch = 0.0001;
constexpr int kLastH = 99;
constexpr double kMostValue = 1e7;  ///< mm; far above what any word may hold

/// Sum of the terms; `point` and `no_point` are what 1 is worth with a decimal point and without.
std::optional<double> sumOf(WedmContext& c, const std::vector<WedmTerm>& terms, double point, double no_point,
                            double of_h, Columns at) {
  double sum = 0.0;
  for (const WedmTerm& term : terms) {
    if (term.h < 0) {
      sum += term.number * (term.point ? point : no_point);
      continue;
    }
    if (term.h > kLastH) c.report.warnOnce("wedm-12-H-range", "the control has H000 to H099", term.columns);
    if (!c.variables.assigned(term.h))
      c.report.warnOnce(fmt::format("wedm-12-H{:03}", term.h),
                        fmt::format("H{:03} has no value: 0 is taken", term.h), term.columns);
    sum += term.number * c.variables.value(term.h) * of_h;
  }
  if (std::abs(sum) < kMostValue) return sum;
  c.report.fail("wedm-1.4-ranges", "the value is too large", at);
  return std::nullopt;
}

}  // namespace

std::optional<double> wedmLength(WedmContext& c, const WedmState& s, const std::vector<WedmTerm>& terms,
                                 Columns at) {
  const bool inch = s.units == 20;
  return sumOf(c, terms, inch ? kInchMm : 1.0, inch ? kLeastInch * kInchMm : kLeastMm, 1.0, at);
}

std::optional<double> wedmSeconds(WedmContext& c, const WedmState& s, const std::vector<WedmTerm>& terms,
                                  Columns at) {
  const auto seconds = sumOf(c, terms, 1.0, 0.001, s.units == 20 ? 1.0 / kInchMm : 1.0, at);
  if (!seconds || *seconds >= 0.0) return seconds;
  c.report.fail("wedm-5-G04", "a dwell cannot be negative", at);
  return std::nullopt;
}

}  // namespace proveout::nc
