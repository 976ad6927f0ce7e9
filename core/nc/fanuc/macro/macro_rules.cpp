#include "core/nc/fanuc/macro/macro_rules.h"

#include <memory>
#include <mutex>
#include <tuple>

#include "core/nc/fanuc/macro/formulas.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/system_variables/fanuc_banks.h"

namespace proveout::nc {
namespace {

double settingOr(const std::map<std::string, double>& settings, FanucParam p, double usual) {
  const auto given = settings.find(std::string(fanucParameters().row(p).name));
  return given == settings.end() ? usual : given->second;
}

}  // namespace

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
  constexpr int kHaasAlarms = 1000;  // #3000=1 is alarm 1001 there
  const bool haas = settingOr(settings, FanucParam::kFlavour, 0.0) == 1.0;
  const bool signed_angles = settingOr(settings, FanucParam::kAtanRange, kFullTurn) < kFullTurn;
  if (!haas && !signed_angles) return base;
  static std::mutex mutex;
  static std::map<std::tuple<const IsoDialect*, bool, bool>, std::unique_ptr<IsoDialect>> variants;
  const std::scoped_lock lock(mutex);
  std::unique_ptr<IsoDialect>& variant = variants[{&base, haas, signed_angles}];
  if (variant == nullptr) {
    variant = std::make_unique<IsoDialect>(base);
    variant->formulas = fanucFormulas(signed_angles);
    if (haas) {
      variant->messages.alarm = kHaasAlarms;
      variant->rules.words_behind_if = true;
    }
  }
  return *variant;
}

}  // namespace proveout::nc
