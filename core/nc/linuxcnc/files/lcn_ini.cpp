#include "core/nc/linuxcnc/files/lcn_ini.h"

#include <charconv>
#include <cmath>

#include "core/base/characters.h"
#include "core/nc/linuxcnc/files/lcn_lines.h"

namespace proveout::nc {

std::string LcnIni::key(std::string_view section, std::string_view name) {
  std::string out;
  for (const char c : section) out += upper(c);
  out += ']';
  for (const char c : name) out += upper(c);
  return out;
}

LcnIni::LcnIni(std::string_view text) {
  std::string section;
  forEachLcnLine(text, [&](std::string_view all) {
    const std::string_view line = lcnTrimmed(all);
    if (line.empty() || line[0] == '#' || line[0] == ';') return;
    if (line[0] == '[') {
      section = std::string(lcnTrimmed(line.substr(1, line.find(']') - 1)));
      return;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return;
    std::string_view value = lcnTrimmed(line.substr(equals + 1));
    if (const std::size_t comment = value.find(" #"); comment != std::string_view::npos)
      value = lcnTrimmed(value.substr(0, comment));
    values_[key(section, lcnTrimmed(line.substr(0, equals)))].emplace_back(value);
  });
}

const std::vector<std::string>* LcnIni::all(std::string_view section, std::string_view name) const {
  const auto found = values_.find(key(section, name));
  return found == values_.end() ? nullptr : &found->second;
}

std::optional<std::string> LcnIni::text(std::string_view section, std::string_view name) const {
  const std::vector<std::string>* const values = all(section, name);
  if (values == nullptr) return {};
  return values->front();
}

std::optional<double> LcnIni::number(std::string_view section, std::string_view name) const {
  const std::optional<std::string> value = text(section, name);
  if (!value) return {};
  double out = 0.0;
  const auto read = std::from_chars(value->data(), value->data() + value->size(), out);
  if (read.ec != std::errc() || !std::isfinite(out)) return {};
  return out;
}

}  // namespace proveout::nc
