#include "core/nc/linuxcnc/text/lcn_line.h"

#include "core/base/characters.h"

namespace proveout::nc {
namespace {

bool lineFault(LcnFault& fault, const char* name, const char* message, std::size_t begin, std::size_t end) {
  fault = {name, message, begin, end};
  return false;
}

/// A comment that opens at `i`, which goes to where it closes.
bool takeLcnComment(std::string_view line, std::size_t& i, LcnLine& out, LcnFault& fault) {
  const std::size_t open = i;
  for (++i; i < line.size() && line[i] != ')'; ++i) {
    if (line[i] == '(') return lineFault(fault, "nested-comment", "Nested comment found", open, i + 1);
  }
  if (i >= line.size()) return lineFault(fault, "open-comment", "Unclosed comment found", open, line.size());
  out.comment = line.substr(open + 1, i - open - 1);
  out.comment_columns = {static_cast<int>(open) + 1, static_cast<int>(i) + 2};
  out.has_comment = true;
  return true;
}

}  // namespace

Columns LcnLine::columnsOf(std::size_t begin, std::size_t end) const {
  if (columns.empty()) return {};
  const std::size_t last = columns.size() - 1;
  const int from = columns[begin < last ? begin : last];
  const int to = end > begin ? columns[end - 1 < last ? end - 1 : last] : from;
  return {from, to + 1};
}

bool takeLcnLine(std::string_view line, LcnLine& out, LcnFault& fault) {
  out.comment = {};
  out.has_comment = false;
  if (line.size() > kLongestLcnLine) {
    out.text.clear();
    out.columns.clear();
    return lineFault(fault, "long-line", "Command too long: a line has 252 characters at most",
                     kLongestLcnLine, line.size());
  }
  out.text.resize(line.size());
  out.columns.resize(line.size());
  char* const text = out.text.data();
  std::uint16_t* const columns = out.columns.data();
  std::size_t kept = 0;
  bool good = true;
  for (std::size_t i = 0; good && i < line.size() && line[i] != ';'; ++i) {
    const char c = line[i];
    if (isBlank(c) || c == '\r') continue;
    if (c == '(') {
      good = takeLcnComment(line, i, out, fault);
      continue;
    }
    text[kept] = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    columns[kept++] = static_cast<std::uint16_t>(i + 1);
  }
  out.text.resize(kept);
  out.columns.resize(kept);
  return good;
}

}  // namespace proveout::nc
