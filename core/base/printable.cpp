#include "core/base/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace proveout {

std::size_t utf8Length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0) == 0x80; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return tail(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool overlong = first == 0xE0 && byte(1) < 0xA0, surrogate = first == 0xED && byte(1) > 0x9F;
    return tail(1) && tail(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool overlong = first == 0xF0 && byte(1) < 0x90, too_high = first == 0xF4 && byte(1) > 0x8F;
    return tail(1) && tail(2) && tail(3) && !overlong && !too_high ? 4 : 0;
  }
  return 0;
}

namespace {

/// Of a well-formed sequence.
unsigned codePoint(std::string_view sequence) {
  const auto first = static_cast<unsigned char>(sequence[0]);
  if (sequence.size() == 1) return first;
  unsigned code = first & (0x7Fu >> sequence.size());
  for (const char c : sequence.substr(1)) code = code << 6 | (static_cast<unsigned char>(c) & 0x3Fu);
  return code;
}

bool isControl(unsigned code) {
  if (code < 0x20 || (code >= 0x7F && code <= 0x9F)) return true;
  return code == 0x061C || code == 0x200E || code == 0x200F || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

/// Calls `shown(piece)` for what may be shown and `acting(sequence, code)` for each character that may not;
/// `code` of a byte that is not UTF-8 is above all characters.
constexpr unsigned kNoCharacter = 0x110000;
template <typename Shown, typename Acting>
void split(std::string_view text, const Shown& shown, const Acting& acting) {
  std::size_t from = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8Length(text.substr(at));
    const std::string_view sequence = text.substr(at, std::max<std::size_t>(length, 1));
    const unsigned code = length == 0 ? kNoCharacter : codePoint(sequence);
    at += sequence.size();
    if (code < kNoCharacter && !isControl(code)) continue;
    shown(text.substr(from, at - sequence.size() - from));
    acting(sequence, code);
    from = at;
  }
  shown(text.substr(from));
}

void putEscaped(std::string& out, std::string_view sequence, unsigned code) {
  switch (code) {
    case '\n':
      out += "\\n";
      return;
    case '\r':
      out += "\\r";
      return;
    case '\t':
      out += "\\t";
      return;
    default:
      break;
  }
  if (code >= 0x80 && code < kNoCharacter) {
    fmt::format_to(std::back_inserter(out), "\\u{:04x}", code);
  } else {
    fmt::format_to(std::back_inserter(out), "\\x{:02x}", static_cast<unsigned char>(sequence[0]));
  }
}

std::string escaped(std::string_view text, char kept) {
  std::string out;
  out.reserve(text.size());
  split(
      text, [&](std::string_view piece) { out += piece; },
      [&](std::string_view sequence, unsigned code) {
        if (kept != '\0' && sequence[0] == kept) {
          out += kept;
        } else {
          putEscaped(out, sequence, code);
        }
      });
  return out;
}

}  // namespace

bool isControlCharacter(std::string_view sequence) { return isControl(codePoint(sequence)); }

std::string printable(std::string_view text) { return escaped(text, '\0'); }

std::string printableLines(std::string_view text) { return escaped(text, '\n'); }

std::string masked(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  split(
      text, [&](std::string_view piece) { out += piece; },
      [&](std::string_view sequence, unsigned) {
        if (sequence == "\t") {
          out += '\t';
        } else {
          out.append(sequence.size(), '?');
        }
      });
  return out;
}

namespace {

constexpr std::string_view kLeftOut = "...";

bool isTail(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// So much of the beginning, or of the end, as whole characters.
std::string_view head(std::string_view text, std::size_t most) {
  while (most > 0 && most < text.size() && isTail(text[most])) --most;
  return text.substr(0, most);
}
std::string_view tail(std::string_view text, std::size_t most) {
  std::size_t from = text.size() - most;
  while (from < text.size() && isTail(text[from])) ++from;
  return text.substr(from);
}

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  return std::string(head(text, most - kLeftOut.size())).append(kLeftOut);
}

std::string boundedMessage(std::string message) {
  constexpr std::size_t kHead = 600, kTail = 400;
  if (message.size() <= kHead + kTail) return message;
  return std::string(head(message, kHead)).append(kLeftOut).append(tail(message, kTail));
}

std::string csvField(std::string_view text) {
  std::string shown = printable(text);
  if (shown.find_first_of(",\"") == std::string::npos) return shown;
  std::string out = "\"";
  for (const char c : shown) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string jsonQuoted(std::string_view text) {
  std::string out = "\"";
  out.reserve(text.size() + 2);
  split(
      text,
      [&](std::string_view piece) {
        for (const char c : piece) {
          if (c == '"' || c == '\\') out += '\\';
          out += c;
        }
      },
      [&](std::string_view, unsigned code) {
        fmt::format_to(std::back_inserter(out), "\\u{:04x}", code == kNoCharacter ? 0xFFFD : code);
      });
  return out + '"';
}

std::string jsonPrintable(std::string_view document) {
  std::string out;
  out.reserve(document.size());
  split(
      document, [&](std::string_view piece) { out += piece; },
      [&](std::string_view sequence, unsigned code) {
        if (code < 0x20) {
          out += sequence;  // the layout: JSON has no controls of this kind in strings
        } else {
          fmt::format_to(std::back_inserter(out), "\\u{:04x}", code == kNoCharacter ? 0xFFFD : code);
        }
      });
  return out;
}

}  // namespace proveout
