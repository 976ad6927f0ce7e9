// Active comments: MSG, PRINT, DEBUG and the log files.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <string>

#include "core/base/characters.h"
#include "core/nc/iso/context/sends.h"
#include "core/nc/linuxcnc/program/lcn_language.h"

namespace proveout::nc {
namespace {

/// Comments that do something; those with a comma take a text.
constexpr auto kLcnActive = std::to_array<std::string_view>(
    {"msg,", "print,", "debug,", "log,", "logopen,", "logappend,", "logclose", "probeopen", "probeclose"});

bool lcnStartsWith(std::string_view text, std::string_view word) {
  if (text.size() < word.size()) return false;
  for (std::size_t k = 0; k < word.size(); ++k)
    if (upper(text[k]) != upper(word[k])) return false;
  return true;
}

/// A value as the interpreter prints it: small ones as 0, and none that takes more than 31 characters.
std::string lcnShown(double value) {
  constexpr double kSmall = 1e-4;
  constexpr std::size_t kMostCharacters = 31;
  std::string text = fmt::format("{:.6f}", std::abs(value) < kSmall ? 0.0 : value);
  return text.size() > kMostCharacters ? "######" : text;
}

}  // namespace

bool LinuxCncLanguage::activeComment(std::string_view& kind, std::string_view& rest) const {
  std::string_view text = line_.comment;
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  for (const std::string_view word : kLcnActive) {
    if (!lcnStartsWith(text, word)) continue;
    kind = word.ends_with(',') ? word.substr(0, word.size() - 1) : word;
    rest = text.substr(word.size());
    return true;
  }
  return false;
}

/// The text with the values of parameters in it: six decimals, or ###### where there is none.
std::string LinuxCncLanguage::withValues(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '#') {
      out += text[i++];
      continue;
    }
    std::size_t end = i + 1;
    const bool has_name = end < text.size() && (text[end] == '<' || text[end] == '[');
    if (has_name) {
      const std::size_t close = text.find(text[end] == '<' ? '>' : ']', end);
      end = close == std::string_view::npos ? text.size() : close + 1;
    } else {
      while (end < text.size() && isDigit(text[end])) ++end;
    }
    if (end == i + 1) {  // no parameter
      out += text[i++];
      continue;
    }
    std::string asked;
    for (const char c : text.substr(i, end - i))
      if (!isBlank(c)) asked += c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    LcnEvaluator evaluator(asked, *this);
    Value value;
    std::size_t pos = 0;
    out += evaluator.value(pos, value) ? lcnShown(value.number) : "######";
    i = end;
  }
  return out;
}

/// Carries out the last comment of the line. False: reported.
bool LinuxCncLanguage::comment() {
  std::string_view kind, rest;
  if (!line_.has_comment || !activeComment(kind, rest)) return true;
  if (kind == "msg") return sendEvent(c_, event::Message{"message", 0, "MSG", std::string(rest), {}});
  if (kind == "debug") return sendEvent(c_, event::Message{"message", 0, "DEBUG", withValues(rest), {}});
  if (kind == "print") return sendEvent(c_, event::Message{"message", 0, "PRINT", withValues(rest), {}});
  if (kind == "log") return sendEvent(c_, event::Message{"log", 0, "LOG", withValues(rest), {}});
  std::string code;
  for (const char c : kind) code += upper(c);
  c_.warnOnce("comment " + code, "noted",
              fmt::format("({}) is noted: the simulation writes no such file", code), line_.comment_columns);
  return sendEvent(c_, event::Function{code, {}});
}

}  // namespace proveout::nc
