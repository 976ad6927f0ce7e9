#include "core/nc/iso/macro/subprogram_words.h"

#include <algorithm>

#include "core/nc/iso/context/context.h"
#include "core/nc/iso/context/origins.h"
#include "core/nc/iso/context/words.h"

namespace proveout::nc {
namespace {

bool subprogramOf(const IsoContext& c, const Word& w, SystemCall& call) {
  const bool found =
      w.address == 'M' ? c.systems.mSubprogram(mNumber(w), call) : c.systems.letter(w.address, call);
  return found && mayCall(c, call.code);
}

}  // namespace

bool mayCall(const IsoContext& c, std::int32_t code) {
  bool inside = false;
  for (std::size_t level = c.calls.depth(); level-- > 1;) {
    const std::int32_t caller = c.calls.at(level).system_code;
    if (caller < 0) continue;
    if (caller == code || (isSystemG(caller) && isSystemG(code))) return false;
    inside = true;
  }
  return !inside || c.parameters.flag(MacroParam::kCallsInSystemPrograms);
}

bool takeProgram(IsoContext& c, const ProgramStore::Loaded& loaded, CallFrame& frame) {
  if (loaded.failure == ProgramStore::Failure::kEncoding) return c.fail("encoding", loaded.message);
  if (loaded.text == nullptr) return c.alarm(SharedAlarm::kProgramNotFound, "", loaded.message);
  if (loaded.again > 0)
    return c.alarm(SharedAlarm::kProgramTwice, "",
                   fmt::format("another program of that number begins on line {} of its file", loaded.again));
  frame.setProgram(*loaded.text, loaded.file);
  return true;
}

bool SubprogramWords::any(const IsoContext& c) {
  if (!c.systems.anySubprogram()) return false;
  SystemCall call;
  return std::any_of(c.block.words.begin(), c.block.words.end(),
                     [&](const Word& w) { return subprogramOf(c, w, call); });
}

bool SubprogramWords::take(IsoContext& c) {
  count_ = 0;
  if (!c.systems.anySubprogram()) return true;
  if (!c.systems.fault().empty()) return c.fail("parameter", c.systems.fault());
  std::vector<Word>& words = c.block.words;
  SystemCall call;
  for (const Word& w : words) {
    if (!subprogramOf(c, w, call)) continue;
    if (count_ == words_.size())
      return c.failWord("m-count", "too many subprograms are called in one block", w);
    Taken& taken = words_[count_++];
    const std::uint32_t origin = call.variable > 0 ? numberOf(c, w, OriginKind::kArgument) : 0;
    taken = {CallFrame(), {w.value, false, origin}, call.variable};
    taken.frame.kind = CallKind::kSubprogram;
    taken.frame.system_code = call.code;
    if (!takeProgram(c, c.programs.system(call.program, c.channel()), taken.frame)) return false;
  }
  if (count_ == 0) return true;
  std::erase_if(words, [&](const Word& w) { return subprogramOf(c, w, call); });
  c.block.present = {};
  for (const Word& w : words) c.block.present.add(w.address);
  return true;
}

void SubprogramWords::defer(IsoContext& c) const {
  for (std::size_t k = 0; k < count_; ++k) {
    const Taken& word = words_[k];
    if (word.variable > 0) c.variables.write(word.variable, word.value);
    c.calls.defer(word.frame);
  }
}

}  // namespace proveout::nc
