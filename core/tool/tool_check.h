// Ranges of a tool's dimensions: the first that is wrong is told.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/tool/tool.h"

namespace proveout {

/// Thinnest tool, mm: a tenth of the thinnest end mill that is made.
inline constexpr double kMinToolDiameterMm = 1e-3;
/// Largest tool dimension that makes sense, mm; also keeps squares far from overflow.
inline constexpr double kMaxToolDimensionMm = 1e5;

class ToolCheck {
 public:
  explicit ToolCheck(const Tool& tool) : tool_(tool) {}
  void require(bool good, std::string_view what);
  void length(double value, std::string_view field);
  void angle(double value, std::string_view field, double limit = 180.0);
  /// A length that the type cannot do without.
  void positive(double value, std::string_view field);
  /// The cutting part reaches `height`, which its shape takes, with the flutes or the tool as long as they
  /// are.
  void flutesCover(double height, std::string_view what);

  bool good() const { return message_.empty(); }
  Status status() const;

 private:
  const Tool& tool_;
  std::string message_;
};

}  // namespace proveout
