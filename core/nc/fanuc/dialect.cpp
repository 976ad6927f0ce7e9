#include "core/nc/fanuc/dialect.h"

#include "core/nc/fanuc/alarms.h"
#include "core/nc/fanuc/block/plan.h"
#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/formulas.h"
#include "core/nc/fanuc/haas/haas.h"
#include "core/nc/fanuc/macro/macro_rules.h"
#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/system_variables/fanuc_banks.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/fanuc/text/decimal.h"

namespace proveout::nc {
namespace {

LexRules fanucLexing() {
  LexRules rules;
  rules.keep_repeats = true;
  rules.incremental_operator = false;
  rules.names_variables = true;
  rules.comments_end_in_line = true;
  rules.semicolon_ends_block = true;
  rules.colon_program = true;
  rules.named_programs = true;
  rules.number_alarms = true;
  rules.skip_anywhere = true;
  rules.unsigned_addresses = "ONGFTHDLMSP";
  return rules;
}

IsoDialect dialectOf(std::string_view name, const CodeIndex& codes) {
  IsoRules rules;
  rules.last_of_group = true;
  rules.keeps_return_level = true;
  rules.motion_or_cycle = true;
  rules.m_words = 1;
  rules.probe_in_transforms = true;
  rules.loose_arcs = true;
  rules.short_radius_is_half = true;
  IsoDialect dialect{
      .name = name,
      .alarms = fanucAlarms(),
      .codes = codes,
      .parameters = fanucParameters(),
      .formulas = fanucFormulas(),
      .lexing = fanucLexing(),
      .layout = ProgramLayout::kSeveralInAFile,
      .rules = rules,
      .check_block = followRigidTap,
      .maker_data = makeFanucData,
      .plan = planFanuc,
      .take_words = takeFanucWords,
      .unknown_m = fanucUnknownM,
      .end_shifts = fanucEndShifts,
      .begin = fanucBegin,
      .power_on = fanucPowerOn,
  };
  takeMacroRules(dialect, name == "fanuc-lathe");
  return dialect;
}

/// The flavour of Haas.
IsoDialect haasOf(IsoDialect dialect) {
  constexpr int kLocalCall = 97;
  dialect.rules.last_of_group = false;
  dialect.rules.local_call = kLocalCall;
  dialect.work_system = haasWorkSystem;
  return dialect;
}

bool chosen(const std::map<std::string, double>& settings, FanucParam p) {
  const auto given = settings.find(std::string(fanucParameters().row(p).name));
  return given != settings.end() && given->second != 0.0;
}

}  // namespace

const CodeIndex& fanucMillCodes() {
  static const CodeIndex kIndex({fanucMotionTable(), fanucFramesTable(), fanucCompTable(), fanucCyclesTable(),
                                 fanucTransformsTable(), fanucMacroTable()});
  return kIndex;
}

const CodeIndex& haasMillCodes() {
  static const CodeIndex kIndex({fanucMotionTable(), fanucFramesTable(), fanucCompTable(), fanucCyclesTable(),
                                 fanucTransformsTable(), fanucMacroTable()},
                                {haasMillTable()});
  return kIndex;
}

const CodeIndex& fanucLatheCodes() {
  static const CodeIndex kIndex(
      {fanucMotionTable(), fanucFramesTable(), fanucCompTable(), fanucTransformsTable(), fanucMacroTable()});
  return kIndex;
}

const IsoDialect& fanucMillDialect(const std::map<std::string, double>& settings) {
  static const IsoDialect kMill = dialectOf("fanuc-mill", fanucMillCodes());
  static const IsoDialect kHaas = haasOf(dialectOf("fanuc-mill", haasMillCodes()));
  return macroVariant(chosen(settings, FanucParam::kFlavour) ? kHaas : kMill, settings);
}

const IsoDialect& fanucLatheDialect(const std::map<std::string, double>& settings) {
  static const IsoDialect kLathe = dialectOf("fanuc-lathe", fanucLatheCodes());
  return macroVariant(kLathe, settings);
}

}  // namespace proveout::nc
