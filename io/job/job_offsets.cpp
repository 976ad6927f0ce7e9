#include "io/job/job_offsets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "core/base/nearest_name.h"
#include "core/base/printable.h"

namespace proveout {
namespace {

constexpr int kMaxExtended = 99, kMaxRow = 9999;
constexpr double kMaxOffset = 1e6;  // mm, as in job files
constexpr std::array<std::string_view, 4> kLatheTables{"DXW", "DZW", "RT", "TIP"};

const ParameterRange* rangeOf(std::string_view name, const std::vector<ParameterRange>& parameters) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const auto& one) { return one.name == name; });
  return found == parameters.end() || found->count == 0 ? nullptr : &*found;
}

std::string upperCase(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return out;
}

/// "07" as programs write it.
std::optional<int> rowNumber(std::string_view digits) {
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return plainNumber(digits, kMaxRow);
}

/// The name as messages write it. Nothing: no control of such parameters has it.
std::optional<std::string> knownName(const std::string& text, const std::vector<ParameterRange>& parameters) {
  const std::string name = upperCase(text);
  if (name == "COMMON") return "common";
  if (workOffsetIndex(name)) return name;
  constexpr std::string_view kExtended = "G54.1P";
  if (name.starts_with(kExtended) && workOffsetIndex("G54.1 P" + name.substr(kExtended.size())))
    return "G54.1 P" + name.substr(kExtended.size());
  const ParameterRange* const wire = rangeOf("H", parameters);
  if (name.starts_with('D') || name.starts_with('H')) {
    const auto row = rowNumber(std::string_view(name).substr(1));
    const bool there = wire == nullptr || (name[0] == 'H' && row && *row <= wire->count);
    if (row && there) return fmt::format("{}{}", name[0], *row);
  }
  const std::size_t dot = name.find('.');
  const auto table =
      std::find(kLatheTables.begin(), kLatheTables.end(), std::string_view(name).substr(0, dot));
  const ParameterRange* const range = table == kLatheTables.end() ? nullptr : rangeOf(*table, parameters);
  if (range == nullptr || dot == std::string::npos) return std::nullopt;
  const auto number = plainNumber(std::string_view(name).substr(dot + 1), range->count);
  return number ? std::optional(fmt::format("{}.{}", *table, *number)) : std::nullopt;
}

/// The refusal of a name: what it may mean, and what there is.
Error noOffset(const std::string& text, const std::vector<ParameterRange>& parameters) {
  const std::string name = upperCase(text);
  const std::size_t digits = std::min(name.find_first_of("0123456789"), name.size());
  const std::string number = digits < name.size() ? name.substr(digits) : "1";
  std::vector<std::string> near = {"G54", "G55", "G56", "G57", "G58", "G59", "common", "G54.1 P1"};
  std::string there = "G54 to G59, \"G54.1 P1\" to \"G54.1 P99\" and common";
  if (const ParameterRange* wire = rangeOf("H", parameters)) {
    near.push_back("H" + number);
    there += fmt::format(", H1 to H{}", wire->count);
  } else {
    near.insert(near.end(), {"D" + number, "H" + number});
    there += ", rows D1 to D9999 and H1 to H9999";
  }
  for (const std::string_view table : kLatheTables) {
    if (rangeOf(table, parameters) == nullptr) continue;
    near.push_back(fmt::format("{}.{}", table, number));
    there += fmt::format(", {0}.1 to {0}.{1}", table, rangeOf(table, parameters)->count);
  }
  std::string nearest = nearestName(name, near);
  if (nearest.empty()) nearest = nearestName(text, near);
  if (!knownName(nearest, parameters)) nearest.clear();
  return inputError(
      fmt::format("there is no offset '{}'{}; there are {}", shortened(text), didYouMean(nearest), there));
}

Result<std::vector<double>> numbers(std::string_view text, std::size_t count, const std::string& name) {
  const Error usage = inputError(count == 3 ? fmt::format("{0} takes three numbers, mm: {0}=X,Y,Z", name)
                                            : fmt::format("{0} takes one number{1}: {0}=VALUE", name,
                                                          name.starts_with("TIP") ? "" : ", mm"));
  std::vector<double> values;
  while (true) {
    const std::size_t end = std::min(text.find(','), text.size());
    double value = 0.0;
    const auto [last, error] = std::from_chars(text.data(), text.data() + end, value);
    if (error != std::errc() || last != text.data() + end || !std::isfinite(value)) return usage;
    if (std::abs(value) > kMaxOffset)
      return inputError(fmt::format("{}: {:g} is beyond {:g} mm", name, value, kMaxOffset));
    values.push_back(value + 0.0);
    if (end == text.size() || values.size() > count) break;
    text.remove_prefix(end + 1);
  }
  return values.size() == count ? Result<std::vector<double>>(std::move(values)) : usage;
}

/// The parameter that holds it, "H.1" or "DXW.3"; "": a row or a work offset does.
std::string parameterName(const std::string& name, const std::vector<ParameterRange>& parameters) {
  if (name.find('.') != std::string::npos && !name.starts_with('G')) return name;
  if (name.starts_with('H') && rangeOf("H", parameters) != nullptr) return "H." + name.substr(1);
  return {};
}

}  // namespace

std::optional<int> plainNumber(std::string_view text, int max) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool plain = error == std::errc{} && end == text.data() + text.size() && text.front() != '0';
  if (!plain || number < 1 || number > max) return std::nullopt;
  return number;
}

std::optional<int> workOffsetIndex(const std::string& name) {
  if (name.size() == 3 && name.starts_with("G5") && name[2] >= '4' && name[2] <= '9') return name[2] - '4';
  constexpr std::string_view kExtended = "G54.1 P";
  if (name.starts_with(kExtended)) {
    if (const auto p = plainNumber(std::string_view(name).substr(kExtended.size()), kMaxExtended)) return -*p;
  }
  return std::nullopt;
}

Result<OffsetEntry> parseOffset(const std::string& text, const std::vector<ParameterRange>& parameters) {
  const std::size_t equals = text.find('=');
  const std::string given = text.substr(0, equals);
  const auto name = knownName(given, parameters);
  if (!name) return noOffset(given, parameters);
  const bool work = *name == "common" || workOffsetIndex(*name).has_value();
  const std::string_view behind =
      equals == std::string::npos ? std::string_view() : std::string_view(text).substr(equals + 1);
  Result<std::vector<double>> values = numbers(behind, work ? 3 : 1, *name);
  if (!values) return values.error();
  const std::string parameter = parameterName(*name, parameters);
  const ParameterRange* const range =
      parameter.empty() ? nullptr : rangeOf(parameter.substr(0, parameter.find('.')), parameters);
  if (range != nullptr && (values->front() < range->min || values->front() > range->max))
    return inputError(
        fmt::format("{}: {:g} is not from {:g} to {:g}", *name, values->front(), range->min, range->max));
  return OffsetEntry{*name, std::move(*values)};
}

void setOffset(const OffsetEntry& entry, const std::vector<ParameterRange>& parameters,
               ControlSettings& settings) {
  const auto& v = entry.values;
  if (entry.name == "common") {
    settings.common_offset = Vec3(v[0], v[1], v[2]);
  } else if (const auto index = workOffsetIndex(entry.name); index && *index >= 0) {
    settings.work_offsets[static_cast<std::size_t>(*index)] = Vec3(v[0], v[1], v[2]);
    settings.work_given[static_cast<std::size_t>(*index)] = true;
  } else if (index) {
    settings.extended_offsets[-*index] = Vec3(v[0], v[1], v[2]);
  } else if (const std::string name = parameterName(entry.name, parameters); !name.empty()) {
    settings.parameters[name] = v[0];
  } else {
    auto& rows = entry.name[0] == 'D' ? settings.radius_offsets : settings.length_offsets;
    rows[*plainNumber(std::string_view(entry.name).substr(1), kMaxRow)] = {v[0], 0.0};
  }
}

}  // namespace proveout
