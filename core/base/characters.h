// Characters of program texts, whatever the locale of the process.
#pragma once

namespace proveout {

constexpr bool isBlank(char c) { return c == ' ' || c == '\t'; }
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }
constexpr bool isLetter(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

}  // namespace proveout
