// Layout of a milled pocket: levels, rings and corner radii. Knows of no control; any unit of length.
#pragma once

#include <cstdint>
#include <optional>

namespace proveout {

/// What the call gives. Sizes and depth of cut count by their amount.
struct PocketRequest {
  std::optional<double> first, second;  ///< sizes along the first and second axis of the plane
  std::optional<double> depth;          ///< size along the tool
  std::optional<double> corner;         ///< corner radius; none: that of the tool
  std::optional<double> tool_radius;    ///< none: no offset register is named
  std::optional<double> cut;            ///< depth of cut
  double width_percent = 83.0;          ///< cutting width in percent of the tool's diameter; < 0: clockwise
};

enum class PocketError {
  kNone,
  kMissing,   ///< MACRO ERROR 1: depth, tool or depth of cut is missing
  kWrongSize  ///< MACRO ERROR 2: a size does not fit the tool or the corner, or a step is 0
};

/// Rings around a core: ring k of 1..rings is a rectangle of half sides core + k ring_step along the length
/// and k ring_step across. Levels and rings are equal steps, never larger than asked for.
struct PocketLayout {
  PocketError error = PocketError::kNone;
  const char* reason = "";      ///< of the error
  bool length_is_first = true;  ///< the length lies along the first axis of the plane
  bool clockwise = false;
  std::int64_t levels = 0;
  double level_step = 0.0;
  std::int64_t rings = 0;
  double ring_step = 0.0;
  double core = 0.0;          ///< half length of the first cut, in which the tool is loaded on both sides
  double outer_corner = 0.0;  ///< corner radius of the last ring's path
};

/// Most levels and rings that a layout may have; more is a wrong size.
inline constexpr std::int64_t kMaxPocketSteps = 100'000;

PocketLayout layOutPocket(const PocketRequest& request);

}  // namespace proveout
