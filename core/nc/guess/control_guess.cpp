#include "core/nc/guess/control_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <sstream>

#include "core/nc/guess/candidates.h"
#include "core/nc/guess/program_signs.h"
#include "core/nc/guess/sign_table.h"
#include "core/nc/text/program_likeness.h"

namespace proveout {
namespace nc::guess {
namespace {

// A control is named where so much speaks for it, and so much more than for any other one.
constexpr int kEnough = 7;
constexpr int kLead = 3;
/// So much more has to speak for a flavour than for the control without it.
constexpr int kFlavourLead = 2;
/// Codes that a control does not have, and codes that only few have.
constexpr int kMissingCode = 4, kMostMissing = 12, kOwnCode = 3, kMostOwn = 6;
constexpr std::size_t kReasons = 3;
/// Words of 3-D printers that are no accident: so many, in one block of so many.
constexpr int kPrinterWords = 4, kPrinterShare = 5;

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < 100'000) {
    const std::size_t end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    const bool pair = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (pair ? 2 : 1));
  }
  return lines;
}

std::string loweredName(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

/// "length offset with H (line 9: G43 Z15. H1)".
std::string reasonOf(std::string_view says, const Seen& seen) {
  if (seen.line == 0) return std::string(says);
  return fmt::format("{} (line {}: {})", says, seen.line, seen.text);
}

/// Adds up what speaks for and against each candidate.
class Weighing {
 public:
  struct Side {
    int weight = 0;
    struct Reason {
      int weight;
      std::string text;
    };
    std::vector<Reason> pro, con;
  };

  void add(Candidates who, int weight, const std::string& reason) {
    if (weight == 0) return;
    for (std::size_t k = 0; k < kCandidateCount; ++k) {
      if ((candidates()[k].bit & who) == 0) continue;
      sides_[k].weight += weight;
      (weight > 0 ? sides_[k].pro : sides_[k].con).push_back({weight, reason});
    }
  }

  Side& side(std::size_t k) { return sides_[k]; }

 private:
  std::array<Side, kCandidateCount> sides_;
};

void weighSigns(const ProgramSigns& signs, Weighing& weighing) {
  for (const SignRow& row : signRows()) {
    const Seen& seen = signs.of(row.sign);
    if (seen.count < row.least) continue;
    const std::string reason = reasonOf(row.says, seen);
    weighing.add(row.speaks_for, row.weight_for, reason);
    weighing.add(row.speaks_against, -row.weight_against, reason);
  }
}

void weighNames(const ProgramSigns& signs, std::string_view file_name, Weighing& weighing) {
  const std::string lowered = loweredName(file_name);
  for (const NameRow& row : nameRows()) {
    std::string reason;
    if (row.name.front() == '.') {
      if (!lowered.ends_with(row.name)) continue;
      reason = fmt::format("the name of the file ends in {}", row.name);
    } else {
      const auto found = signs.names.find(std::string(row.name));
      if (found == signs.names.end()) continue;
      reason = reasonOf(fmt::format("a comment names {}", row.name), found->second);
    }
    weighing.add(row.speaks_for, row.weight_for, reason);
    weighing.add(static_cast<Candidates>(kEverybody & ~row.speaks_for), -row.weight_against, reason);
  }
}

/// Number of controls, not of flavours, in a set.
int controlsIn(Candidates set) {
  int count = 0;
  std::vector<ControlId> seen;
  for (const Candidate& candidate : candidates()) {
    if ((candidate.bit & set) == 0 || std::ranges::find(seen, candidate.control) != seen.end()) continue;
    seen.push_back(candidate.control);
    ++count;
  }
  return count;
}

void weighCodes(const ProgramSigns& signs, Weighing& weighing) {
  std::array<int, kCandidateCount> missing{}, own{};
  for (const auto& [tenths, seen] : signs.codes) {
    Candidates has = 0;
    for (const Candidate& candidate : candidates()) {
      if (hasCode(candidate.codes, tenths)) has = static_cast<Candidates>(has | candidate.bit);
    }
    if (has == 0 || has == kEverybody) continue;
    const int kinds = controlsIn(has);
    for (std::size_t k = 0; k < kCandidateCount; ++k) {
      const Candidate& candidate = candidates()[k];
      if ((candidate.bit & has) == 0 && missing[k] < kMostMissing) {
        missing[k] += kMissingCode;
        weighing.add(candidate.bit, -kMissingCode,
                     fmt::format("it has no {} (line {})", seen.text, seen.line));
      }
      const int weight = kinds == 1 ? kOwnCode : kinds == 2 ? 1 : 0;
      if ((candidate.bit & has) != 0 && weight > 0 && own[k] < kMostOwn) {
        own[k] += weight;
        weighing.add(candidate.bit, weight,
                     fmt::format("{} (line {}), which {} has", seen.text, seen.line,
                                 kinds == 1 ? "no other" : "hardly any other"));
      }
    }
  }
}

std::vector<std::string> textsOf(std::vector<Weighing::Side::Reason> reasons) {
  std::ranges::stable_sort(
      reasons, [](const auto& a, const auto& b) { return std::abs(a.weight) > std::abs(b.weight); });
  std::vector<std::string> texts;
  for (auto& reason : reasons) {
    if (std::ranges::find(texts, reason.text) == texts.end()) texts.push_back(std::move(reason.text));
  }
  return texts;
}

const ControlInfo& infoOf(ControlId id) {
  return *std::ranges::find_if(controls(), [&](const ControlInfo& info) { return info.id == id; });
}

/// The best flavour of each control that is built, best first.
std::vector<ControlGuess> ranking(Weighing& weighing) {
  std::vector<ControlGuess> ranked;
  for (std::size_t k = 0; k < kCandidateCount; ++k) {
    const Candidate& candidate = candidates()[k];
    const ControlInfo& info = infoOf(candidate.control);
    if (!info.built) continue;
    Weighing::Side& side = weighing.side(k);
    ControlGuess guess{std::string(info.name), std::string(candidate.flavour), side.weight, textsOf(side.pro),
                       textsOf(side.con)};
    const auto same = std::ranges::find_if(
        ranked, [&](const ControlGuess& other) { return other.control == guess.control; });
    if (same == ranked.end())
      ranked.push_back(std::move(guess));
    else if (guess.weight >= same->weight + (same->flavour.empty() ? kFlavourLead : 1))
      *same = std::move(guess);
  }
  std::ranges::stable_sort(ranked,
                           [](const ControlGuess& a, const ControlGuess& b) { return a.weight > b.weight; });
  return ranked;
}

std::string joined(const std::vector<std::string>& reasons, std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(most, reasons.size()); ++k) text += (k > 0 ? "; " : "") + reasons[k];
  return text;
}

std::string weighedText(const ControlGuess& guess) {
  std::string text = guess.name() + ": ";
  text += guess.reasons.empty() ? "nothing speaks for it" : joined(guess.reasons, kReasons);
  if (!guess.doubts.empty()) text += ", but " + joined(guess.doubts, 2);
  return text;
}

}  // namespace
}  // namespace nc::guess

std::string ControlGuess::name() const {
  return flavour.empty() ? control : fmt::format("{} (flavour {})", control, flavour);
}

std::string GuessedControl::choiceText() const {
  return chosen
             ? fmt::format("{}: {}", chosen->name(), nc::guess::joined(chosen->reasons, nc::guess::kReasons))
             : std::string();
}

std::string GuessedControl::refusalText() const {
  constexpr const char* kWhatToDo = "name the control: --control NAME, or control = \"NAME\" in the job";
  if (!foreign.empty()) return fmt::format("this is {}; no control here reads it", foreign);
  if (ranked.empty() || ranked.front().weight <= 0) {
    return fmt::format("nothing in the program tells which control it is for; {}", kWhatToDo);
  }
  std::string text =
      "the program does not tell which control it is for. It may be " + nc::guess::weighedText(ranked[0]);
  if (ranked.size() > 1) text += ". Or " + nc::guess::weighedText(ranked[1]);
  return fmt::format("{}. Please {}", text, kWhatToDo);
}

GuessedControl guessControl(std::string_view file_name, std::string_view text) {
  GuessedControl result;
  const std::vector<std::string_view> lines = nc::guess::linesOf(text);
  result.foreign = nc::foreignLanguage(lines);
  const nc::guess::ProgramSigns signs = nc::guess::readSigns(lines);
  if (result.foreign.empty() && signs.printer.count >= nc::guess::kPrinterWords &&
      signs.printer.count * nc::guess::kPrinterShare >= signs.blocks)
    result.foreign = fmt::format("a program of a 3-D printer (such as {}, line {})", signs.printer.text,
                                 signs.printer.line);
  if (!result.foreign.empty()) return result;
  nc::guess::Weighing weighing;
  nc::guess::weighSigns(signs, weighing);
  nc::guess::weighNames(signs, file_name, weighing);
  nc::guess::weighCodes(signs, weighing);
  result.ranked = nc::guess::ranking(weighing);
  const auto& ranked = result.ranked;
  if (ranked.empty() || ranked[0].weight < nc::guess::kEnough) return result;
  if (ranked.size() > 1 && ranked[0].weight < ranked[1].weight + nc::guess::kLead) return result;
  result.chosen = ranked[0];
  return result;
}

std::optional<double> flavourValue(ControlId control, std::string_view flavour) {
  if (flavour.empty()) return std::nullopt;
  for (const ParameterInfo& parameter : parameterTable(control)) {
    if (parameter.name != "flavour") continue;
    std::istringstream words{std::string(parameter.choices)};
    double value = 0.0;
    for (std::string word; words >> word; value += 1.0) {
      if (word == flavour) return value;
    }
  }
  return std::nullopt;
}

}  // namespace proveout
