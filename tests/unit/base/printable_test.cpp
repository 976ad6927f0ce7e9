#include "core/base/printable.h"

#include <gtest/gtest.h>

#include "core/base/startable_threads.h"

namespace proveout {
namespace {

TEST(Printable, LeavesTextAlone) {
  for (const char* text :
       {"", "bracket.nc", "C:\\parts\\x.nc", "деталь «1».nc", "部品.nc", "a, \"b\"", "\xF0\x9F\x94\xA7"}) {
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(masked(text), text);
  }
}

TEST(Printable, WritesOutWhatActs) {
  EXPECT_EQ(printable("a\x1b[2Jb"), "a\\x1b[2Jb");
  EXPECT_EQ(printable("a\r\n\tb"), "a\\r\\n\\tb");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\x7F"), "\\x7f");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "\\u009b2J");  // CSI as one character
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "cn.x"),
            "\\u202ecn.x");  // right to left from here
  EXPECT_EQ(printable("\xE2\x80\xA8\xE2\x81\xA6\xD8\x9C"), "\\u2028\\u2066\\u061c");
}

TEST(Printable, WritesOutWhatIsNoText) {
  EXPECT_EQ(printable("\x9B"), "\\x9b");                    // CSI of one byte
  EXPECT_EQ(printable("\xC3"), "\\xc3");                    // cut short
  EXPECT_EQ(printable("\xC0\x9B"), "\\xc0\\x9b");           // overlong
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(printable("\xF4\x90\x80\x80x"), "\\xf4\\x90\\x80\\x80x");
}

/// Every character: nothing that acts is left, and nothing else is touched.
TEST(Printable, HoldsForEveryCharacter) {
  for (unsigned code = 0; code < 0x3000; ++code) {
    std::string text;
    if (code < 0x80) {
      text = static_cast<char>(code);
    } else if (code < 0x800) {
      text = {static_cast<char>(0xC0 | code >> 6), static_cast<char>(0x80 | (code & 0x3F))};
    } else {
      text = {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
              static_cast<char>(0x80 | (code & 0x3F))};
    }
    ASSERT_EQ(utf8Length(text), text.size()) << code;
    const bool acts = isControlCharacter(text);
    EXPECT_EQ(printable(text) == text, !acts) << code;
    EXPECT_EQ(masked(text).size(), text.size()) << code;
    EXPECT_EQ(acts, code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x61C || code == 0x200E ||
                        code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
                        (code >= 0x2066 && code <= 0x2069))
        << code;
  }
}

TEST(Printable, KeepsColumnsAndTabsWhereTheyCount) {
  EXPECT_EQ(masked("a\tb\x1b"
                   "c\xC2\x9B"
                   "d\xFF"),
            "a\tb?c??d?");
  EXPECT_EQ(printableLines("one\ntwo\x1b\r\n"), "one\ntwo\\x1b\\r\n");
}

TEST(Printable, FieldsOfTables) {
  EXPECT_EQ(csvField("part.nc"), "part.nc");
  EXPECT_EQ(csvField("a,b"), "\"a,b\"");
  EXPECT_EQ(csvField("a\"b"), "\"a\"\"b\"");
  EXPECT_EQ(csvField("a\nb\x1b"), "a\\nb\\x1b");
}

TEST(Printable, Json) {
  EXPECT_EQ(jsonQuoted("a\"\\b"), "\"a\\\"\\\\b\"");
  EXPECT_EQ(jsonQuoted("\x1b\n\x7F\xC2\x9B\xE2\x80\xAE\xFF"),
            "\"\\u001b\\u000a\\u007f\\u009b\\u202e\\ufffd\"");
  EXPECT_EQ(jsonPrintable("{\n\t\"a\": \"\x7F\xC2\x9Bж\"\n}"), "{\n\t\"a\": \"\\u007f\\u009bж\"\n}");
}

TEST(StartableThreads, AreCounted) {
  EXPECT_EQ(startableThreads(0), 0);
  EXPECT_EQ(startableThreads(-1), 0);
  EXPECT_EQ(startableThreads(3), 3);
}

TEST(Shortened, KeepsWholeCharacters) {
  EXPECT_EQ(shortened("short"), "short");
  EXPECT_EQ(shortened(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(shortened(std::string(81, 'x')), std::string(77, 'x') + "...");
  std::string cyrillic;
  for (int k = 0; k < 60; ++k) cyrillic += "\xD0\xB6";
  EXPECT_EQ(shortened(cyrillic), cyrillic.substr(0, 76) + "...");
}

TEST(BoundedMessage, KeepsWhatStandsAroundALongWord) {
  EXPECT_EQ(boundedMessage("no key 'x'; did you mean 'y'?"), "no key 'x'; did you mean 'y'?");
  const std::string shown = boundedMessage("no key '" + std::string(3'000'000, 'x') + "'; did you mean 'y'?");
  EXPECT_LT(shown.size(), 1'010u);
  EXPECT_TRUE(shown.starts_with("no key 'xxx"));
  EXPECT_TRUE(shown.ends_with("xxx'; did you mean 'y'?"));
}

}  // namespace
}  // namespace proveout
