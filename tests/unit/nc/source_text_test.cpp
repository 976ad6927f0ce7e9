#include "core/nc/source_text.h"

#include <gtest/gtest.h>

namespace proveout::nc {
namespace {

using namespace std::string_literals;

TEST(DecodeText, KeepsUtf8AndDropsTheMark) {
  std::string name;
  const auto text =
      decodeText("\xEF\xBB\xBFG0 (\xD1\x84\xD1\x80\xD0\xB5\xD0\xB7\xD0\xB0)\n", TextEncoding::kAuto, &name);
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(*text, "G0 (\xD1\x84\xD1\x80\xD0\xB5\xD0\xB7\xD0\xB0)\n");
  EXPECT_EQ(name, "utf-8");
}

// "(черновая обработка)" in the two code pages.
const std::string kWanted = "(черновая обработка)";
const std::string kKoi8 = "(\xDE\xC5\xD2\xCE\xCF\xD7\xC1\xD1 \xCF\xC2\xD2\xC1\xC2\xCF\xD4\xCB\xC1)";
const std::string kCp1251 = "(\xF7\xE5\xF0\xED\xEE\xE2\xE0\xFF \xEE\xE1\xF0\xE0\xE1\xEE\xF2\xEA\xE0)";

TEST(DecodeText, ConvertsCodePages) {
  const auto koi8 = decodeText(kKoi8, TextEncoding::kKoi8R);
  ASSERT_TRUE(koi8.ok()) << koi8.error().message;
  EXPECT_EQ(*koi8, kWanted);
  const auto cp1251 = decodeText(kCp1251, TextEncoding::kCp1251);
  ASSERT_TRUE(cp1251.ok()) << cp1251.error().message;
  EXPECT_EQ(*cp1251, kWanted);
  const auto gb = decodeText("(\xB4\xD6\xBC\xD3\xB9\xA4)", TextEncoding::kGb18030);
  ASSERT_TRUE(gb.ok()) << gb.error().message;
  EXPECT_EQ(*gb, "(粗加工)");
}

TEST(DecodeText, GuessesTheCyrillicPage) {
  std::string name;
  EXPECT_EQ(*decodeText(kKoi8, TextEncoding::kAuto, &name), kWanted);
  EXPECT_EQ(name, "koi8-r");
  EXPECT_EQ(*decodeText(kCp1251, TextEncoding::kAuto, &name), kWanted);
  EXPECT_EQ(name, "cp1251");
}

TEST(DecodeText, RefusesBinaryAndWrongText) {
  const auto binary = decodeText("G0 X1\nG1\0X2"s, TextEncoding::kAuto);
  ASSERT_FALSE(binary.ok());
  EXPECT_NE(binary.error().message.find("line 2"), std::string::npos) << binary.error().message;
  EXPECT_FALSE(decodeText(kKoi8, TextEncoding::kUtf8).ok());
  EXPECT_FALSE(decodeText("(\xB4", TextEncoding::kGb18030).ok());
  EXPECT_FALSE(decodeText("(\xC0\xAF)", TextEncoding::kUtf8).ok());          // overlong
  EXPECT_FALSE(decodeText("(\xED\xA0\x80)", TextEncoding::kUtf8).ok());      // surrogate
  EXPECT_FALSE(decodeText("(\xF4\x90\x80\x80)", TextEncoding::kUtf8).ok());  // above U+10FFFF
}

TEST(SourceText, CutsLinesAtAllLineEnds) {
  const SourceText text("a", "a", "one\r\ntwo\nthree\rfour");
  ASSERT_EQ(text.lines().size(), 4u);
  EXPECT_EQ(text.lines()[1], "two");
  EXPECT_EQ(text.lines()[3], "four");
  EXPECT_TRUE(SourceText("a", "a", "").lines().empty());
}

TEST(SourceText, FindsBlockNumbers) {
  SourceText text("a", "a", "N10 X1\n/2 N20 X2\n(N30\nN40) N50\n G1 N60\nn10\n(x) N70 Y1\n");
  EXPECT_EQ(text.label(10).line_index, 0);
  EXPECT_TRUE(text.label(10).repeated);
  EXPECT_EQ(text.label(20).line_index, 1);
  EXPECT_EQ(text.label(30).line_index, SourceText::kNoLabel);
  EXPECT_EQ(text.label(40).line_index, SourceText::kNoLabel);
  EXPECT_EQ(text.label(60).line_index, SourceText::kNoLabel) << "only numbers at the head are labels";
  EXPECT_EQ(text.label(70).line_index, 6);
}

}  // namespace
}  // namespace proveout::nc
