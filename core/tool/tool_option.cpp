// The command line's short way to describe a tool.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "core/base/nearest_name.h"
#include "core/tool/tool_type.h"

namespace proveout {

namespace {

std::optional<double> parseNumber(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

/// "N=flat:D, N=ball:D, ... or N=lollipop:D:NECKD".
std::string optionForms() {
  std::vector<std::string> forms;
  for (const ToolTypeRow* row : toolTypes()) {
    if (!row->option.empty()) forms.push_back(fmt::format("N={}", row->option));
  }
  const std::string last = std::move(forms.back());
  forms.pop_back();
  return fmt::format("{} or {}", fmt::join(forms, ", "), last);
}

}  // namespace

Result<Tool> parseToolOption(const std::string& text) {
  const auto wrong = [&](std::string_view why) {
    return inputError(fmt::format("--tool {}: {}; write {}, in mm and degrees", text, why, optionForms()));
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return wrong("no '='");
  Tool tool;
  const char* end_of_number = text.data() + equals;
  const auto [end, error] = std::from_chars(text.data(), end_of_number, tool.number);
  if (error != std::errc{} || end != end_of_number || tool.number < 0)
    return wrong("the tool number is not a whole number");
  const auto parts = split(std::string_view(text).substr(equals + 1), ':');
  const auto type = toolTypeOf(parts[0]);
  if (!type) {
    std::vector<std::string> names;
    for (const ToolTypeRow* row : toolTypes()) names.emplace_back(row->name);
    const std::string nearest = nearestName(parts[0], names);
    return wrong(fmt::format("unknown shape '{}'{}", parts[0],
                             didYouMean(nearest)));
  }
  const auto set = rowOf(*type).set;
  if (set == nullptr) return wrong(fmt::format("'{}' needs a job file ([[tool]])", parts[0]));
  tool.type = *type;
  std::vector<double> numbers;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const auto number = parseNumber(parts[i]);
    if (!number) return wrong(fmt::format("'{}' is not a number", parts[i]));
    numbers.push_back(*number);
  }
  if (!set(tool, numbers)) return wrong(fmt::format("wrong count of numbers for '{}'", parts[0]));
  if (Status status = validateTool(tool); !status) return status.error();
  return tool;
}

}  // namespace proveout
