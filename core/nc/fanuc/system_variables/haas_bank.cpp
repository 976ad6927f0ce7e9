#include "core/nc/fanuc/system_variables/haas_bank.h"

#include <utility>

#include "core/nc/fanuc/system_variables/fanuc_banks.h"
#include "core/nc/iso/context/context.h"

namespace proveout::nc {
namespace {

constexpr int kHaasFirst = 10000, kHaasLast = 10999;
constexpr int kToolDataFirst = 8500, kToolDataLast = 8599;

class HaasBanks final : public SystemVariables {
 public:
  HaasBanks(IsoContext& context, std::unique_ptr<SystemVariables> others)
      : others_(std::move(others)), bank_(context) {
    bank_.addTo(context.variables);
    for (const auto& [number, value] : context.host.person.kept.variables) {
      if (number >= kToolDataFirst && number <= kHaasLast) context.variables.write(number, {value});
    }
  }
  void keep(IsoContext& c) override {
    others_->keep(c);
    bank_.addTo(c.summary.kept.variables);
  }

 private:
  std::unique_ptr<SystemVariables> others_;
  HaasBank bank_;
};

}  // namespace

void HaasBank::addTo(VariableStore& store) {
  store.addBank(kHaasFirst, kHaasLast, *this);
  store.addBank(kToolDataFirst, kToolDataLast, *this);
}

void HaasBank::addTo(std::map<int, double>& kept) const {
  for (const auto& [number, value] : stored_) {
    if (!value.vacant) kept[number] = value.number;
  }
}

bool HaasBank::common(int number) {
  const int n = number - kHaasFirst;
  return (n >= 100 && n <= 199) || (n >= 500 && n <= 999);
}

VariableStatus HaasBank::read(int number, Value& out) {
  if (common(number)) return c_.variables.read(number - kHaasFirst, out);
  const auto found = stored_.find(number);
  if (found != stored_.end()) {
    out = found->second;
    return VariableStatus::kDone;
  }
  out = Value::none();
  if (number > kToolDataLast) return VariableStatus::kDone;
  out = {0.0, false, 0};
  if (c_.firstTime("haas tool data")) {
    c_.warn("tool-data", "the job does not tell the tool data of #8500 to #8599: they are 0 until written",
            {}, Severity::kNote);
  }
  return VariableStatus::kDone;
}

VariableStatus HaasBank::write(int number, const Value& value) {
  if (common(number)) return c_.variables.write(number - kHaasFirst, value);
  stored_[number] = value;
  return VariableStatus::kDone;
}

std::unique_ptr<SystemVariables> haasMillBanks(IsoContext& context) {
  return std::make_unique<HaasBanks>(context, fanucMillBanks(context));
}

std::unique_ptr<SystemVariables> haasLatheBanks(IsoContext& context) {
  return std::make_unique<HaasBanks>(context, fanucLatheBanks(context));
}

}  // namespace proveout::nc
