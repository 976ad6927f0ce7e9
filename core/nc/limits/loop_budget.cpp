#include "core/nc/limits/loop_budget.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/nc/limits/loop_lines.h"

namespace proveout::nc {

namespace {

/// Of what one loop may do this is let be before its end must be in sight: at the usual limits a fraction of
/// a second, and a path of 27 MB.
constexpr double kBlocksShare = 1.0 / 50, kMotionsShare = 1.0 / 25;
constexpr double kLeast = 2000.0;
constexpr double kMotionsOfABlock = 1.0 / 20;
/// Conditions kept of a loop: with more nothing is said of it.
constexpr std::size_t kMostConditions = 64;
/// Loops kept of one program that is open: of more the one that came back longest ago is forgotten.
constexpr std::size_t kMostLoops = 8;
/// An end that was twice as near when it was first foretold is not reached.
constexpr double kReceded = 2.0;
constexpr std::uint64_t kCount = 0;  ///< the condition that is the count of a call
constexpr double kNever = std::numeric_limits<double>::infinity(), kFar = 1e9;
constexpr const char* kKey = "[simulation] max_blocks of the job sets how far a loop may go";

}  // namespace

LoopBudget::LoopBudget(std::uint64_t block_limit, State state) : state_(std::move(state)) {
  most_.blocks = static_cast<double>(block_limit);
  most_.motions = kMotionsOfABlock * most_.blocks;
  patience_ = {std::max(most_.blocks * kBlocksShare, kLeast),
               std::max(most_.motions * kMotionsShare, kLeast)};
}

void LoopBudget::asked(std::uint64_t condition, double gap, bool holds) {
  for (Loop& loop : loops_) {
    const auto same = [&](const Condition& c) { return c.place == condition; };
    auto found = std::find_if(loop.conditions.begin(), loop.conditions.end(), same);
    if (found == loop.conditions.end()) {
      if (loop.conditions.size() >= kMostConditions) {
        loop.unclear = true;
        continue;
      }
      found = loop.conditions.insert(found, {condition, holds, false, {}, {}});
    }
    found->both = found->both || found->holds != holds;
    if (!found->both && std::isfinite(gap)) found->least = std::min(found->least.value_or(kNever), gap);
  }
}

bool LoopBudget::arrives(const Place& at, const Work& done) {
  Place from;
  bool repeats = false;
  return hasComeBack(at, from, repeats) && goesRound(enter(at, from, repeats, done), at, done);
}

bool LoopBudget::hasComeBack(const Place& at, Place& from, bool& repeats) {
  levels_.resize(at.depth + 1);
  Level& level = levels_.back();
  from = level.last;
  const bool same = level.known && from.call == at.call;
  repeats = same && from.repetition != at.repetition;
  level = {at, true};
  return same && (repeats || at.order <= from.order);
}

/// The loop that came back, the innermost one now.
LoopBudget::Loop& LoopBudget::enter(const Place& at, const Place& from, bool repeats, const Work& done) {
  const auto isInside = [&](const Loop& loop) {
    if (loop.at.depth != at.depth) return loop.at.depth > at.depth;
    if (loop.at.call != at.call) return true;
    if (loop.repeats || repeats) return !loop.repeats;
    return loop.at.order > at.order;
  };
  loops_.erase(std::remove_if(loops_.begin(), loops_.end(), isInside), loops_.end());
  const auto isIt = [&](const Loop& loop) {
    return loop.at.depth == at.depth && loop.repeats == repeats && (repeats || loop.at.order == at.order);
  };
  auto found = std::find_if(loops_.begin(), loops_.end(), isIt);
  if (found == loops_.end()) {
    const auto here = [&](const Loop& loop) { return loop.at.depth == at.depth && !loop.repeats; };
    if (std::count_if(loops_.begin(), loops_.end(), here) >= static_cast<std::ptrdiff_t>(kMostLoops))
      loops_.erase(std::find_if(loops_.begin(), loops_.end(), here));
    found = loops_.insert(loops_.end(), Loop{});
    found->repeats = repeats;
    found->tail = from;
    found->start = done;
    found->rounds = -1.0;  // this time is the start of the first one that is counted
    found->look = {patience_.blocks / 2, patience_.motions / 2};
  }
  found->at = at;
  if (repeats || from.order > found->tail.order) found->tail = from;
  std::rotate(found, found + 1, loops_.end());
  return loops_.back();
}

/// As if the program had asked how often the call is still to be run.
void LoopBudget::askCount(Loop& loop, const Place& at) {
  auto& all = loop.conditions;
  if (all.empty() || all.front().place != kCount) all.insert(all.begin(), {kCount, true, false, {}, {}});
  all.front().least = static_cast<double>(at.repetitions - at.repetition);
}

bool LoopBudget::goesRound(Loop& loop, const Place& at, const Work& done) {
  ++loop.rounds;
  if (loop.repeats) askCount(loop, at);
  const Work spent{done.blocks - loop.start.blocks, done.motions - loop.start.motions};
  if (loop.unclear || (spent.blocks < loop.look.blocks && spent.motions < loop.look.motions)) return false;
  message_ = judge(loop, spent);
  if (message_.empty()) lookAgain(loop, spent);
  return !message_.empty();
}

/// Why the loop is to be ended; empty: it may go on.
std::string LoopBudget::judge(Loop& loop, const Work& spent) const {
  const bool counts = loop.repeats && loop.conditions.size() == 1;  // it asks for nothing else
  if (loop.rounds_before == 0.0 && !counts) return {};
  const auto isNew = [](const Condition& c) { return !c.both && c.least && !c.before && c.place != kCount; };
  if (std::any_of(loop.conditions.begin(), loop.conditions.end(), isNew)) return {};
  PROVEOUT_ASSERT(loop.rounds >= 1);
  const double all = loop.rounds + roundsLeft(loop);
  if (!loop.promised) loop.promised = all;
  const std::string name =
      fmt::format("{} ({:.0f} blocks, {:.0f} motions)", nameOf(loop), spent.blocks, spent.motions);
  if (all == kNever || all > kReceded * *loop.promised) {
    return fmt::format("an endless loop{}, and nothing that it asks comes nearer to its end{}; {}", name,
                       changes(loop), kKey);
  }
  const double more = all / loop.rounds * repeatedAround(loop);
  if (more * spent.motions <= most_.motions && more * spent.blocks <= most_.blocks) return {};
  return fmt::format(
      "a loop that is too long{}, and would come to about {:.2g} blocks and {:.2g} motions{}; {}", name,
      more * spent.blocks, more * spent.motions, changes(loop), kKey);
}

/// Until the first of its conditions comes out the other way, if they go on as they did; infinite: none comes
/// nearer to it.
double LoopBudget::roundsLeft(const Loop& loop) const {
  double left = kNever;
  for (const Condition& c : loop.conditions) {
    if (c.place == kCount && c.least) left = std::min(left, *c.least);
    if (c.place == kCount || c.both || !c.least || !c.before || !(*c.least < *c.before)) continue;
    left = std::min(left, *c.least / (*c.before - *c.least) * (loop.rounds - loop.rounds_before));
  }
  return left;
}

/// How often the loop is still to be run for the sake of calls that are repeated around it.
double LoopBudget::repeatedAround(const Loop& loop) const {
  double times = 1.0;
  for (const Level& level : levels_) {
    const bool own = level.last.depth == loop.at.depth;
    if (!level.known || (own && loop.repeats)) continue;
    const auto isIts = [&](const Loop& l) { return l.repeats && l.at.depth == level.last.depth; };
    const auto known = std::find_if(loops_.begin(), loops_.end(), isIts);
    if (known == loops_.end()) {
      times *= static_cast<double>(level.last.repetitions - level.last.repetition);
    } else if (known->rounds_before > 0.0 || known->conditions.size() == 1) {
      times *= std::max(1.0, std::min(roundsLeft(*known), kFar));
    }
  }
  return times;
}

void LoopBudget::lookAgain(Loop& loop, const Work& spent) const {
  for (Condition& c : loop.conditions) c.before = c.least;
  loop.rounds_before = loop.rounds;
  loop.seen = state_();
  // At half the patience first, then at the whole of it, then after twice as much each time.
  loop.look = {std::max(2.0 * spent.blocks, patience_.blocks),
               std::max(2.0 * spent.motions, patience_.motions)};
}

std::string LoopBudget::nameOf(const Loop& loop) const {
  if (!loop.repeats)
    return fmt::format(" in {}: the program came back from line {} to line {} {:.0f} times",
                       LoopLines::named(loop.at.line, loop.tail.line), loop.tail.line + 1, loop.at.line + 1,
                       loop.rounds + 1.0);
  const bool called =
      loop.at.depth > 0 && levels_.size() >= loop.at.depth && levels_[loop.at.depth - 1].known;
  return fmt::format(" in {}: this is run {} of {}{}", LoopLines::named(loop.at.line, loop.tail.line),
                     loop.at.repetition + 1, loop.at.repetitions,
                     called ? fmt::format(" of the call in line {}", levels_[loop.at.depth - 1].last.line + 1)
                            : std::string());
}

/// What has changed since the loop was last looked at: at most four of it.
std::string LoopBudget::changes(const Loop& loop) const {
  constexpr int kMost = 4;
  const std::string since = fmt::format("; its last {:.0f} rounds changed", loop.rounds - loop.rounds_before);
  std::string text;
  int told = 0;
  for (const Named& now : state_()) {
    const auto same = [&](const Named& was) { return was.name == now.name; };
    const auto was = std::find_if(loop.seen.begin(), loop.seen.end(), same);
    if (was == loop.seen.end() || was->value == now.value || ++told > kMost) continue;
    text +=
        fmt::format("{} {} from {:.6g} to {:.6g}", told == 1 ? since : ",", now.name, was->value, now.value);
  }
  return text;
}

}  // namespace proveout::nc
