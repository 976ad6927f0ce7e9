#include "core/nc/text/program_heads.h"

#include "core/base/characters.h"

namespace proveout::nc {
namespace {

/// The number behind the O or : of the line; -1: it begins no program.
std::int64_t numberOf(std::string_view line) {
  constexpr std::int64_t kMost = 100'000'000;
  std::size_t i = line.find_first_not_of(" \t%");
  if (i == std::string_view::npos || (upper(line[i]) != 'O' && line[i] != ':')) return -1;
  std::int64_t number = -1;
  for (++i; i < line.size() && isDigit(line[i]) && number < kMost; ++i)
    number = 10 * (number < 0 ? 0 : number) + (line[i] - '0');
  return number;
}

}  // namespace

std::vector<ProgramHead> programHeads(const std::vector<std::string_view>& lines) {
  std::vector<ProgramHead> heads;
  bool comment = false;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::int64_t number = comment ? -1 : numberOf(lines[k]);
    if (number >= 0) heads.push_back({k, number});
    for (const char c : lines[k]) comment = comment ? c != ')' : c == '(';
  }
  return heads;
}

}  // namespace proveout::nc
