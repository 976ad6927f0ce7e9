#include "core/nc/fanuc/macro/macro_rules.h"

#include <map>
#include <memory>
#include <mutex>

#include "core/nc/fanuc/macro/formulas.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/system_variables/fanuc_banks.h"

namespace proveout::nc {
void takeMacroRules(IsoDialect& dialect, bool lathe) {
  dialect.rules.words_behind_if = false;
  dialect.rules.loops_are_closed = true;
  dialect.rules.lowest_jump = 1;
  dialect.rules.channel_in_messages = false;
  dialect.rules.names_output = false;
  dialect.subprogram = fanucSubprogram;
  dialect.arguments = fanucArguments;
  dialect.letters = kFanucLetters;
  dialect.steps_per_unit = fanucStepsPerUnit;
  dialect.system_variables = lathe ? fanucLatheBanks : fanucMillBanks;
}

const IsoDialect& macroVariant(const IsoDialect& base, const std::map<std::string, double>& settings) {
  constexpr double kFullTurn = 360.0;
  if (fanucSetting(settings, FanucParam::kAtanRange) >= kFullTurn) return base;
  static std::mutex mutex;
  static std::map<const IsoDialect*, std::unique_ptr<IsoDialect>> signed_angles;
  const std::scoped_lock lock(mutex);
  std::unique_ptr<IsoDialect>& variant = signed_angles[&base];
  if (variant == nullptr) {
    variant = std::make_unique<IsoDialect>(base);
    variant->formulas = fanucFormulas(true);
  }
  return *variant;
}

}  // namespace proveout::nc
