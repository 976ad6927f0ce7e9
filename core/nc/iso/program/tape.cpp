#include "core/nc/iso/program/tape.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/characters.h"
#include "core/nc/iso/context/context.h"
#include "core/nc/iso/model/code_names.h"

namespace proveout::nc {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool digitAt(std::string_view text, std::size_t i) { return i < text.size() && isDigit(text[i]); }

/// Is there an M2, M30 or M99 outside of comments?
bool endsProgram(std::string_view line) {
  bool comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    comment = comment ? line[i] != ')' : line[i] == '(';
    if (comment || (line[i] != 'M' && line[i] != 'm')) continue;
    std::size_t k = i + 1;
    while (k < line.size() && line[k] == ' ') ++k;
    int code = -1;
    for (; digitAt(line, k) && code < 1000; ++k) code = 10 * std::max(code, 0) + (line[k] - '0');
    if (code == mcode::kEnd || code == mcode::kEndAndRewind || code == mcode::kReturn) return true;
  }
  return false;
}

/// Does the line look like a block: a G or M word behind N and /?
bool looksLikeBlock(std::string_view line) {
  std::size_t i = 0;
  if (i < line.size() && line[i] == '/') ++i;
  if (i < line.size() && (line[i] == 'N' || line[i] == 'n')) {
    for (++i; digitAt(line, i) || (i < line.size() && line[i] == ' ');) ++i;
  }
  return i < line.size() && std::string_view("GgMm").find(line[i]) != std::string_view::npos &&
         digitAt(line, i + 1);
}

/// Lines in front of the first %, which they are the leader of if that opens the program. A % behind the end
/// of a program, or with nothing behind it, closes one.
std::size_t leaderLines(const std::vector<std::string_view>& lines) {
  const auto marks = [](std::string_view line) { return trimmed(line).starts_with('%'); };
  std::size_t mark = 0;
  while (mark < lines.size() && !marks(lines[mark])) ++mark;
  bool follows = false;
  for (std::size_t k = mark + 1; k < lines.size() && !follows; ++k) {
    follows = !trimmed(lines[k]).empty() && !marks(lines[k]);
  }
  if (!follows) return 0;
  for (std::size_t k = 0; k < mark; ++k) {
    if (endsProgram(lines[k])) return 0;
  }
  return mark;
}

}  // namespace

std::size_t TapeFrames::leaderOf(const SourceText& text) {
  const auto known = leaders_.find(&text);
  if (known != leaders_.end()) return known->second;
  return leaders_.emplace(&text, leaderLines(text.lines())).first->second;
}

void TapeFrames::skipLeader(IsoContext& c, CallFrame& frame) {
  if (frame.text->firstLine() > 0) {  // a program behind another one of its file
    frame.next = frame.text->firstLine();
    return;
  }
  const std::size_t leader = leaderOf(*frame.text);
  frame.next = leader;
  std::size_t first = leader, block = leader;
  for (std::size_t k = leader; k-- > 0;) {
    const std::string_view line = trimmed(frame.text->lines()[k]);
    if (!line.empty() && line[0] != '(') first = k;
    if (looksLikeBlock(line)) block = k;
  }
  if (first == leader || !c.firstTime(fmt::format("leader {}", frame.file))) return;
  c.setBlock(block == leader ? first : block, -1);
  c.block.clear();
  if (block == leader) {
    c.warn("leader", "text in front of the first % is skipped, up to there", {}, Severity::kNote);
  } else {
    c.warn("leader", "blocks in front of the first % are skipped: the program begins behind it");
  }
}

bool TapeFrames::onlyHeaderAbove(const CallStack& calls) {
  const SourceText& text = *calls.top().text;
  for (std::size_t k = text.firstLine() > 0 ? text.firstLine() : leaderOf(text); k < calls.lineIndex(); ++k) {
    const auto line = calls.top().text->lines()[k];
    const auto first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && line[first] != '%' && line[first] != '(') return false;
  }
  return true;
}

bool TapeFrames::checkHeader(IsoContext& c) {
  // Only in front of everything else: a second O word would start another program in the same text.
  if (c.block.program < 0 || onlyHeaderAbove(c.calls)) return true;
  return c.alarm(SharedAlarm::kIllegalAddress, "O",
                 "a program number stands at the head of the text; subprograms are files of their own",
                 c.block.program_columns);
}

void noteTapeName(IsoContext& c) {
  const std::string_view text = c.block.text;
  const std::size_t begin = text.find_first_not_of(" \t", text.find('%') + 1);
  const bool name =
      begin != std::string_view::npos && text[begin] != '(' && text[begin] != '%' && c.block.program < 0;
  if (!name || !c.firstTime(fmt::format("tape name {}", c.calls.here().file))) return;
  c.warn("tape-name", fmt::format("{} behind % is a name and skipped", trimmed(text.substr(begin))),
         {static_cast<int>(begin) + 1, static_cast<int>(text.size()) + 1}, Severity::kNote);
}

}  // namespace proveout::nc
