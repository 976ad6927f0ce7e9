#include "core/nc/iso/block/auxiliary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/nc/iso/context/sends.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr AddressSet kAuxiliaryAddresses = "ABCUVW";

Address auxiliaryAddress(const IsoParameters& parameters, int k) {
  return static_cast<Address>(parameters.value(FunctionParam::kAuxiliary1 + k));
}

}  // namespace

bool checkAuxiliary(IsoContext& c) {
  for (int k = 0; k < kAuxiliaryCount; ++k) {
    const Address address = auxiliaryAddress(c.parameters, k);
    if (address == 0) continue;
    if (!kAuxiliaryAddresses.has(address)) {
      return c.fail("parameter", fmt::format("N{}: auxiliary functions are at A, B, C, U, V or W", 1333 + k));
    }
    if (c.axes.find(addressText(address)) >= 0) {
      return c.fail("parameter", fmt::format("N{}: {} is an axis and cannot be an auxiliary function",
                                             1333 + k, addressText(address)));
    }
  }
  return true;
}

bool takeAuxiliary(IsoContext& c, BlockPlan& plan) {
  if ((c.block.present & kAuxiliaryAddresses).empty()) return true;
  for (int k = 0; k < kAuxiliaryCount; ++k) {
    const Address address = auxiliaryAddress(c.parameters, k);
    const Word* w = address == 0 || !kAuxiliaryAddresses.has(address) ? nullptr : c.word(address);
    if (w == nullptr || w->axis >= 0) continue;
    constexpr double kMost = 99999999;
    const double value = w->from_expression ? std::round(w->value) : w->value;
    if (value != std::round(value) || std::abs(value) > kMost || w->incremental) {
      return c.alarm(SharedAlarm::kOutOfRange, *w,
                     "an auxiliary function is a whole number of up to 8 digits");
    }
    plan.next.last.auxiliary[static_cast<std::size_t>(k)] = value;
    plan.auxiliary.set(static_cast<std::size_t>(k));
    plan.flush = plan.flush || c.parameters.flag(ProgramParam::kBufferAuxiliary1 + k);
    std::erase_if(c.block.words, [&](const Word& word) { return word.address == address; });
    AddressSet taken;
    taken.add(address);
    c.block.present = c.block.present.without(taken);
  }
  return true;
}

bool performAuxiliary(IsoContext& c, const BlockPlan& plan) {
  for (int k = 0; k < kAuxiliaryCount; ++k) {
    const auto index = static_cast<std::size_t>(k);
    if (!plan.auxiliary[index]) continue;
    const std::string code = fmt::format("{}{}", addressText(auxiliaryAddress(c.parameters, k)),
                                         static_cast<std::int64_t>(plan.next.last.auxiliary[index]));
    if (!sendEvent(c, event::Function{code, {}})) return false;
  }
  return true;
}

}  // namespace proveout::nc
