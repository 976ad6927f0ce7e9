// A small 5x7 font, printable ASCII.
#pragma once

#include <array>
#include <cstdint>

namespace proveout::render_detail {

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 7, kGlyphAdvance = 6;

/// Seven rows from the top; bit 4 is the leftmost column. Anything but printable ASCII gives a box.
using Glyph = std::array<std::uint8_t, kGlyphHeight>;
const Glyph& glyphOf(char c);

}  // namespace proveout::render_detail
