#include "core/nc/iso/context/output.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/characters.h"
#include "core/base/printable.h"
#include "core/nc/iso/context/context.h"
#include "core/nc/iso/context/sends.h"

namespace proveout::nc {
namespace {

constexpr int kPeriphery = 31;  ///< n of POPEN: the memory of the control
constexpr std::string_view kLineEnd = "\r\n";
constexpr std::size_t kMaxName = 60;
constexpr int kMaxDigits = 15;

char at(std::string_view text, std::size_t i) { return i < text.size() ? text[i] : '\0'; }

/// Columns of text[i] of the block's line.
Columns columnsAt(std::size_t i) { return {static_cast<int>(i) + 1, static_cast<int>(i) + 2}; }

ProgramOutput& target(IsoContext& c) { return c.host.output ? *c.host.output : c.output.unkept; }

/// What the host answered; its errors end the run.
bool accepted(IsoContext& c, const Status& status) {
  return status.ok() || c.fail("output", status.error().message);
}

/// A number from `i` on: digits, a variable or a bracket.
bool integerAt(IsoContext& c, std::size_t& i, int& out) {
  const std::string_view text = c.block.text;
  i = skipBlanks(text, i);
  const std::size_t begin = i;
  double number = -1.0;
  if (isDigit(at(text, i))) {
    for (number = 0.0; isDigit(at(text, i)) && i - begin < 9; ++i) number = number * 10.0 + (text[i] - '0');
  } else if (at(text, i) == '#' || at(text, i) == '[') {
    Value value;
    LexError error;
    if (!c.macro.evaluate(text, i, value, error)) return c.fail(error);
    number = value.vacant ? -1.0 : std::round(value.number);
  }
  if (!(number >= 0.0 && number <= 99999999.0)) {
    return c.alarm(SharedAlarm::kSyntax, {}, "a number is expected", columnsAt(begin));
  }
  out = static_cast<int>(number);
  return true;
}

bool nothingBehind(IsoContext& c, std::size_t i) {
  const std::string_view text = c.block.text;
  i = skipBlanks(text, i);
  return i >= text.size() || text[i] == '(' ||
         c.alarm(SharedAlarm::kSyntax, {}, "nothing may follow the statement",
                 {static_cast<int>(i) + 1, static_cast<int>(text.size()) + 1});
}

/// ".nc" of the program that runs.
std::string extension(const IsoContext& c) {
  const std::string& name = c.calls.top().text->name();
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || name.find('/', dot) != std::string::npos ? "" : name.substr(dot);
}

bool writeBytes(IsoContext& c, std::string_view bytes) {
  c.output.bytes += bytes.size();
  return accepted(c, target(c).write(bytes));
}

bool openFile(IsoContext& c, const std::string& name, bool append) {
  c.output.name = name;
  c.output.bytes = 0;
  return accepted(c, target(c).open(name, append));
}

bool closeFile(IsoContext& c) {
  OutputFile& file = c.output;
  file.open = false;
  if (file.name.empty()) return true;
  const bool good = accepted(c, target(c).close()) && sendEvent(c, event::Output{file.name, file.bytes});
  file.name.clear();
  return good;
}

bool mayOpen(IsoContext& c) {
  return !c.output.open || c.fail("output", "a file is open already: close it first");
}

bool openPeriphery(IsoContext& c, std::size_t i) {
  int n = 0;
  if (!integerAt(c, i, n) || !nothingBehind(c, i) || !mayOpen(c)) return false;
  if (n != kPeriphery)
    return c.alarm(SharedAlarm::kOutOfRange, "POPEN",
                   "31, the memory of the control, is the only place to write to");
  c.output.open = c.output.periphery = true;
  c.output.name.clear();
  return true;
}

bool closePeriphery(IsoContext& c, std::size_t i) {
  int n = 0;
  if (!integerAt(c, i, n) || !nothingBehind(c, i)) return false;
  if (n != kPeriphery)
    return c.alarm(SharedAlarm::kOutOfRange, "PCLOS",
                   "31, the memory of the control, is the only place to write to");
  if (!c.output.open || !c.output.periphery) return c.fail("output", "PCLOS without POPEN");
  if (c.output.name.empty()) {
    c.output.open = false;
    return c.fail("output", "no DPRNT has named the file that POPEN opened");
  }
  return writeBytes(c, std::string("%") + std::string(kLineEnd)) && closeFile(c);
}

/// `Pp` or `<name>` of FOPEN. `number` -1: by name.
bool fileArgument(IsoContext& c, std::size_t& i, std::string& name, int& number) {
  const std::string_view text = c.block.text;
  i = skipBlanks(text, i);
  number = -1;
  if (upper(at(text, i)) == 'P') {
    ++i;
    if (!integerAt(c, i, number)) return false;
    name = (number <= 9999 ? fmt::format("O{:04}", number) : fmt::format("O{:08}", number)) + extension(c);
    return true;
  }
  const std::size_t close = at(text, i) == '<' ? text.find('>', i) : std::string_view::npos;
  if (close == std::string_view::npos) {
    return c.alarm(SharedAlarm::kSyntax, {}, "FOPEN needs P or a file name in < >", columnsAt(i));
  }
  name = outputName(text.substr(i + 1, close - i - 1));
  if (name.empty()) {
    return c.fail(SharedAlarm::kOutOfRange,
                  "file name data out of range: 1 to 60 characters, inside the folder of the results",
                  {static_cast<int>(i) + 1, static_cast<int>(close) + 2});
  }
  i = close + 1;
  return true;
}

bool openNamed(IsoContext& c, std::size_t i) {
  int mode = 0, number = -1;
  std::string name;
  if (!integerAt(c, i, mode) || !fileArgument(c, i, name, number) || !nothingBehind(c, i) || !mayOpen(c)) {
    return false;
  }
  if (mode < 1 || mode > 5) return c.alarm(SharedAlarm::kOutOfRange, "FOPEN", "1 to 5 is expected");
  const bool exists = target(c).exists(name);
  if (mode == 1 && exists) {
    return c.fail(
        number >= 0 ? SharedAlarm::kProgramExists : SharedAlarm::kFileExists,
        number >= 0 ? fmt::format("file (O{:04}) already exists", number) : "the given file already exists");
  }
  if ((mode == 3 || mode == 5) && !exists) {
    return c.fail(number >= 0 ? SharedAlarm::kProgramNotFound : SharedAlarm::kFileNotFound,
                  number >= 0 ? fmt::format("file (O{:04}) not found: this run has not written it", number)
                              : "file not found: this run has not written it");
  }
  if (!openFile(c, name, mode == 3 || mode == 4)) return false;
  c.output.open = true;
  c.output.periphery = false;
  return true;
}

bool closeNamed(IsoContext& c, std::size_t i) {
  if (!nothingBehind(c, i)) return false;
  if (!c.output.open || c.output.periphery) return c.fail("output", "FCLOS without FOPEN");
  return closeFile(c);
}

/// The value of the variable at text[i], which is '#'.
bool variableAt(IsoContext& c, std::string_view text, std::size_t& i, Value& value) {
  LexError error;
  const std::size_t begin = i;
  int number = 0;
  if (!c.macro.variable(text, i, number, error)) {
    error.columns = {};
    return c.fail(error);
  }
  if (c.variables.read(number, value) == VariableStatus::kDone) return true;
  return c.fail("variable", fmt::format("{} cannot be read", text.substr(begin, i - begin)));
}

/// `[digits]` at text[i]; the digits, as text.
bool formatAt(IsoContext& c, std::string_view text, std::size_t& i, std::string_view& digits) {
  const std::size_t open = i;
  if (at(text, i) == '[') ++i;
  const std::size_t begin = i;
  while (isDigit(at(text, i))) ++i;
  digits = text.substr(begin, i - begin);
  const bool good = at(text, open) == '[' && !digits.empty() && digits.size() <= 3 && at(text, i) == ']';
  if (good) ++i;
  return good ||
         c.alarm(SharedAlarm::kSyntax, "", "a variable to be written is followed by its digits in brackets");
}

/// The text between the brackets of BPRNT and DPRNT, made into a record without its line end.
bool record(IsoContext& c, std::size_t i, bool binary, std::string& out) {
  const std::string_view text = c.block.text;
  i = skipBlanks(text, i);
  if (at(text, i) != '[') return c.alarm(SharedAlarm::kSyntax, {}, "'[' is expected", columnsAt(i));
  for (++i; at(text, i) != ']';) {
    const char letter = upper(at(text, i));
    if (letter == '#') {
      if (!binary) {
        if (!printedVariable(c, text, i, out)) return false;
        continue;
      }
      Value value;
      std::string_view digits;
      if (!variableAt(c, text, i, value) || !formatAt(c, text, i, digits)) return false;
      if (digits.size() > 1 || digits[0] > '8')
        return c.alarm(SharedAlarm::kOutOfRange, "BPRNT", "0 to 8 decimals");
      if (!binaryBytes(value.vacant ? 0.0 : value.number, digits[0] - '0', out))
        return c.alarm(SharedAlarm::kValueLimit, "BPRNT");
    } else if (isDigit(letter) || (letter >= 'A' && letter <= 'Z') || letter == '/' || letter == '+' ||
               letter == '-' || letter == '*') {
      out += letter == '*' ? ' ' : letter;
      ++i;
    } else if (letter == ' ' || letter == '\t') {
      ++i;
    } else if (!c.dialect.rules.names_output && letter > ' ' && letter < 0x7F && letter != '[') {
      out += letter;
      ++i;
    } else {
      return letter == '\0' ? c.alarm(SharedAlarm::kRightBracket, "]", {}, columnsAt(text.size()))
                            : c.alarm(SharedAlarm::kSyntax, {},
                                      "letters, digits, * / + - and variables can be written", columnsAt(i));
    }
  }
  return nothingBehind(c, i + 1);
}

bool print(IsoContext& c, std::size_t i, bool binary) {
  OutputFile& file = c.output;
  std::string bytes;
  if (!record(c, i, binary, bytes)) return false;
  if (!file.open) return c.fail("output", "no file is open: POPEN or FOPEN comes first");
  if (!file.name.empty()) return writeBytes(c, bytes + std::string(kLineEnd));
  if (binary) return c.fail("output", "the first DPRNT behind POPEN names the file");
  bytes.erase(std::remove(bytes.begin(), bytes.end(), ' '), bytes.end());
  const std::string name = outputName(bytes);
  if (name.empty())
    return c.fail(SharedAlarm::kOutOfRange, fmt::format("file name data out of range: \"{}\"", bytes));
  return openFile(c, name + extension(c), false) && writeBytes(c, std::string("%") + std::string(kLineEnd));
}

constexpr std::string_view kMacroFile = "macro.txt";

/// POPEN without a number: what is written goes behind what the file holds already.
bool openMacroFile(IsoContext& c) {
  if (c.output.open) return true;
  if (!openFile(c, std::string(kMacroFile), target(c).exists(std::string(kMacroFile)))) return false;
  c.output.open = true;
  c.output.periphery = false;
  return true;
}

/// POPEN, PCLOS, BPRNT and DPRNT where there is one file that they all mean.
bool macroOutput(IsoContext& c) {
  const std::string_view text = c.block.text;
  const std::size_t begin = c.block.statement;
  if (keywordAt(text, begin, "POPEN")) return nothingBehind(c, begin + 5) && openMacroFile(c);
  if (keywordAt(text, begin, "PCLOS")) {
    if (!nothingBehind(c, begin + 5)) return false;
    if (c.output.open) return closeFile(c);
    c.warnOnce("macro-output-closed", "output", "PCLOS without POPEN: nothing is open");
    return true;
  }
  const bool binary = keywordAt(text, begin, "BPRNT");
  if (!binary && !keywordAt(text, begin, "DPRNT"))
    return c.alarm(SharedAlarm::kNotImplemented, text.substr(begin, 5));
  std::string bytes;
  if (!record(c, begin + 5, binary, bytes)) return false;
  if (!c.output.open && c.firstTime("macro-output-open")) {
    c.warn("output", fmt::format("DPRNT without POPEN: written to {}", kMacroFile), {}, Severity::kNote);
  }
  return openMacroFile(c) && writeBytes(c, bytes + std::string(kLineEnd));
}

}  // namespace

bool outputStatement(IsoContext& c) {
  struct Statement {
    std::string_view word;
    bool (*run)(IsoContext&, std::size_t);
  };
  constexpr auto kStatements = std::to_array<Statement>({
      {"POPEN", openPeriphery},
      {"PCLOS", closePeriphery},
      {"FOPEN", openNamed},
      {"FCLOS", closeNamed},
      {"BPRNT", [](IsoContext& context, std::size_t i) { return print(context, i, true); }},
      {"DPRNT", [](IsoContext& context, std::size_t i) { return print(context, i, false); }},
  });
  if (!c.dialect.rules.names_output) return macroOutput(c);
  const std::size_t begin = c.block.statement;
  for (const Statement& statement : kStatements) {
    if (keywordAt(c.block.text, begin, statement.word))
      return statement.run(c, begin + statement.word.size());
  }
  return c.alarm(SharedAlarm::kSyntax, "", "unknown statement");
}

bool endOutput(IsoContext& c) {
  if (!c.output.open) return true;
  if (c.dialect.rules.names_output || c.output.name != kMacroFile)
    c.warn("output", "the program ends while it has a file open: what it wrote so far is kept");
  return closeFile(c);
}

bool printedVariable(IsoContext& c, std::string_view text, std::size_t& i, std::string& out) {
  Value value;
  std::string_view format;
  if (!variableAt(c, text, i, value) || !formatAt(c, text, i, format)) return false;
  const int decimals = format.size() > 1 ? format.back() - '0' : 0;
  int digits = 0;
  for (const char d : format.size() > 1 ? format.substr(0, format.size() - 1) : format)
    digits = digits * 10 + (d - '0');
  if (digits + decimals < 1 || digits + decimals > kMaxDigits) {
    return c.alarm(SharedAlarm::kOutOfRange, format, "1 to 15 digits can be written");
  }
  out += decimalText(value.vacant ? 0.0 : value.number, digits, decimals,
                     c.parameters.flag(DataParam::kPrintNoSpaces));
  return true;
}

std::string decimalText(double value, int digits, int decimals, bool compact) {
  const double scale = std::pow(10.0, decimals);
  double magnitude = std::abs(value);
  // Half away from zero; beyond 2^53 there is nothing to round.
  if (magnitude * scale < 9007199254740992.0) magnitude = std::round(magnitude * scale) / scale;
  const std::string number = fmt::format("{:.{}f}", magnitude, decimals);
  const bool minus = value < 0.0 && magnitude > 0.0;
  if (compact) return (minus ? "-" : "") + number;
  const std::size_t width = static_cast<std::size_t>(digits + (decimals > 0 ? decimals + 1 : 0));
  return (minus ? "-" : " ") + std::string(number.size() < width ? width - number.size() : 0, ' ') + number;
}

bool binaryBytes(double value, int decimals, std::string& out) {
  const double scaled = std::round(value * std::pow(10.0, decimals));
  if (!(scaled >= -2147483648.0 && scaled <= 2147483647.0)) return false;
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled));
  for (const unsigned shift : {24u, 16u, 8u, 0u}) out += static_cast<char>(bits >> shift & 0xFFu);
  return true;
}

std::string outputName(std::string_view written) {
  const auto blank = [](char c) { return c == ' '; };
  while (!written.empty() && blank(written.front())) written.remove_prefix(1);
  while (!written.empty() && blank(written.back())) written.remove_suffix(1);
  std::string name(written);
  std::replace(name.begin(), name.end(), '\\', '/');
  const std::size_t first = name.find_first_not_of('/');
  if (first == std::string::npos || name.size() > kMaxName) return {};
  name.erase(0, first);
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view part = std::string_view(name).substr(begin, end - begin);
    if (part.empty() || part == "." || part == "..") return {};
    begin = end + 1;
  }
  const auto bad = [](char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ||
           std::string_view(":*?\"<>|").find(c) != std::string_view::npos;
  };
  if (masked(name) != name) return {};  // characters that act on terminals, bytes that are no text
  return std::any_of(name.begin(), name.end(), bad) ? std::string() : name;
}

}  // namespace proveout::nc
