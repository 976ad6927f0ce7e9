#include "core/nc/iso/perform/unused_words.h"

#include <fmt/core.h>

#include "core/nc/iso/context/words.h"

namespace proveout::nc {

void tellUnused(IsoContext& c, const Word& word, std::string_view code, std::string_view why) {
  const SourceRef at = c.calls.here();
  if (!c.firstTime(fmt::format("unused {} {} {}", at.file, at.line, word.columns.begin))) return;
  const auto text = c.block.text.substr(static_cast<std::size_t>(word.columns.begin - 1),
                                        static_cast<std::size_t>(word.columns.end - word.columns.begin));
  c.warn("unused-word", fmt::format("{} does nothing in this block of {}: {}", text, code, why),
         word.columns);
}

void tellUnusedWords(IsoContext& c, const BlockPlan& plan, AddressSet read) {
  AddressSet known = c.asked | plan.claimed | read | c.axes.addresses();
  known.add(kNamedWord);
  const AddressSet unused = c.block.present.without(known);
  if (unused.empty()) return;
  const int code10 = plan.governor->code10;
  const bool cycle = plan.governor->group == kGroupCycle;
  for (const Word& w : c.block.words) {
    if (!unused.has(w.address)) continue;
    const char* const why = !cycle ? "the code does not read it here"
                            : !c.anyAxisWord()
                                ? "no hole is named, and words of the cycle without one are not kept"
                            : w.address == 'K' ? "the cycle does not read K; repeats are programmed with L"
                                               : "the cycle does not read it; another one may, until G80";
    tellUnused(c, w, gName(code10), why);
  }
}

}  // namespace proveout::nc
