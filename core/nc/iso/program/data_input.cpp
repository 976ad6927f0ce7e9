// G10 and G11: data input by programs (manual 10.2, 12.4, 15.2, 24.1).
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/plans.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {
namespace {

bool planParameterInput(IsoContext& c, BlockPlan& plan);

/// What G10 does by its L.
struct InputForm {
  int l;
  PlanFunction plan;
};
constexpr auto kForms = std::to_array<InputForm>({
    {2, planWorkOffset},
    {10, planMillingOffset},
    {11, planMillingOffset},
    {12, planMillingOffset},
    {13, planMillingOffset},
    {20, planWorkOffset},
    {21, planDynamicOffset},
    {52, planParameterInput},
    {110, planMillingOffset},
    {111, planMillingOffset},
    {75, planToolInput},
    {76, planToolInput},
    {77, planToolInput},
    {200, planTurningOffset},
    {201, planTurningOffset},
    {202, planTurningOffset},
    {203, planTurningOffset},
});

/// The word of a parameter block, with its range. False: reported.
bool dataWord(IsoContext& c, Address address, std::int64_t min, std::int64_t max, std::int64_t missing,
              std::int64_t& out) {
  out = missing;
  const Word* w = c.word(address);
  return w == nullptr || integerWord(c, *w, min, max, out);
}

bool refuseParameter(IsoContext& c, ParamStatus status, std::int64_t number) {
  switch (status) {
    case ParamStatus::kOk:
      return true;
    case ParamStatus::kUnknown:
      return c.alarm(SharedAlarm::kOutOfRange, *c.word('N'), "the simulation knows no such parameter");
    case ParamStatus::kNeedsBit:
      return c.alarm(SharedAlarm::kMissingData, "Q", "the parameter consists of bits");
    case ParamStatus::kNeedsIndex:
      return c.alarm(SharedAlarm::kMissingData, "P", "the parameter belongs to an axis or a spindle");
    case ParamStatus::kBadIndex:
      return c.alarm(SharedAlarm::kOutOfRange, *c.word('P'), "there is no such channel, axis or spindle");
    case ParamStatus::kOutOfRange:
      return c.alarm(SharedAlarm::kOutOfRange, *c.word('R'), "beyond the limits of the parameter");
    case ParamStatus::kRestart:
      return c.alarm(SharedAlarm::kParameterLocked, fmt::format("N{:04}", number));
  }
  return false;
}

/// A block between G10 L52 and G11: N number, P channel, axis or spindle, Q bit, R value.
bool parameterBlock(IsoContext& c) {
  for (const Word& w : c.block.words) {
    if (!AddressSet("NPQR").has(w.address))
      return c.alarm(SharedAlarm::kIllegalAddress, w, "in parameter input (G10 L52)");
  }
  const Word* n = c.word('N');
  const Word* r = c.word('R');
  std::int64_t number = 0, index = 0, bit = 0;
  if (n == nullptr) return c.alarm(SharedAlarm::kMissingData, "N", "the number of the parameter");
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "the value of the parameter");
  if (!dataWord(c, 'N', 0, 9999, 0, number) || !dataWord(c, 'P', 1, kParamAxes, 0, index) ||
      !dataWord(c, 'Q', 0, 7, kWholeParam, bit)) {
    return false;
  }
  const ParamStatus status = c.parameters.write(static_cast<int>(number), static_cast<int>(bit),
                                                static_cast<int>(index), r->value, r->incremental);
  if (!refuseParameter(c, status, number)) return false;
  configureFeeds(c);
  return true;
}

bool openParameterInput(IsoContext& c, BlockPlan&) {
  c.data_input = parameterBlock;
  return true;
}

bool planParameterInput(IsoContext& c, BlockPlan& plan) {
  if (c.block.words.size() > 2)
    return c.alarm(SharedAlarm::kIllegalAddress, c.block.words[2], "G10 L52 stands alone");
  plan.perform = openParameterInput;
  return true;
}

}  // namespace

bool planDataInput(IsoContext& c, BlockPlan& plan) {
  const Word* l = c.ownWord(plan, 'L');
  std::int64_t kind = 0;
  if (l == nullptr) return c.alarm(SharedAlarm::kMissingData, "L", "G10 needs L");
  if (!integerWord(c, *l, 0, 9999, kind)) return false;
  const auto form =
      std::find_if(kForms.begin(), kForms.end(), [&](const InputForm& f) { return f.l == kind; });
  if (form != kForms.end()) return form->plan(c, plan);
  return c.alarm(SharedAlarm::kNotImplemented, fmt::format("G10 L{} is not supported", kind), {}, l->columns);
}

bool planEndOfData(IsoContext&, BlockPlan&) { return true; }

bool dataBlock(IsoContext& c) {
  const Word* g = c.word('G');
  if (g == nullptr) return c.data_input(c);
  if (g->value != 11.0) return c.alarm(SharedAlarm::kIllegalAddress, *g, "data input is open: G11 ends it");
  if (c.block.words.size() > 1)
    return c.alarm(SharedAlarm::kIllegalAddress, c.block.words[1], "G11 stands alone");
  c.data_input = nullptr;
  return true;
}

}  // namespace proveout::nc
