#include "core/nc/linuxcnc/files/lcn_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <set>
#include <sstream>

#include "core/base/characters.h"
#include "core/nc/linuxcnc/files/lcn_lines.h"
#include "core/nc/linuxcnc/files/lcn_var_file.h"
#include "core/nc/linuxcnc/flavours/flavours.h"
#include "core/nc/linuxcnc/text/lcn_line.h"

namespace proveout::nc {
namespace {

/// The files that an INI file names.
std::vector<std::pair<std::string, std::string>> lcnFilesOf(std::string_view text) {
  const LcnIni ini(text);
  std::vector<std::pair<std::string, std::string>> out;
  if (const auto table = ini.text("EMCIO", "TOOL_TABLE")) out.emplace_back("tool_table", *table);
  if (const auto file = ini.text("RS274NGC", "PARAMETER_FILE")) out.emplace_back("parameters", *file);
  const auto folders = ini.text("RS274NGC", "SUBROUTINE_PATH");
  for (std::size_t at = 0; folders && at <= folders->size();) {
    const std::size_t end = std::min(folders->find(':', at), folders->size());
    if (end > at) out.emplace_back("subroutine_path", folders->substr(at, end - at));
    at = end + 1;
  }
  return out;
}

constexpr auto kLcnTexts = std::to_array<TextSetting>({
    {"tool_table", TextSetting::Kind::kFile, "lines T P X Y Z A B C U V W D I J Q ;text, machine units"},
    {"parameters", TextSetting::Kind::kFile, "the .var file: number and value a line, machine units"},
    {"ini", TextSetting::Kind::kFile, "the machine's INI file", lcnFilesOf},
    {"axes", TextSetting::Kind::kText, "letters taken as axes, \"XYZA\""},
    {"subroutine_path", TextSetting::Kind::kFolders, "where name.ngc of calls lies as well"},
    {"startup", TextSetting::Kind::kText, "a line that runs in front of the program"},
    {"remap", TextSetting::Kind::kTable, "codes that stand for subroutines: M6 = \"change.ngc\""},
    {"inputs", TextSetting::Kind::kTable, "answers of M66: P0 = 1, E1 = 2.5"},
    {"hal", TextSetting::Kind::kTable, "values of #<_hal[pin]>"},
});

std::string lcnSmall(std::string_view text) {
  std::string out;
  for (const char c : text) out += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return out;
}

std::string lcnCapital(std::string_view text) {
  std::string out;
  for (const char c : text)
    if (!isBlank(c)) out += upper(c);
  return out;
}

std::string lcnText(const ControlSettings& settings, const std::string& name) {
  const auto found = settings.texts.find(name);
  return found == settings.texts.end() ? std::string() : found->second;
}

/// Settings "name.key" of a table, by key.
template <class Take>
void forEachOf(const ControlSettings& settings, const std::string& table, Take take) {
  const std::string prefix = table + ".";
  for (auto at = settings.texts.lower_bound(prefix);
       at != settings.texts.end() && at->first.starts_with(prefix); ++at)
    take(at->first.substr(prefix.size()), at->second);
}

void readNumbers(const ControlSettings& settings, const std::string& table, bool capital,
                 std::map<std::string, double>& out, std::vector<std::string>& faults) {
  forEachOf(settings, table, [&](const std::string& key, const std::string& text) {
    double value = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (read.ec == std::errc() && read.ptr == text.data() + text.size()) {
      out[capital ? lcnCapital(key) : lcnSmall(key)] = value;
    } else {
      faults.push_back(fmt::format("{}.{}: a number is expected", table, key));
    }
  });
}

/// "change" of "lib/Change.ngc".
std::string lcnStem(std::string_view path) {
  if (const std::size_t slash = path.find_last_of("/\\"); slash != std::string_view::npos)
    path.remove_prefix(slash + 1);
  if (lcnSmall(path).ends_with(".ngc")) path.remove_suffix(4);
  return lcnSmall(path);
}

/// REMAP=M6 modalgroup=6 argspec=pq ngc=change
void readRemap(const std::string& line, std::map<std::string, LcnRemap>& out) {
  std::istringstream words(line);
  std::string code;
  words >> code;
  LcnRemap remap;
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) continue;
    const std::string name = lcnSmall(word.substr(0, equals));
    if (name == "ngc") remap.sub = lcnStem(word.substr(equals + 1));
    remap.python = remap.python || name == "python" || name == "py" || name == "prolog" || name == "epilog";
  }
  out[lcnCapital(code)] = remap;
}

double lcnScale(const ControlSettings& settings) {
  const auto units = settings.parameters.find("units");
  return units != settings.parameters.end() && units->second == 1.0 ? 25.4 : 1.0;
}

/// Number of an axis beyond X, Y, Z: A 4 .. W 9.
AxisSettings lcnAxisOf(char letter) {
  AxisSettings axis;
  axis.name = std::string(1, letter);
  axis.number = static_cast<int>(std::string_view("ABCUVW").find(letter)) + 4;
  if (letter < 'U') return axis;
  axis.kind = AxisKind::kLinear;
  axis.parallel = std::string(1, static_cast<char>(letter - 'U' + 'X'));
  return axis;
}

void takeAxes(const std::string& letters, ControlSettings& out) {
  for (const char c : lcnCapital(letters)) {
    const bool known = std::any_of(out.axes.begin(), out.axes.end(),
                                   [&](const AxisSettings& axis) { return axis.name == std::string(1, c); });
    if (!known && std::string_view("ABCUVW").find(c) != std::string_view::npos)
      out.axes.push_back(lcnAxisOf(c));
  }
}

/// GRBL and Smoothie have X, Y and Z unless somebody says more.
bool mayHaveRotary(const ControlSettings& settings) {
  const auto flavour = settings.parameters.find("flavour");
  if (flavour == settings.parameters.end()) return true;
  const auto is = static_cast<LinuxCncFlavour>(static_cast<int>(flavour->second));
  return is != LinuxCncFlavour::kGrbl && is != LinuxCncFlavour::kSmoothie;
}

void takeLimits(const LcnIni& ini, double scale, ControlSettings& out) {
  for (int axis = 0; axis < 3; ++axis) {
    auto& limit = out.limits[static_cast<std::size_t>(axis)];
    std::optional<double> low, high;
    const std::string by_letter = fmt::format("AXIS_{}", "XYZ"[axis]),
                      by_number = fmt::format("AXIS_{}", axis);
    for (const std::string& section : {by_letter, by_number}) {
      if (!low) low = ini.number(section, "MIN_LIMIT");
      if (!high) high = ini.number(section, "MAX_LIMIT");
    }
    if (!limit && low && high && *low < *high) limit = AxisLimit{*low * scale, *high * scale};
  }
}

bool isLcnLetter(char c) { return c >= 'a' && c <= 'z'; }

/// Adds the letters of one line, without blanks and comments and in small letters.
void addRotaryWords(std::string_view line, std::string& out) {
  constexpr std::string_view kValue = "0123456789+-.[#";
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '<') i = std::min(line.find('>', i), line.size() - 1);
    if (line[i] < 'a' || line[i] > 'c') continue;
    const bool alone = (i == 0 || !isLcnLetter(line[i - 1])) && i + 1 < line.size() &&
                       kValue.find(line[i + 1]) != std::string_view::npos;
    if (alone && out.find(upper(line[i])) == std::string::npos) out += upper(line[i]);
  }
}

/// The number behind the first q of a line with G70, G71 or G72; empty: there is none.
std::string_view contourOf(std::string_view line) {
  const std::size_t code = line.find("g7");
  if (code == std::string_view::npos || code + 2 >= line.size() ||
      std::string_view("012").find(line[code + 2]) == std::string_view::npos)
    return {};
  const std::size_t q = line.find('q');
  if (q == std::string_view::npos) return {};
  const std::size_t end = std::min(line.find_first_not_of("0123456789", q + 1), line.size());
  return line.substr(q + 1, end - q - 1);
}

/// Numbers of the subs that are contours of G70, G71, G72: A and C are corners there.
std::set<std::string, std::less<>> contoursOf(std::string_view program) {
  std::set<std::string, std::less<>> out;
  LcnLine line;
  LcnFault fault;
  forEachLcnLineWith("q", program, [&](std::string_view text) {
    if (takeLcnLine(text, line, fault))
      if (const std::string_view number = contourOf(line.text); !number.empty()) out.emplace(number);
  });
  return out;
}

}  // namespace

std::string lcnRotaryWords(std::string_view program) {
  const auto contours = contoursOf(program);
  std::string out;
  bool corners = false;
  LcnLine line;
  LcnFault fault;
  forEachLcnLineWith("abco", program, [&](std::string_view text) {
    if (!takeLcnLine(text, line, fault)) return;
    if (!line.text.starts_with('o')) return corners ? void() : addRotaryWords(line.text, out);
    const std::size_t digits = std::min(line.text.find_first_not_of("0123456789", 1), line.text.size());
    if (!contours.contains(line.text.substr(1, digits - 1))) return;
    const std::string_view word = std::string_view(line.text).substr(digits);
    if (word == "sub" || word.starts_with("endsub")) corners = word == "sub";
  });
  std::sort(out.begin(), out.end());
  return out;
}

std::span<const TextSetting> linuxCncTexts() { return kLcnTexts; }

LcnMachine readLcnMachine(const ControlSettings& settings) {
  LcnMachine out;
  out.ini = LcnIni(lcnText(settings, "ini"));
  out.changes_with_spindle_on = out.ini.number("EMCIO", "TOOL_CHANGE_WITH_SPINDLE_ON").value_or(0.0) != 0.0;
  std::vector<std::string> faults;
  out.has_tools = settings.texts.contains("tool_table");
  out.tools = readLcnToolTable(lcnText(settings, "tool_table"), lcnScale(settings), faults);
  for (const std::string& fault : faults) out.faults.push_back("tool_table: " + fault);
  faults.clear();
  out.kept = readLcnVarFile(lcnText(settings, "parameters"), faults);
  for (const std::string& fault : faults) out.faults.push_back("parameters: " + fault);
  readNumbers(settings, "inputs", true, out.inputs, out.faults);
  readNumbers(settings, "hal", false, out.pins, out.faults);
  if (const auto* lines = out.ini.all("RS274NGC", "REMAP"))
    for (const std::string& line : *lines) readRemap(line, out.remaps);
  forEachOf(settings, "remap", [&](const std::string& code, const std::string& file) {
    out.remaps[lcnCapital(code)] = {lcnStem(file), lcnSmall(file).ends_with(".py")};
  });
  for (const std::optional<std::string>& line :
       {out.ini.text("RS274NGC", "RS274NGC_STARTUP_CODE"), out.ini.text("EMC", "RS274NGC_STARTUP_CODE")})
    if (line && !line->empty()) out.startup.push_back(*line);
  if (const std::string line = lcnText(settings, "startup"); !line.empty()) out.startup.push_back(line);
  return out;
}

ControlSettings withLcnMachine(const ControlSettings& settings, std::string_view program) {
  ControlSettings out = settings;
  const LcnIni ini(lcnText(settings, "ini"));
  std::optional<std::string> units = ini.text("TRAJ", "LINEAR_UNITS");
  if (units && !out.parameters.contains("units"))
    out.parameters["units"] = lcnSmall(*units).starts_with("in") ? 1.0 : 0.0;
  const double scale = lcnScale(out);
  if (out.parameters.contains("units") && scale != 1.0) out.units = LengthUnit::kInch;
  const std::string named = lcnText(settings, "axes");
  if (!named.empty()) {
    takeAxes(named, out);
  } else if (const auto coordinates = ini.text("TRAJ", "COORDINATES")) {
    takeAxes(*coordinates, out);
  } else if (out.axes.empty() && !out.machine && mayHaveRotary(out)) {
    const std::string letters = lcnRotaryWords(program);
    takeAxes(letters, out);
    if (!letters.empty()) out.texts[kLcnAssumedAxes] = letters;
  }
  takeLimits(ini, scale, out);
  const auto lathe = ini.text("DISPLAY", "LATHE");
  if (lathe && (*lathe == "1" || lcnSmall(*lathe) == "true") && !out.parameters.contains("lathe"))
    out.parameters["lathe"] = 1.0;
  for (const auto& [name, key] : {std::pair{"CENTER_ARC_RADIUS_TOLERANCE_MM", "arc_tolerance"},
                                  std::pair{"CENTER_ARC_RADIUS_TOLERANCE_INCH", "arc_tolerance_inch"}}) {
    if (const auto value = ini.number("RS274NGC", name)) out.parameters.emplace(key, *value);
  }
  return out;
}

}  // namespace proveout::nc
