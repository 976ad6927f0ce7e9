#include "core/nc/linuxcnc/text/lcn_line.h"

#include "core/base/characters.h"

namespace proveout::nc {

Columns LcnLine::columnsOf(std::size_t begin, std::size_t end) const {
  if (columns.empty()) return {};
  const std::size_t last = columns.size() - 1;
  const int from = columns[begin < last ? begin : last];
  const int to = end > begin ? columns[end - 1 < last ? end - 1 : last] : from;
  return {from, to + 1};
}

bool takeLcnLine(std::string_view line, LcnLine& out, LcnFault& fault) {
  out.text.clear();
  out.columns.clear();
  out.comment = {};
  out.has_comment = false;
  if (line.size() > kLongestLcnLine) {
    fault = {"long-line", "Command too long: a line has 252 characters at most", kLongestLcnLine,
             line.size()};
    return false;
  }
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (isBlank(c) || c == '\r') continue;
    if (c == ';') return true;
    if (c != '(') {
      out.text += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
      out.columns.push_back(static_cast<std::uint16_t>(i + 1));
      continue;
    }
    const std::size_t open = i;
    for (++i; i < line.size() && line[i] != ')'; ++i) {
      if (line[i] != '(') continue;
      fault = {"nested-comment", "Nested comment found", open, i + 1};
      return false;
    }
    if (i >= line.size()) {
      fault = {"open-comment", "Unclosed comment found", open, line.size()};
      return false;
    }
    out.comment = line.substr(open + 1, i - open - 1);
    out.comment_columns = {static_cast<int>(open) + 1, static_cast<int>(i) + 2};
    out.has_comment = true;
  }
  return true;
}

}  // namespace proveout::nc
