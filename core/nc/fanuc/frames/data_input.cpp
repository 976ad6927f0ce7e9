// G10 (iso-fanuc, section 6).
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/tools/offsets.h"
#include "core/nc/iso/context/plans.h"

namespace proveout::nc {
namespace {

bool refuseWords(IsoContext& c, AddressSet words, const char* where) {
  for (const Word& w : c.block.words) {
    if (words.has(w.address)) return c.alarm(SharedAlarm::kIllegalAddress, w, where);
  }
  return true;
}

bool planFanucFrame(IsoContext& c, BlockPlan& plan) {
  const bool basic = c.word('L')->value == 2.0;
  std::int64_t row = 0;
  return refuseWords(c, "RQIJK", "in G10 L2, L20") &&
         fanucDataRow(c, plan, "031", basic ? 0 : 1, basic ? 6 : c.dialect.rules.extended_systems, row) &&
         planWorkOffset(c, plan);
}

/// What G10 does by its L.
struct FanucInputForm {
  int l;
  PlanFunction plan;
};
constexpr auto kFanucInputForms = std::to_array<FanucInputForm>({
    {1, planFanucToolOffset},
    {2, planFanucFrame},
    {3, planFanucToolLife},
    {10, planFanucToolOffset},
    {11, planFanucToolOffset},
    {12, planFanucToolOffset},
    {13, planFanucToolOffset},
    {20, planFanucFrame},
    {21, planDynamicOffset},
    {50, planFanucParameters},
    {52, planFanucParameters},
});

}  // namespace

bool fanucDataRow(IsoContext& c, const BlockPlan& plan, const char* number, std::int64_t min,
                  std::int64_t max, std::int64_t& row) {
  const Word* p = c.ownWord(plan, 'P');
  if (p == nullptr)
    return c.fail(number,
                  fmt::format("illegal P command in G10: P is missing; it is {} to {} here", min, max));
  const double value = p->from_expression ? std::round(p->value) : p->value;
  const bool whole = p->is_integer || p->from_expression;
  if (!whole || !(value >= static_cast<double>(min) && value <= static_cast<double>(max))) {
    return c.failWord(number,
                      fmt::format("illegal P command in G10: P{:g}; an integer from {} to {} is expected",
                                  p->value, min, max),
                      *p);
  }
  row = static_cast<std::int64_t>(value);
  return true;
}

bool planFanucDataInput(IsoContext& c, BlockPlan& plan) {
  const Word* l = c.ownWord(plan, 'L');
  if (l == nullptr) {
    // Old controls with one table have no L for it.
    if (c.block.present.has('R') && fanucOffsetMemory(c) == FanucMemory::kA)
      return planFanucToolOffset(c, plan);
    return c.alarm(SharedAlarm::kMissingData, "L",
                   "G10 needs L: 2 and 20 work frames, 10 to 13 tool offsets, 52 parameters");
  }
  std::int64_t kind = 0;
  if (!integerWord(c, *l, 0, 9999, kind)) return false;
  const auto* const form = std::find_if(kFanucInputForms.begin(), kFanucInputForms.end(),
                                        [&](const FanucInputForm& f) { return f.l == kind; });
  if (form != kFanucInputForms.end()) return form->plan(c, plan);
  return c.alarm(SharedAlarm::kNotImplemented, fmt::format("G10 L{} is not supported", kind), {}, l->columns);
}

}  // namespace proveout::nc
