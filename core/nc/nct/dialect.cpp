#include "core/nc/nct/dialect.h"

#include "core/nc/iso/system_variables/all_banks.h"
#include "core/nc/nct/alarms.h"
#include "core/nc/nct/formulas.h"
#include "core/nc/nct/parameters/nct_parameters.h"
#include "core/nc/nct/tables/tables.h"

namespace proveout::nc {
namespace {

/// Programs raise 4000 + n, stop with 5000 + n and ask with 6000 + n (manual 23.1.8).
constexpr MessageNumbers kMessages{4000, 5000, 6000};

LexRules lexing() {
  LexRules rules;
  rules.keep_repeats = true;
  return rules;
}

}  // namespace

const CodeIndex& nctCodes() {
  static const CodeIndex kIndex({motionTable(), framesTable(), compTable(), cyclesTable(), transformsTable(),
                                 spindleTable(), toolsTable(), measuringTable(), macroTable(), dataTable(),
                                 rotaryTable(), axesTable(), turningTable(), programTable()});
  return kIndex;
}

const IsoDialect& nctDialect() {
  static const IsoDialect kDialect{
      .name = "nct",
      .alarms = nctAlarms(),
      .codes = nctCodes(),
      .parameters = nctParameters(),
      .formulas = nctFormulas(),
      .lexing = lexing(),
      .messages = kMessages,
      .system_variables = allBanks,
  };
  return kDialect;
}

}  // namespace proveout::nc
