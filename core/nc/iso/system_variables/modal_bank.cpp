#include "core/nc/iso/system_variables/modal_bank.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "core/nc/iso/context/context.h"

namespace proveout::nc {
namespace {

/// Words behind the group codes, by number minus 4100.
enum Word : int {
  kAux1 = 1,
  kAux2 = 2,
  kAux3 = 3,
  kD = 7,
  kE = 8,
  kF = 9,
  kH = 11,
  kM = 13,
  kN = 14,
  kO = 15,
  kS = 19,
  kT = 20,
  kWorkSystemP = 30
};
struct Name {
  const char* letters;
  int word;
};
constexpr auto kNames = std::to_array<Name>({{"A", kAux1},
                                             {"B", kAux2},
                                             {"C", kAux3},
                                             {"D", kD},
                                             {"E", kE},
                                             {"F", kF},
                                             {"H", kH},
                                             {"M", kM},
                                             {"N", kN},
                                             {"O", kO},
                                             {"S", kS},
                                             {"T", kT},
                                             {"WZP", kWorkSystemP}});

constexpr int kProgrammed = 4000, kExecuting = 4200, kInterrupted = 4400;

/// What a word is for; nothing: no motion depends on it.
std::optional<OriginKind> kindOf(int word) {
  switch (word) {
    case kD:
      return OriginKind::kRadiusOffset;
    case kF:
      return OriginKind::kFeed;
    case kH:
      return OriginKind::kLengthOffset;
    case kS:
      return OriginKind::kSpindle;
    case kT:
      return OriginKind::kNextTool;
    default:
      return std::nullopt;
  }
}

bool wordOf(const IsoState& s, int word, double& out) {
  switch (word) {
    case kAux1:
    case kAux2:
    case kAux3:
      out = s.last.auxiliary[static_cast<std::size_t>(word - kAux1)];
      return true;
    case kD:
      out = s.d;
      return true;
    case kE:
      out = s.last.e;
      return true;
    case kF:
      out = s.feed;
      return true;
    case kH:
      out = s.h;
      return true;
    case kM:
      out = s.last.m;
      return true;
    case kN:
      out = static_cast<double>(s.last.n);
      return true;
    case kS:
      out = s.spindle_rpm;
      return true;
    case kT:
      out = std::max(0, s.next_tool);
      return true;
    default:
      return false;
  }
}

}  // namespace

int programNumber(std::string_view file_name) {
  const std::size_t slash = file_name.find_last_of("/\\");
  if (slash != std::string_view::npos) file_name.remove_prefix(slash + 1);
  const std::string_view stem = file_name.substr(0, file_name.find('.'));
  constexpr std::size_t kMaxDigits = 8;
  if (stem.size() < 2 || stem.size() > kMaxDigits + 1 || (stem[0] != 'O' && stem[0] != 'o')) return 0;
  int number = 0;
  for (const char digit : stem.substr(1)) {
    if (digit < '0' || digit > '9') return 0;
    number = number * 10 + (digit - '0');
  }
  return number;
}

double modalCode(int code10) { return code10 / 10 + 100 * (code10 % 10); }

void ModalBank::addTo(VariableStore& store) {
  constexpr int kLast = 599;  // of #4000
  store.addBank(kProgrammed, kProgrammed + kLast, *this);
  store.addSymbol({"MAINO", kProgrammed});
  const auto add = [&](const char* kind, int base) {
    store.addSymbol({std::string(kind) + "G", base + 1, 1, rules_.groups});
    for (const Name& name : kNames)
      store.addSymbol({std::string(kind) + name.letters, base + 100 + name.word});
  };
  add("BUF", kProgrammed);
  add("ACT", kExecuting);
  add("INT", kInterrupted);
}

int ModalBank::numberOf(const SourceText& text) const {
  return rules_.program != nullptr ? rules_.program(text) : programNumber(text.name());
}

VariableStatus ModalBank::read(int number, Value& out) {
  out = {};
  if (number == kProgrammed) {
    out.number = numberOf(*c_.calls.main().text);
    return VariableStatus::kDone;
  }
  const int base = number >= kInterrupted ? kInterrupted : number >= kExecuting ? kExecuting : kProgrammed;
  const int index = number - base;
  const bool interrupted = base == kInterrupted;
  const IsoState& state = interrupted && c_.interrupted ? c_.interrupted->state : c_.state;
  const int word = index - 100;
  bool known = index >= 1 && index <= rules_.groups;
  if (known && rules_.code != nullptr) {
    out.number = rules_.code(c_, state, index);
  } else if (known) {
    out.number = index < kGroupCount ? modalCode(state.active[static_cast<std::size_t>(index)]) : 0.0;
  } else if (word == kO) {
    known = true;
    out.number = interrupted && c_.interrupted ? c_.interrupted->program
                 : base == kProgrammed && !rules_.program_in_hand
                     ? numberOf(c_.last_called ? *c_.last_called : *c_.calls.main().text)
                     : numberOf(*c_.calls.top().text);
  } else if (word == kWorkSystemP) {
    known = true;
    const int active = state.work_system >= kFirstExtended ? state.work_system - kFirstExtended + 1 : 0;
    out.number = base == kProgrammed ? state.last.extended_system : active;
  } else {
    known = wordOf(state, word, out.number);
    const auto kind = kindOf(word);
    if (kind && !interrupted) out.origin = c_.origins.wordOf(*kind);
  }
  if (!known) return VariableStatus::kUnknown;
  out.vacant = interrupted && !c_.interrupted;
  if (out.vacant) out.number = 0.0;
  return VariableStatus::kDone;
}

}  // namespace proveout::nc
