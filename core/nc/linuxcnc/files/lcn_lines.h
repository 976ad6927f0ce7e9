// The lines of a file of the machine.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Calls `take` with each line, without its end.
template <class Take>
void forEachLcnLine(std::string_view text, Take take) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    take(line);
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
  }
}

/// Calls `take` with each line that has one of the small `letters`, as such or as a capital: long programs
/// are not taken apart into lines for it.
template <class Take>
void forEachLcnLineWith(std::string_view letters, std::string_view text, Take take) {
  struct Found {
    char letter;
    std::size_t at;
  };
  std::vector<Found> found;  // each letter apart: most texts have few of them
  for (const char c : letters)
    for (const char letter : {c, static_cast<char>(c & ~0x20)}) found.push_back({letter, text.find(letter)});
  const auto next = [&](std::size_t from) {
    std::size_t first = text.size();
    for (Found& of : found) {
      if (of.at < from) of.at = text.find(of.letter, from);
      first = std::min(first, of.at);
    }
    return first;
  };
  for (std::size_t at = next(0); at < text.size(); at = next(at)) {
    const std::size_t first = text.rfind('\n', at) + 1;  // npos + 1 is 0
    at = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(first, at - first);
    if (line.ends_with('\r')) line.remove_suffix(1);
    take(line);
  }
}

inline std::string_view lcnTrimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace proveout::nc
