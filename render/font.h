// A small 5x7 font, printable ASCII, with two more rows below its base line.
#pragma once

#include <array>
#include <cstdint>

namespace proveout::render_detail {

inline constexpr int kGlyphWidth = 5, kGlyphAdvance = 6;
/// Rows above the base line, and with the tails of g, j, p, q and y.
inline constexpr int kGlyphHeight = 7, kGlyphRows = 9;

/// Rows from the top; bit 4 is the leftmost column. Anything but printable ASCII gives a box.
using Glyph = std::array<std::uint8_t, kGlyphRows>;
const Glyph& glyphOf(char c);

}  // namespace proveout::render_detail
