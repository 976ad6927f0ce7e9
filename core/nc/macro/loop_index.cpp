#include "core/nc/macro/loop_index.h"

#include <algorithm>

#include "core/base/characters.h"
#include "core/nc/macro/expression.h"

namespace proveout::nc {
namespace {

/// Behind the bracket that opens at text[pos]; npos: it stays open.
std::size_t behindBracket(std::string_view text, std::size_t pos) {
  int depth = 0;
  for (; pos < text.size(); ++pos) {
    if (text[pos] == '[') ++depth;
    if (text[pos] == ']' && --depth == 0) return pos + 1;
  }
  return std::string_view::npos;
}

/// The first character behind comments, skip marks and the block number. `comment` tells whether the line
/// starts inside a comment and, afterwards, whether it ends inside one.
std::size_t lineHead(std::string_view line, bool& comment) {
  std::size_t head = std::string_view::npos;
  bool number = false;  // inside the block number
  for (std::size_t k = 0; k < line.size(); ++k) {
    const char c = line[k];
    if (comment) {
      comment = c != ')';
    } else if (c == '(') {
      comment = true;
    } else if (head == std::string_view::npos && c != ' ' && c != '\t') {
      if (c == '/' || (number && isDigit(c))) {
        number = true;
      } else if (c == 'N' || c == 'n') {
        number = true;
      } else {
        head = k;
      }
    }
  }
  return head;
}

}  // namespace

std::size_t whileLength(std::string_view text, std::size_t pos) {
  if (keywordAt(text, pos, "WHILE")) return 5;
  if (pos + 1 >= text.size() || upper(text[pos]) != 'W' || upper(text[pos + 1]) != 'H') return 0;
  const std::size_t open = skipBlanks(text, pos + 2);
  return open < text.size() && text[open] == '[' ? 2 : 0;
}

std::size_t loopNumberAt(std::string_view text, std::size_t pos) {
  if (keywordAt(text, pos, "END")) return skipBlanks(text, pos + 3);
  if (const std::size_t length = whileLength(text, pos); length > 0) {
    pos = skipBlanks(text, pos + length);
    if (pos >= text.size() || text[pos] != '[') return std::string_view::npos;
    pos = behindBracket(text, pos);
    if (pos == std::string_view::npos) return pos;
    pos = skipBlanks(text, pos);
  }
  return keywordAt(text, pos, "DO") ? skipBlanks(text, pos + 2) : std::string_view::npos;
}

int loopNumber(std::string_view text, std::size_t pos) {
  if (pos >= text.size() || text[pos] < '1' || text[pos] > '3') return -1;
  return pos + 1 < text.size() && (isDigit(text[pos + 1]) || text[pos + 1] == '.') ? -1 : text[pos] - '0';
}

LoopIndex::LoopIndex(const std::vector<std::string_view>& lines, bool comments_end_in_line) {
  bool comment = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::string_view line = lines[k];
    if (comments_end_in_line) comment = false;
    const std::size_t head = lineHead(line, comment);
    if (head == std::string_view::npos) continue;
    const bool is_end = keywordAt(line, head, "END");
    if (!is_end && !keywordAt(line, head, "DO") && whileLength(line, head) == 0) continue;
    const int number = loopNumber(line, loopNumberAt(line, head));
    if (number > 0) add(k, number, is_end);
  }
  for (const std::size_t left : open_) marks_[left].fault = Fault::kNoEnd;
}

void LoopIndex::add(std::size_t line, int number, bool is_end) {
  Mark mark{line, line, number, is_end, Fault::kNone, open_.empty() ? kNone : open_.back()};
  const auto same = [&](std::size_t k) { return marks_[k].number == number; };
  if (!is_end) {
    if (std::any_of(open_.begin(), open_.end(), same)) {
      mark.fault = Fault::kDoubled;
    } else {
      open_.push_back(marks_.size());
    }
  } else if (!open_.empty() && same(open_.back())) {
    mark.partner = marks_[open_.back()].line;
    marks_[open_.back()].partner = line;
    mark.outer = marks_[open_.back()].outer;
    open_.pop_back();
  } else {
    mark.fault = Fault::kNoDo;
  }
  marks_.push_back(mark);
}

const LoopIndex::Mark* LoopIndex::find(std::size_t line) const {
  const auto at = std::lower_bound(marks_.begin(), marks_.end(), line,
                                   [](const Mark& m, std::size_t wanted) { return m.line < wanted; });
  return at != marks_.end() && at->line == line ? &*at : nullptr;
}

const LoopIndex::Mark* LoopIndex::entered(std::size_t from, std::size_t to) const {
  const auto behind = std::lower_bound(marks_.begin(), marks_.end(), to,
                                       [](const Mark& m, std::size_t wanted) { return m.line < wanted; });
  if (behind == marks_.begin()) return nullptr;
  const Mark& before = *(behind - 1);
  const Mark* found = nullptr;
  for (std::size_t k = before.is_end ? before.outer : static_cast<std::size_t>(&before - marks_.data());
       k != kNone; k = marks_[k].outer) {
    const Mark& loop = marks_[k];
    const bool around = loop.fault == Fault::kNone && to <= loop.partner;
    if (around && !(from >= loop.line && from <= loop.partner)) found = &loop;
  }
  return found;
}

}  // namespace proveout::nc
