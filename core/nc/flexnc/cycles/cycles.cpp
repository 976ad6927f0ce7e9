// Which cycle a call asks for.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/nc/flexnc/cycles/cycle_call.h"
#include "core/nc/flexnc/cycles/cycle_checks.h"
#include "core/nc/flexnc/cycles/special_cycles.h"
#include "core/nc/flexnc/template/template_check.h"
#include "core/nc/flexnc/template/template_passes.h"
#include "core/nc/flexnc/template/template_table.h"

namespace proveout::nc {

namespace {

struct SpecialRow {
  CycleCode code;
  AddressSet required, optional;
  void (*perform)(const CycleCall& call, CycleAnswer& answer);
};

/// The blocks of G76 have letters of their own, which they look at.
constexpr auto kSpecialRows = std::to_array<SpecialRow>({
    {CycleCode::kG79, "XYZPCB", "", faceEnd},
    {CycleCode::kG5, "PYZB", "V", drillDeep},
    {CycleCode::kG79_1, "XAHPCYQ", "V", cutRadialGroove},
    {CycleCode::kG79_2, "XAZPBHQ", "V", cutFaceGroove},
    {CycleCode::kG76, "", "XZPQRF", cutThread},
    {CycleCode::kG30, "AXZRQFHPULK", "", cutWorm},
});

const SpecialRow* findSpecial(CycleCode code) {
  const auto found = std::find_if(kSpecialRows.begin(), kSpecialRows.end(),
                                  [code](const SpecialRow& row) { return row.code == code; });
  return found == kSpecialRows.end() ? nullptr : &*found;
}

void performTemplate(const CycleCall& call, const TemplateRow& row, CycleAnswer& answer) {
  TemplateCheck check = checkTemplate(row, call.arguments);
  answer.warnings = std::move(check.warnings);
  answer.alarm = check.alarm;
  if (answer.alarm) return;
  const TemplateInput input = templateInput(row, call.arguments, call.arc_view);
  const TemplateResult made = templateProfile(input);
  answer.alarm = made.alarm;
  if (answer.alarm) return;
  if (check.form == TemplateForm::kRoughing) {
    roughTemplate(call, input, made.profile, answer);
  } else {
    cutTemplateContour(call, input, made.profile, check.goes_on, answer);
  }
}

}  // namespace

bool CycleArguments::set(char letter, double value) {
  if (has(letter)) return false;
  present_.add(letter);
  values_[index(letter)] = value;
  return true;
}

std::optional<CycleCode> cycleCode(double number) {
  const double tenths = std::round(10.0 * number);
  if (!(std::abs(10.0 * number - tenths) < 1e-6) || std::abs(tenths) > 1000.0) return std::nullopt;
  const auto code = static_cast<CycleCode>(static_cast<int>(tenths));
  return findTemplate(code) || findSpecial(code) ? std::optional(code) : std::nullopt;
}

std::string cycleName(CycleCode code) { return fmt::format("G{:g}", static_cast<int>(code) / 10.0); }

AddressSet cycleAddresses(CycleCode code) {
  if (const TemplateRow* row = findTemplate(code)) return row->shape_letters | AddressSet("ZPCBVK");
  const SpecialRow* row = findSpecial(code);
  return row ? row->required | row->optional : AddressSet();
}

bool isTemplate(CycleCode code) { return findTemplate(code) != nullptr; }

CycleAnswer performCycle(const CycleCall& call) {
  CycleAnswer answer;
  if (const TemplateRow* row = findTemplate(call.code)) {
    performTemplate(call, *row, answer);
  } else if (const SpecialRow* special = findSpecial(call.code)) {
    answer.alarm = checkLetters(call.code, call.arguments, special->required, special->optional);
    if (!answer.alarm) special->perform(call, answer);
  }
  if (answer.alarm) answer.moves.clear();
  return answer;
}

}  // namespace proveout::nc
