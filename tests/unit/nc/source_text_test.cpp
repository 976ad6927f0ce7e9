#include "core/nc/text/source_text.h"

#include <gtest/gtest.h>

#include "core/base/memory_limit.h"
#include "core/nc/text/program_likeness.h"

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

bool mayBe(const std::string& text) { return mayBeProgram(SourceText("x", "x", text)); }

TEST(MayBeProgram, TakesBlocksOfEveryControl) {
  for (const char* text :
       {"", "%\n", "(only a comment)\n", "O0011\n", "G0 X1.5 Y-2\n", "N10 G1 X=#3 Y[#1+2]\n", "#100 = 5\n",
        "IF [#1 EQ 2] GOTO 10\n", "WHILE[#1LT3]DO1\n", "text that is none\nG1 X5\n", "/2 N5 M3\n",
        "%1\nN1 G0 X10 Z#2\nM02\n", "N0001G92X0.Y0.;G01X5000;M02;\n", "G77 X10 Z-5 // comment\n", "SP1=500\n",
        "M98 <a/b.nc>\n", ":1234\nG21\n", "\x11%\r\nG1 X1\r\n\x13", "g1 x1 y1\n"})
    EXPECT_TRUE(mayBe(text)) << text;
}

TEST(MayBeProgram, KnowsWhatIsNone) {
  for (const char* text :
       {"root:x:0:0:root:/root:/bin/bash\ndaemon:x:1:1:daemon:/usr/sbin:/usr/sbin/nologin\n",
        "# A heading\n\nSome text, with 3 numbers and (brackets).\n", "{\n  \"a\": 1\n}\n",
        "schema = \"proveout.job/1\"\ncontrol = \"nct\"\n", "solid x\nfacet normal 0 0 1\nouter loop\n",
        "a,b,c\n1.0,2.0,3.0\n", "-----BEGIN KEY-----\nMIIEpAIBAAKCAQEA7bq98Zk\n-----END KEY-----\n",
        "int main() { return 0; }\n", "PASSWORD=hunter2\n",
        "\x7F"
        "ELF\x02\x01\x01\x03\nG1\n"})
    EXPECT_FALSE(mayBe(text)) << text;
}

TEST(DecodeText, RefusesLinesThatNoProgramHas) {
  const auto long_line = decodeText("G0 X1\n" + std::string(5'000'000, 'X'), TextEncoding::kAuto);
  ASSERT_FALSE(long_line.ok());
  EXPECT_NE(long_line.error().message.find("line 2 has 5000000 bytes"), std::string::npos)
      << long_line.error().message;
}

TEST(DecodeText, StaysWithinTheMemoryLimit) {
  const std::string text(10'000'000, '\n');
  EXPECT_TRUE(decodeText("G0 X1\n", TextEncoding::kAuto).ok());
  const MemoryLimit limit(400e6);
  const auto refused = decodeText(text, TextEncoding::kAuto);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, ErrorKind::kResourceLimit);
  EXPECT_NE(refused.error().message.find("400 MB are allowed; allow more (--max-memory)"), std::string::npos)
      << refused.error().message;
  EXPECT_TRUE(decodeText("G0 X1\n", TextEncoding::kAuto).ok());
  EXPECT_TRUE(memoryRefusal());
}

}  // namespace
}  // namespace proveout::nc
