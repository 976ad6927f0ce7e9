#include "removal/compare/features/general_tolerance.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace proveout {
namespace {

constexpr double kNone = -1.0;  ///< the standard gives no value
constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// A row of a table: up to this nominal size the limits of the classes.
template <std::size_t N>
struct Row {
  double up_to;
  std::array<double, N> limits;
};

/// ISO 2768-1 table 1: linear sizes from 0.5 mm; f, m, c, v.
constexpr Row<4> kSizes[] = {{3, {0.05, 0.1, 0.2, kNone}}, {6, {0.05, 0.1, 0.3, 0.5}},
                             {30, {0.1, 0.2, 0.5, 1}},     {120, {0.15, 0.3, 0.8, 1.5}},
                             {400, {0.2, 0.5, 1.2, 2.5}},  {1000, {0.3, 0.8, 2, 4}},
                             {2000, {0.5, 1.2, 3, 6}},     {4000, {kNone, 2, 4, 8}}};
/// Table 2: radii and chamfers from 0.5 mm.
constexpr Row<4> kRadii[] = {{3, {0.2, 0.2, 0.4, 0.4}}, {6, {0.5, 0.5, 1, 1}}, {kNoEnd, {1, 1, 2, 2}}};
/// Table 3: angles by the length of the shorter leg, degrees.
constexpr Row<4> kAngles[] = {{10, {1, 1, 1.5, 3}},
                              {50, {0.5, 0.5, 1, 2}},
                              {120, {20.0 / 60, 20.0 / 60, 0.5, 1}},
                              {400, {10.0 / 60, 10.0 / 60, 0.25, 0.5}},
                              {kNoEnd, {5.0 / 60, 5.0 / 60, 10.0 / 60, 20.0 / 60}}};
/// ISO 2768-2 table 1: straightness and flatness by length; H, K, L.
constexpr Row<3> kFlatness[] = {{10, {0.02, 0.05, 0.1}}, {30, {0.05, 0.1, 0.2}},  {100, {0.1, 0.2, 0.4}},
                                {300, {0.2, 0.4, 0.8}},  {1000, {0.3, 0.6, 1.2}}, {3000, {0.4, 0.8, 1.6}}};
/// Table 2: perpendicularity by the length of the shorter leg.
constexpr Row<3> kSquare[] = {
    {100, {0.2, 0.4, 0.6}}, {300, {0.3, 0.6, 1}}, {1000, {0.4, 0.8, 1.5}}, {3000, {0.5, 1, 2}}};

template <std::size_t N>
std::optional<double> find(std::span<const Row<N>> rows, double size, std::size_t column) {
  for (const Row<N>& row : rows) {
    if (size > row.up_to) continue;
    const double limit = row.limits[column];
    return limit == kNone ? std::nullopt : std::optional(limit);
  }
  return std::nullopt;
}

}  // namespace

std::string GeneralTolerance::text() const {
  std::string out = "ISO 2768-";
  if (size != '\0') out += size;
  if (form != '\0') out += form;
  return out;
}

std::optional<double> GeneralTolerance::limit(const Characteristic& c, double length_mm) const {
  constexpr double kLeast = 0.5;  // mm; smaller sizes have their tolerance beside them on the drawing
  constexpr std::string_view kSizeNames = "fmcv", kFormNames = "HKL";
  const std::size_t by_size = kSizeNames.find(size), by_form = kFormNames.find(form);
  const double value = std::abs(c.nominal);
  switch (c.quantity) {
    case Quantity::kFlatness:
      if (form == '\0') return std::nullopt;
      return find<3>(kFlatness, length_mm, by_form);
    case Quantity::kPerpendicularity:
      if (form == '\0') return std::nullopt;
      return find<3>(kSquare, length_mm, by_form);
    case Quantity::kAngle:
      if (size == '\0') return std::nullopt;
      return find<4>(kAngles, length_mm, by_size);
    case Quantity::kRadius:
      if (size == '\0' || value < kLeast) return std::nullopt;
      return find<4>(kRadii, value, by_size);
    case Quantity::kDiameter:
    case Quantity::kConeDiameter:
    case Quantity::kDepth:
    case Quantity::kHeight:
    case Quantity::kWidth:
    case Quantity::kLength:
      if (size == '\0' || value < kLeast) return std::nullopt;
      return find<4>(kSizes, value, by_size);
    case Quantity::kX:
    case Quantity::kY:
    case Quantity::kZ:  // a distance from the zero point, which may be as small as it likes
    case Quantity::kOffset:
      if (size == '\0') return std::nullopt;
      return find<4>(kSizes, value, by_size);
    default:
      return std::nullopt;
  }
}

Result<GeneralTolerance> parseGeneralTolerance(std::string_view text) {
  const Error wrong = inputError(
      "a general tolerance is a class of ISO 2768: \"f\", \"m\", \"c\" or \"v\" for sizes, and "
      "\"H\", \"K\" or \"L\" for form behind it, as in \"mK\"");
  for (const std::string_view prefix : {"ISO ", "2768", "-1", "-"})
    if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
  GeneralTolerance out;
  for (const char c : text) {
    const bool is_size = std::string_view("fmcv").find(c) != std::string_view::npos;
    const bool is_form = std::string_view("HKL").find(c) != std::string_view::npos;
    if (is_size && out.size == '\0' && out.form == '\0') {
      out.size = c;
    } else if (is_form && out.form == '\0') {
      out.form = c;
    } else {
      return wrong;
    }
  }
  if (out.none()) return wrong;
  return out;
}

}  // namespace proveout
