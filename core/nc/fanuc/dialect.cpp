#include "core/nc/fanuc/dialect.h"

#include <algorithm>
#include <array>

#include "core/nc/fanuc/alarms.h"
#include "core/nc/fanuc/block/plan.h"
#include "core/nc/fanuc/cycles/fanuc_cycles.h"
#include "core/nc/fanuc/frames/frames.h"
#include "core/nc/fanuc/haas/haas.h"
#include "core/nc/fanuc/lathe/lathe_hooks.h"
#include "core/nc/fanuc/macro/formulas.h"
#include "core/nc/fanuc/macro/macro_rules.h"
#include "core/nc/fanuc/model/fanuc_data.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/system_variables/fanuc_banks.h"
#include "core/nc/fanuc/system_variables/haas_bank.h"
#include "core/nc/fanuc/tables/tables.h"
#include "core/nc/fanuc/text/decimal.h"
#include "core/nc/fanuc/tools/offsets.h"

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
  rules.unsigned_addresses = "ONGFTHDLMS";
  return rules;
}

IsoDialect dialectOf(std::string_view name, const CodeIndex& codes) {
  IsoRules rules;
  rules.last_of_group = true;
  rules.keeps_return_level = true;
  rules.motion_or_cycle = true;
  rules.cycles_in_comp = name == "fanuc-mill";
  rules.m_words = 1;
  rules.probe_in_transforms = true;
  rules.loose_arcs = true;
  rules.short_radius_is_half = true;
  rules.holds_length = true;
  rules.scales_centres = true;
  rules.local_shift_absolute = true;
  rules.dynamic_zero_off = true;
  rules.extended_systems = 300;
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
      .offsets = fanucOffsets,
      .usual_systems = fanucWorkSystem,
      .transforms_off = fanucTransformsOff,
      .length_axes = fanucLengthAxes,
      .compensation = fanucCompensation,
  };
  takeMacroRules(dialect, name == "fanuc-lathe");
  return dialect;
}

/// The flavour of Haas.
IsoDialect haasOf(IsoDialect dialect) {
  constexpr int kLocalCall = 97;
  constexpr int kHaasAlarms = 1000;  // #3000=1 is alarm 1001 there
  dialect.rules.last_of_group = false;
  dialect.rules.local_call = kLocalCall;
  dialect.work_system = haasWorkSystem;
  dialect.lexing.short_while = true;
  dialect.messages.alarm = kHaasAlarms;
  dialect.rules.words_behind_if = true;
  const bool lathe = dialect.name == "fanuc-lathe";
  dialect.system_variables = lathe ? haasLatheBanks : haasMillBanks;
  return dialect;
}

IsoDialect latheDialect(GCodeSystem system, bool haas) {
  IsoDialect d = dialectOf("fanuc-lathe", fanucLatheCodes(system, haas));
  d.lexing.unsigned_addresses = "ONGFTDLMS";  // H is a step of C
  d.rules.offsets_by_tool = true;
  d.rules.set_position_steps = true;
  d.rules.directions_meet = true;
  d.maker_data = makeLatheData;
  d.take_words = takeLatheWords;
  d.plan = planLatheBlock;
  d.power_on = latheAtPowerOn;
  d.begin = latheBegin;
  d.tool = planLatheTool;
  d.lines_done = endLatheLines;
  return haas ? haasOf(d) : d;
}

bool isOfHaas(const std::map<std::string, double>& settings) {
  return fanucSetting(settings, FanucParam::kFlavour) != 0.0;
}

}  // namespace

const CodeIndex& fanucMillCodes() {
  static const CodeIndex kIndex({fanucTextTable(), fanucMotionTable(), fanucFramesTable(), fanucCompTable(),
                                 fanucCyclesTable(), fanucTransformsTable(), fanucRotaryTable(),
                                 fanucMacroTable()});
  return kIndex;
}

const CodeIndex& haasMillCodes() {
  static const CodeIndex kIndex(
      {fanucTextTable(), fanucMotionTable(), fanucFramesTable(), fanucCompTable(), fanucCyclesTable(),
       fanucTransformsTable(), fanucRotaryTable(), fanucMacroTable()},
      {haasTable(), haasFramesTable(), haasMillTable()});
  return kIndex;
}

const CodeIndex& fanucLatheCodes(GCodeSystem system, bool haas) {
  const auto make = [](GCodeSystem of, bool of_haas) {
    std::vector<CodeTable> own = fanucLatheSystemTables(of);
    own.push_back(fanucLatheTable());
    if (of_haas) own.insert(own.end(), {haasTable(), haasFramesTable(), haasLatheTable()});
    return CodeIndex({fanucTextTable(), fanucMotionTable(), fanucFramesTable(), fanucCompTable(),
                      fanucTransformsTable(), fanucRotaryTable(), fanucMacroTable()},
                     std::move(own), notInSystem(of));
  };
  static const std::array<std::array<CodeIndex, 2>, 3> kCodes = {{
      {make(GCodeSystem::kA, false), make(GCodeSystem::kA, true)},
      {make(GCodeSystem::kB, false), make(GCodeSystem::kB, true)},
      {make(GCodeSystem::kC, false), make(GCodeSystem::kC, true)},
  }};
  return kCodes[static_cast<std::size_t>(system)][haas ? 1 : 0];
}

const IsoDialect& fanucMillDialect(const std::map<std::string, double>& settings) {
  static const IsoDialect kMill = dialectOf("fanuc-mill", fanucMillCodes());
  static const IsoDialect kHaas = haasOf(dialectOf("fanuc-mill", haasMillCodes()));
  return macroVariant(isOfHaas(settings) ? kHaas : kMill, settings);
}

const IsoDialect& fanucLatheDialect(const std::map<std::string, double>& settings) {
  const auto make = [](GCodeSystem system) {
    return std::array<IsoDialect, 2>{latheDialect(system, false), latheDialect(system, true)};
  };
  static const std::array<std::array<IsoDialect, 2>, 3> kDialects = {
      make(GCodeSystem::kA), make(GCodeSystem::kB), make(GCodeSystem::kC)};
  const double system = std::clamp(fanucSetting(settings, FanucParam::kGcodeSystem), 0.0, 2.0);
  const std::size_t flavour = isOfHaas(settings) ? 1 : 0;
  return macroVariant(kDialects[static_cast<std::size_t>(system)][flavour], settings);
}

}  // namespace proveout::nc
