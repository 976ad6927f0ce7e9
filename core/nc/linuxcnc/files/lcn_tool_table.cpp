#include "core/nc/linuxcnc/files/lcn_tool_table.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

#include "core/base/characters.h"
#include "core/nc/linuxcnc/files/lcn_lines.h"

namespace proveout::nc {
namespace {

/// Sets what a word of the line says. False: no tool has such a word or value.
bool takeToolWord(LcnTool& tool, char letter, double value, double scale) {
  constexpr std::string_view kAxes = "XYZABCUVW";
  const double whole = std::round(value);
  if (const std::size_t axis = kAxes.find(letter); axis != std::string_view::npos) {
    tool.offset[axis] = axis >= 3 && axis < 6 ? value : value * scale;
    return true;
  }
  switch (letter) {
    case 'T':
      tool.number = static_cast<int>(whole);
      return whole == value && value >= 0.0 && value <= 99999999.0;
    case 'P':
      tool.pocket = static_cast<int>(whole);
      return whole == value && value >= 0.0 && value <= 99999999.0;
    case 'D':
      tool.diameter = value * scale;
      return true;
    case 'I':
      tool.front = value;
      return true;
    case 'J':
      tool.back = value;
      return true;
    case 'Q':
      tool.orientation = static_cast<int>(whole);
      return whole == value && value >= 0.0 && value <= 9.0;
    default:
      return false;
  }
}

/// False: `fault` says what is wrong.
bool readTool(std::string_view words, double scale, LcnTool& tool, std::string& fault) {
  bool number = false, pocket = false;
  for (std::size_t i = 0; i < words.size();) {
    if (isBlank(words[i]) || words[i] == '\r') {
      ++i;
      continue;
    }
    const char letter = upper(words[i++]);
    if (i < words.size() && words[i] == '+') ++i;
    double value = 0.0;
    const char* const first = words.data() + i;
    const auto read = std::from_chars(first, words.data() + words.size(), value);
    if (read.ec != std::errc() || !(std::abs(value) <= 1e9)) {
      fault = fmt::format("a number is expected behind {}", letter);
      return false;
    }
    i += static_cast<std::size_t>(read.ptr - first);
    if (!takeToolWord(tool, letter, value, scale)) {
      fault = fmt::format("{}{} is no word of a tool", letter, value);
      return false;
    }
    number = number || letter == 'T';
    pocket = pocket || letter == 'P';
  }
  if (number && pocket) return true;
  fault = "a tool has a number and a pocket, T and P";
  return false;
}

}  // namespace

std::vector<LcnTool> readLcnToolTable(std::string_view text, double scale, std::vector<std::string>& faults) {
  std::vector<LcnTool> tools;
  int line = 0;
  forEachLcnLine(text, [&](std::string_view all) {
    ++line;
    const std::size_t semicolon = all.find(';');
    const std::string_view words = all.substr(0, semicolon);
    if (words.find_first_not_of(" \t\r") == std::string_view::npos) return;
    LcnTool tool;
    std::string fault;
    if (readTool(words, scale, tool, fault)) {
      if (semicolon != std::string_view::npos) tool.comment = std::string(all.substr(semicolon + 1));
      tools.push_back(tool);
    } else {
      faults.push_back(fmt::format("line {}: {}", line, fault));
    }
  });
  return tools;
}

}  // namespace proveout::nc
