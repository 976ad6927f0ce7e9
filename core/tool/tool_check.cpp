#include "core/tool/tool_check.h"

#include <fmt/format.h>

#include <cmath>

namespace proveout {

void ToolCheck::require(bool good, std::string_view what) {
  if (!good && message_.empty()) message_ = fmt::format("tool {}: {}", tool_.number, what);
}

void ToolCheck::length(double value, std::string_view field) {
  require(std::isfinite(value) && value >= 0.0 && value <= kMaxToolDimensionMm,
          fmt::format("{} must be between 0 and {} mm, not {}", field, kMaxToolDimensionMm, value));
}

void ToolCheck::angle(double value, std::string_view field, double limit) {
  require(std::isfinite(value) && value > 0.0 && value < limit,
          fmt::format("{} must be above 0 and below {} degrees, not {}", field, limit, value));
}

void ToolCheck::positive(double value, std::string_view field) {
  length(value, field);
  require(value >= kMinToolDiameterMm,
          fmt::format("{} must be at least {} mm, not {}", field, kMinToolDiameterMm, value));
}

void ToolCheck::flutesCover(double height, std::string_view what) {
  std::string why = fmt::format("flute_length is needed: {} is longer than {} mm", what, kUnlimitedFluteMm);
  if (tool_.overall_length > 0.0) why = fmt::format("overall_length is shorter than {}", what);
  if (tool_.flute_length > 0.0) why = fmt::format("flute_length is shorter than {}", what);
  require(cutterTop(tool_) >= height, why);
}

Status ToolCheck::status() const {
  if (!good()) return inputError(message_);
  return Done{};
}

}  // namespace proveout
