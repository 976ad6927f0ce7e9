#include "core/nc/text/program_heads.h"

#include "core/base/characters.h"

namespace proveout::nc {
namespace {

/// Behind what may stand in front of a program's number or name.
std::size_t headOf(std::string_view line) {
  std::size_t i = 0;
  while (i < line.size() && (isBlank(line[i]) || line[i] == '%')) ++i;
  return i;
}

/// The number behind the O or :, which stands at `i`; -1: none does.
std::int64_t numberOf(std::string_view line, std::size_t i) {
  constexpr std::int64_t kMost = 100'000'000;
  if (upper(line[i]) != 'O' && line[i] != ':') return -1;
  std::int64_t number = -1;
  for (++i; i < line.size() && isDigit(line[i]) && number < kMost; ++i)
    number = 10 * (number < 0 ? 0 : number) + (line[i] - '0');
  return number;
}

/// The name in < > that begins at `i`, behind an O or not; empty: none does.
std::string_view nameOf(std::string_view line, std::size_t i) {
  if (upper(line[i]) == 'O') i = line.find_first_not_of(" \t", i + 1);
  if (i == std::string_view::npos || line[i] != '<') return {};
  const std::size_t close = line.find('>', i);
  return close == std::string_view::npos ? std::string_view() : line.substr(i + 1, close - i - 1);
}

}  // namespace

std::vector<ProgramHead> programHeads(const std::vector<std::string_view>& lines, bool comments_end_in_line) {
  std::vector<ProgramHead> heads;
  bool comment = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::size_t head = headOf(lines[k]);
    const char first = head < lines[k].size() ? upper(lines[k][head]) : '\0';
    if (!comment && (first == 'O' || first == ':' || first == '<')) {
      const std::int64_t number = numberOf(lines[k], head);
      const bool may_have_name = comments_end_in_line && number < 0;
      const std::string_view name = may_have_name ? nameOf(lines[k], head) : std::string_view();
      if (number >= 0 || !name.empty()) heads.push_back({k, number, name});
    }
    if (comments_end_in_line) continue;
    for (const char c : lines[k]) comment = comment ? c != ')' : c == '(';
  }
  return heads;
}

}  // namespace proveout::nc
