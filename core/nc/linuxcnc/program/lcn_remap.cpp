// Codes that the machine has made calls of subroutines (REMAP of the INI file, `remap` of the job).
#include <fmt/core.h>

#include <algorithm>

#include "core/nc/iso/context/words.h"
#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {
namespace {

/// "M6", "G88.6", "T": the name under which a code is remapped.
std::string lcnCodeName(const Word& w) {
  if (w.address == 'G') return gName(code10Of(w));
  if (w.address == 'M') return fmt::format("M{}", static_cast<int>(w.value));
  return std::string(addressText(w.address));
}

constexpr AddressSet kLcnRemappable = "GMTSF";

}  // namespace

const Word* LinuxCncLanguage::remappedWord(std::string& code) const {
  if (machine_.remaps.empty()) return nullptr;
  for (const Word& w : c_.block.words) {
    if (!kLcnRemappable.has(w.address)) continue;
    code = lcnCodeName(w);
    const bool inside =
        std::any_of(open_.begin(), open_.end(), [&](const Open& o) { return o.remap == code; });
    if (!inside && machine_.remaps.contains(code)) return &w;
  }
  return nullptr;
}

/// A line with a remapped code: what else stands in it is carried out, then the sub is called with the words
/// of the line as #<letter>. Inside of it the code means itself. Nothing: no code of the line is remapped.
std::optional<Go> LinuxCncLanguage::remapped(StatementFlow& flow) {
  std::string code;
  const Word* const found = remappedWord(code);
  if (found == nullptr) return {};
  const LcnRemap& remap = machine_.remaps.at(code);
  const Word at = *found;
  if (remap.python || remap.sub.empty()) {
    c_.failWord("python-remap",
                fmt::format("{} is remapped with Python, which the simulation does not run", code), at);
    return flow.failed(false);
  }
  if (c_.calls.depth() >= kLcnLevels) return oWordFails(flow, "levels", "Too many subroutine levels");
  CallFrame frame;
  const std::string label = fmt::format("<{}>", remap.sub);
  if (!findProgram(label, true, frame)) {
    c_.failWord(
        "remap",
        fmt::format("{} is remapped to {}.ngc, which is not there or has no o{} sub", code, remap.sub, label),
        at);
    return flow.failed(true);
  }
  const std::vector<Word> words = c_.block.words;
  const auto argument = [&](const Word& w) { return !kLcnRemappable.has(w.address); };
  std::erase_if(c_.block.words,
                [&](const Word& w) { return argument(w) || w.columns.begin == at.columns.begin; });
  c_.block.present = {};
  for (const Word& w : c_.block.words) c_.block.present.add(w.address);
  if (!functions(flow) || (!c_.block.words.empty() && !flow.carryOutWords())) return flow.failed(false);
  flow.statementDone();
  variables_.enter({});
  for (const Word& w : words) {
    if (!argument(w)) continue;
    const std::string name(
        1, static_cast<char>(w.address >= 'A' && w.address <= 'Z' ? w.address + 32 : w.address));
    variables_.putNamed(name, Value{w.value});
  }
  open_.push_back({true, code});
  return flow.openCall(frame, 1);
}

}  // namespace proveout::nc
