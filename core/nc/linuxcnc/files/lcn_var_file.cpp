#include "core/nc/linuxcnc/files/lcn_var_file.h"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

#include "core/nc/linuxcnc/files/lcn_lines.h"
#include "core/nc/linuxcnc/macro/lcn_variables.h"

namespace proveout::nc {

std::vector<std::pair<int, double>> readLcnVarFile(std::string_view text, std::vector<std::string>& faults) {
  std::vector<std::pair<int, double>> out;
  int line = 0;
  forEachLcnLine(text, [&](std::string_view all) {
    ++line;
    std::string_view words = lcnTrimmed(all.substr(0, all.find_first_of(";#(")));
    if (words.empty()) return;
    int number = 0;
    double value = 0.0;
    const auto first = std::from_chars(words.data(), words.data() + words.size(), number);
    words = lcnTrimmed(words.substr(static_cast<std::size_t>(first.ptr - words.data())));
    const auto second = std::from_chars(words.data(), words.data() + words.size(), value);
    const bool good = first.ec == std::errc() && second.ec == std::errc() &&
                      second.ptr == words.data() + words.size() && std::isfinite(value);
    if (good && LcnVariables::exists(number)) {
      out.emplace_back(number, value);
    } else {
      faults.push_back(fmt::format("line {}: a number of a parameter and its value are expected", line));
    }
  });
  return out;
}

}  // namespace proveout::nc
