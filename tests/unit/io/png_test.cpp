#include "io/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "temp_folder.h"

namespace proveout {
namespace {

Image pattern(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < width * height * 3; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 31 + i / 7));
  return image;
}

TEST(Png, ComesBackPixelByPixel) {
  const Image image = pattern(37, 21);
  const auto bytes = encodePng(image);
  ASSERT_TRUE(bytes.ok());
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&png, bytes->data(), bytes->size()), 0);
  ASSERT_EQ(png.width, 37u);
  ASSERT_EQ(png.height, 21u);
  png.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> back(PNG_IMAGE_SIZE(png));
  ASSERT_NE(png_image_finish_read(&png, nullptr, back.data(), 0, nullptr), 0);
  EXPECT_EQ(back, image.rgb);
}

TEST(Png, SameBytesForTheSamePicture) {
  const auto bytes = encodePng(pattern(64, 48));
  EXPECT_EQ(*bytes, *encodePng(pattern(64, 48)));
  EXPECT_EQ(bytes->find("tIME"), std::string::npos);
}

TEST(Png, RefusesImagesThatDoNotFit) {
  EXPECT_FALSE(encodePng(Image{}).ok());
  EXPECT_FALSE(encodePng(Image{-1, 4, {}}).ok());
  Image image = pattern(4, 4);
  image.rgb.pop_back();
  EXPECT_FALSE(encodePng(image).ok());
}

TEST(Png, WritesWholeFilesOrNone) {
  const io_test::TempFolder folder;
  ASSERT_TRUE(writePng(pattern(8, 8), folder.path("a.png")).ok());
  EXPECT_EQ(io_test::readBytes(folder.path("a.png")), *encodePng(pattern(8, 8)));
  EXPECT_FALSE(writePng(pattern(8, 8), "/dev/full").ok());
  EXPECT_FALSE(writePng(Image{}, folder.path("b.png")).ok());
  EXPECT_THAT(folder.names(), ::testing::ElementsAre("a.png"));
}

}  // namespace
}  // namespace proveout
