#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "render/canvas.h"
#include "render/font.h"
#include "render_fixtures.h"

namespace proveout {
namespace {

using render_detail::Canvas;
using render_detail::glyphOf;

Image whiteImage(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3, 255)};
}

TEST(Font, EveryPrintableCharacterHasItsOwnShape) {
  std::set<render_detail::Glyph> shapes;
  for (char c = ' '; c <= '~'; ++c) EXPECT_TRUE(shapes.insert(glyphOf(c)).second) << c;
  EXPECT_EQ(glyphOf('\t'), glyphOf('\x80'));
  EXPECT_TRUE(shapes.insert(glyphOf('\t')).second);
}

TEST(Font, TailsHangBelowTheBaseLine) {
  const auto hangs = [](char c) {
    const render_detail::Glyph& glyph = glyphOf(c);
    return std::any_of(glyph.begin() + render_detail::kGlyphHeight, glyph.end(),
                       [](std::uint8_t row) { return row != 0; });
  };
  for (const char c : std::string_view("gjpqy,;_")) EXPECT_TRUE(hangs(c)) << c;
  for (char c = ' '; c <= '~'; ++c) {
    const bool tailed = std::string_view("gjpqy,;_").find(c) != std::string_view::npos;
    EXPECT_TRUE(tailed || !hangs(c)) << c;
  }
}

TEST(Canvas, TextInksTheDotsOfTheGlyph) {
  Image image = whiteImage(30, 40);
  Canvas(image).text({0, 0}, "L", 4.0, {0, 0, 0});
  EXPECT_LT(test::pixel(image, 2, 2)[0], 40);    // top of the stem
  EXPECT_LT(test::pixel(image, 18, 26)[0], 40);  // right end of the foot
  EXPECT_EQ(test::pixel(image, 18, 2)[0], 255);  // empty upper right
}

TEST(Canvas, ClipsAtEveryEdge) {
  Image image = whiteImage(16, 16);
  Canvas canvas(image);
  canvas.line({-100, -100}, {100, 100}, 3, {0, 0, 0});
  canvas.disc({16, 0}, 1e6, {0, 0, 1}, 0.5);
  canvas.box({-5, 12, 500, 500}, {1, 0, 0});
  canvas.text({-50, -6}, "clipped on both sides of the picture", 2, {0, 1, 0});
  EXPECT_EQ(test::pixel(image, 3, 15), (std::array<int, 3>{255, 0, 0}));
}

TEST(Canvas, DiscHasItsArea) {
  Image image = whiteImage(64, 64);
  Canvas(image).disc({31.7, 30.2}, 20, {0, 0, 0});
  double ink = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) ink += (255 - image.rgb[i]) / 255.0;
  EXPECT_NEAR(ink, kPi * 400, 2.0);
}

}  // namespace
}  // namespace proveout
