#include "core/nc/linuxcnc/macro/lcn_o_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/characters.h"

namespace proveout::nc {
namespace {

constexpr auto kLcnKeywords =
    std::to_array<std::pair<std::string_view, LcnKeyword>>({{"sub", LcnKeyword::kSub},
                                                            {"endsub", LcnKeyword::kEndSub},
                                                            {"return", LcnKeyword::kReturn},
                                                            {"call", LcnKeyword::kCall},
                                                            {"if", LcnKeyword::kIf},
                                                            {"elseif", LcnKeyword::kElseIf},
                                                            {"else", LcnKeyword::kElse},
                                                            {"endif", LcnKeyword::kEndIf},
                                                            {"while", LcnKeyword::kWhile},
                                                            {"endwhile", LcnKeyword::kEndWhile},
                                                            {"do", LcnKeyword::kDo},
                                                            {"repeat", LcnKeyword::kRepeat},
                                                            {"endrepeat", LcnKeyword::kEndRepeat},
                                                            {"break", LcnKeyword::kBreak},
                                                            {"continue", LcnKeyword::kContinue}});

bool isSmall(char c) { return c >= 'a' && c <= 'z'; }

/// Behind the label that begins at `pos`; `pos` itself: there is none.
std::size_t behindLabel(std::string_view text, std::size_t pos) {
  std::size_t i = pos;
  while (i < text.size() && text[i] == '#') ++i;
  if (i >= text.size()) return pos;
  if (text[i] == '<') {
    const std::size_t close = text.find('>', i);
    return close == std::string_view::npos ? pos : close + 1;
  }
  if (text[i] == '[') {
    int depth = 0;
    for (; i < text.size(); ++i) {
      depth += text[i] == '[' ? 1 : text[i] == ']' ? -1 : 0;
      if (depth == 0) return i + 1;
    }
    return pos;
  }
  const std::size_t digits = i;
  while (i < text.size() && isDigit(text[i])) ++i;
  return i == digits ? pos : i;
}

/// Behind a block number and the / in front of a line.
std::size_t behindNumber(std::string_view text) {
  std::size_t i = !text.empty() && text[0] == '/' ? 1 : 0;
  if (i < text.size() && text[i] == 'n') {
    for (++i; i < text.size() && (isDigit(text[i]) || text[i] == '.');) ++i;
  }
  return i;
}

bool mayHaveOWord(std::string_view line) {
  for (const char c : line) {
    if (c == 'o' || c == 'O') return true;
    if (!isBlank(c) && !isDigit(c) && c != '/' && c != 'n' && c != 'N' && c != '.' && c != '(') return false;
    if (c == '(') return line.find_first_of("oO") != std::string_view::npos;
  }
  return false;
}

}  // namespace

std::string_view lcnKeywordName(LcnKeyword keyword) {
  for (const auto& [name, known] : kLcnKeywords)
    if (known == keyword) return name;
  return {};
}

bool takeLcnOWord(std::string_view text, std::size_t pos, LcnOWord& out) {
  const std::size_t end = behindLabel(text, pos);
  if (end == pos) return false;
  out.label_at = pos;
  out.label = text.substr(pos, end - pos);
  out.computed = text[pos] == '#' || text[pos] == '[';
  std::size_t letters = end;
  while (letters < text.size() && isSmall(text[letters])) ++letters;
  const std::string_view word = text.substr(end, letters - end);
  out.behind = letters;
  out.keyword = word.empty() ? LcnKeyword::kLabel : LcnKeyword::kUnknown;
  for (const auto& [name, keyword] : kLcnKeywords)
    if (name == word) out.keyword = keyword;
  return true;
}

std::string lcnLabel(std::string_view label) {
  while (label.size() > 1 && label[0] == '0' && isDigit(label[1])) label.remove_prefix(1);
  return std::string(label);
}

LcnOWords::LcnOWords(const std::vector<std::string_view>& lines) {
  LcnLine line;
  LcnFault fault;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const bool may = mayHaveOWord(lines[k]);
    if (!may && lines[k].size() <= kLongestLcnLine && lines[k].find('(') == std::string_view::npos) continue;
    if (!takeLcnLine(lines[k], line, fault)) {
      unreadable_.push_back({k, fault.name, fault.message});
      continue;
    }
    if (!may) continue;
    const std::size_t at = behindNumber(line.text);
    LcnOWord word;
    if (at >= line.text.size() || line.text[at] != 'o' || !takeLcnOWord(line.text, at + 1, word)) continue;
    if (word.keyword == LcnKeyword::kUnknown) unreadable_.push_back({k, "o-word", kUnknownLcnCommand});
    take(k, word);
  }
  pair();
}

const LcnOWords::Unreadable* LcnOWords::unreadable(std::size_t from, std::size_t to) const {
  const auto found = std::find_if(unreadable_.begin(), unreadable_.end(),
                                  [&](const Unreadable& u) { return u.line >= from && u.line < to; });
  return found == unreadable_.end() ? nullptr : &*found;
}

void LcnOWords::take(std::size_t line, const LcnOWord& word) {
  if (word.keyword == LcnKeyword::kUnknown) return;
  Statement statement;
  statement.line = line;
  statement.keyword = word.keyword;
  statement.label = lcnLabel(word.label);
  statements_.push_back(std::move(statement));
}

std::size_t LcnOWords::find(const ByLabel& labels, const std::string& label) {
  const auto found = labels.find(label);
  return found == labels.end() ? kNone : found->second;
}

std::size_t LcnOWords::on(std::size_t line) const {
  const auto found = std::lower_bound(statements_.begin(), statements_.end(), line,
                                      [](const Statement& s, std::size_t l) { return s.line < l; });
  if (found == statements_.end() || found->line != line) return kNone;
  return static_cast<std::size_t>(found - statements_.begin());
}

void LcnOWords::pair() {
  for (std::size_t k = 0; k < statements_.size(); ++k) {
    Statement& s = statements_[k];
    const bool opens = s.keyword == LcnKeyword::kSub || s.keyword == LcnKeyword::kLabel;
    if (opens) openScope(k);
    s.scope = scope_;
    pairBranch(k);
    pairLoop(k);
    if (s.keyword == LcnKeyword::kEndSub) closeSub(k);
  }
}

void LcnOWords::openScope(std::size_t k) {
  Statement& s = statements_[k];
  ByLabel& known = s.keyword == LcnKeyword::kSub ? subs_ : labels_;
  if (s.keyword == LcnKeyword::kSub && sub_ != kNone) s.clash = sub_;
  const auto [first, fresh] = known.emplace(s.label, k);
  if (!fresh && s.keyword == LcnKeyword::kSub) s.clash = first->second;
  if (s.keyword == LcnKeyword::kSub) {
    sub_ = k;
    outside_ = std::move(heads_);
  }
  scope_ = ++scopes_;
  heads_.clear();
}

void LcnOWords::closeSub(std::size_t k) {
  const std::size_t sub = find(subs_, statements_[k].label);
  if (sub == kNone || statements_[sub].partner != kNone) return;
  statements_[sub].partner = k;
  statements_[k].partner = sub;
  sub_ = kNone;
  scope_ = 0;
  heads_ = std::move(outside_);
}

/// if, elseif and else lead to the next of their branches.
void LcnOWords::pairBranch(std::size_t k) {
  Statement& s = statements_[k];
  if (s.keyword == LcnKeyword::kIf) return openHead(k);
  if (s.keyword != LcnKeyword::kElseIf && s.keyword != LcnKeyword::kElse && s.keyword != LcnKeyword::kEndIf)
    return;
  const auto head = heads_.find(s.label);
  if (head == heads_.end() || statements_[head->second].keyword != LcnKeyword::kIf) return;
  std::size_t last = head->second;  // the branch before
  while (statements_[last].partner != kNone) last = statements_[last].partner;
  if (statements_[last].keyword == LcnKeyword::kEndIf) return;
  statements_[last].partner = k;
  s.head = head->second;
}

void LcnOWords::openHead(std::size_t k) {
  const auto [first, fresh] = heads_.emplace(statements_[k].label, k);
  if (!fresh) statements_[k].clash = first->second;
}

void LcnOWords::pairLoop(std::size_t k) {
  Statement& s = statements_[k];
  const std::size_t head = find(heads_, s.label);
  const LcnKeyword opened = head == kNone ? LcnKeyword::kLabel : statements_[head].keyword;
  const bool open = head != kNone && statements_[head].partner == kNone;
  const bool closes = open && ((s.keyword == LcnKeyword::kWhile && opened == LcnKeyword::kDo) ||
                               (s.keyword == LcnKeyword::kEndWhile && opened == LcnKeyword::kWhile) ||
                               (s.keyword == LcnKeyword::kEndRepeat && opened == LcnKeyword::kRepeat));
  if (closes) {
    s.partner = s.head = head;
    s.closes_do = opened == LcnKeyword::kDo;
    statements_[head].partner = k;
  } else if (s.keyword == LcnKeyword::kWhile || s.keyword == LcnKeyword::kDo ||
             s.keyword == LcnKeyword::kRepeat) {
    openHead(k);
  } else if (s.keyword == LcnKeyword::kBreak || s.keyword == LcnKeyword::kContinue) {
    s.head = head;
  }
}

}  // namespace proveout::nc
