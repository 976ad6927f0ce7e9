#include "core/nc/iso/spindle/wait.h"

#include <fmt/core.h>

#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

constexpr double kMostCodes = 100;

/// The channels that the digits of P name.
bool channelsOf(IsoContext& c, const Word& p, ChannelSet& whom) {
  std::int64_t digits = 0;
  if (!integerWord(c, p, 1, 99999999, digits)) return false;
  for (; digits > 0; digits /= 10) {
    const auto number = static_cast<int>(digits % 10);
    if (number < 1 || number > kMaxChannels || whom.has(number))
      return c.alarm(SharedAlarm::kOutOfRange, p, "each digit is a channel, 1 to 8, and stands there once");
    whom.add(number);
  }
  return true;
}

bool checkChannels(IsoContext& c, const Word& p, const WaitingPoint& at) {
  const bool known = !c.channels.empty() || c.settings.channel > 0;
  if (known && !at.whom.has(c.channel())) {
    return c.failWord(
        "wait", fmt::format("{} in channel {}: P has to name the own channel too", at.text, c.channel()), p);
  }
  for (int number = 1; number <= kMaxChannels && !c.channels.empty(); ++number) {
    if (!at.whom.has(number) || c.channels.has(number)) continue;
    return c.failWord("wait", fmt::format("{}: the run has no channel {}", at.text, number), p);
  }
  return true;
}

}  // namespace

bool checkWaitCodes(IsoContext& c) {
  const double low = c.parameters[ProgramParam::kWaitLow], high = c.parameters[ProgramParam::kWaitHigh];
  const bool good = low == 0.0 ? high == 0.0 : high >= low && high - low < kMostCodes;
  return good || c.fail("parameter", fmt::format("{}, {}: first and last waiting code, at most 100 codes",
                                                 c.parameters.name(ProgramParam::kWaitLow),
                                                 c.parameters.name(ProgramParam::kWaitHigh)));
}

bool planWait(IsoContext& c, BlockPlan& plan, const Word& m) {
  const Word* p = c.word('P');
  const auto code = static_cast<int>(m.value);
  if (p == nullptr)
    return c.alarm(SharedAlarm::kMissingData, "P", fmt::format("M{} needs the channels that meet", code));
  if (c.block.words.size() > 2 || c.block.has_file) {
    return c.failWord("wait", fmt::format("the waiting code M{} and its P stand alone in a block", code), m);
  }
  WaitingPoint at;
  if (!channelsOf(c, *p, at.whom)) return false;
  at.code = code;
  at.text = fmt::format("M{} P{}", code, static_cast<std::int64_t>(p->value));
  if (!checkChannels(c, *p, at)) return false;
  plan.claimed.add('P');
  plan.flush = true;
  plan.wait_code = code;
  plan.wait_whom = at.whom;
  return true;
}

bool performWait(IsoContext& c, const BlockPlan& plan) {
  ChannelSet own;
  own.add(c.channel());
  if (plan.wait_whom == own) return true;
  const std::string text =
      fmt::format("M{} P{}", plan.wait_code, static_cast<std::int64_t>(c.word('P')->value));
  if (c.channels.empty()) {
    if (c.firstTime("wait")) {
      c.warn("wait", fmt::format("{}: one channel runs, it waits for no other", text), {}, Severity::kNote);
    }
    return true;
  }
  c.emitter.time().flush();
  c.waiting = {plan.wait_code, plan.wait_whom, text};
  return true;
}

void endWait(IsoContext& c, double idle_s) {
  const WaitingPoint at = std::exchange(c.waiting, {});
  c.emitter.event(event::Wait{fmt::format("M{}", at.code), at.whom.text()}, idle_s, c.here());
}

}  // namespace proveout::nc
