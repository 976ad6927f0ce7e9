// Text from outside (file names, program texts, command lines) on its way to a terminal or into a table:
// nothing in it may act on what shows it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace proveout {

/// Length of the UTF-8 sequence at the start of `text`, or 0 if it is not well formed (RFC 3629, section 4)
/// or `text` is empty.
std::size_t utf8Length(std::string_view text);

/// Whether the well-formed sequence is a character that acts instead of being shown: C0 and C1 controls, DEL,
/// separators of lines and paragraphs, and those that change the direction of writing (UAX #9).
bool isControlCharacter(std::string_view sequence);

/// The text on one line: control characters are written as "\n", "\t", "\x1b" or "\u202e", bytes that are not
/// UTF-8 as "\xff". A backslash stays as it is.
std::string printable(std::string_view text);

/// The same for a text of several lines, whose ends stay.
std::string printableLines(std::string_view text);

/// The same with a question mark for each byte, so that columns stay; tabs stay tabs.
std::string masked(std::string_view text);

/// Text of a file as a message repeats it: at most `most` bytes, the rest left out as "...".
std::string shortened(std::string_view text, std::size_t most = 80);

/// A message of at most about 1,000 bytes: what is longer repeats something long, which is left out in the
/// middle, so that what is said in front of it and behind it stays.
std::string boundedMessage(std::string message);

/// The field of a table with commas between them (RFC 4180): printable, in quotes where it needs them.
std::string csvField(std::string_view text);

/// A JSON string with its quotes. Control characters of every kind are written as "\u009b", bytes that are
/// not UTF-8 as U+FFFD.
std::string jsonQuoted(std::string_view text);

/// A JSON document in which the controls that JSON does not forbid in strings are written as "\u009b" too.
std::string jsonPrintable(std::string_view document);

}  // namespace proveout
