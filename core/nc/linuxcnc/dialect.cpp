#include "core/nc/linuxcnc/dialect.h"

#include "core/nc/linuxcnc/alarms.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/macro/formulas.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/parameters/linuxcnc_parameters.h"
#include "core/nc/linuxcnc/program/lcn_language.h"
#include "core/nc/linuxcnc/tables/tables.h"

namespace proveout::nc {
namespace {

LexRules linuxCncLexing() {
  LexRules rules;
  rules.incremental_operator = false;
  rules.comma_addresses = false;
  return rules;
}

std::unique_ptr<IsoLanguage> linuxCncLanguage(IsoContext& c) { return std::make_unique<LinuxCncLanguage>(c); }

}  // namespace

const CodeIndex& linuxCncCodes() {
  static const CodeIndex kIndex({linuxCncMotionTable(), linuxCncFunctionTable()});
  return kIndex;
}

const IsoDialect& linuxCncDialect(const std::map<std::string, double>& /*settings*/) {
  static const IsoDialect kDialect{
      .name = "linuxcnc",
      .alarms = linuxCncAlarms(),
      .codes = linuxCncCodes(),
      .parameters = linuxCncParameters(),
      .formulas = linuxCncFormulas(),
      .lexing = linuxCncLexing(),
      .layout = ProgramLayout::kOneInAFile,
      .maker_data = makeLinuxCncChannel,
      .plan = planLinuxCncBlock,
      .end_state = endStateOfLinuxCnc,
      .begin = beginLinuxCnc,
      .power_on = powerOnLinuxCnc,
      .language = linuxCncLanguage,
  };
  return kDialect;
}

}  // namespace proveout::nc
