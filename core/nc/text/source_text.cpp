#include "core/nc/text/source_text.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>

#include "core/base/assert.h"
#include "core/base/memory_limit.h"
#include "core/base/printable.h"
#include "core/nc/control/control_info.h"
#include "core/nc/text/program_likeness.h"

namespace proveout::nc {
namespace {

/// Length of the UTF-8 sequence at `i`, or 0 if there is none (overlong forms and surrogates too).
int utf8Length(std::string_view s, std::size_t i) {
  const auto at = [&](std::size_t k) { return k < s.size() ? static_cast<unsigned char>(s[k]) : 0u; };
  const auto tail = [&](std::size_t k) { return (at(k) & 0xC0u) == 0x80u; };
  const unsigned c = at(i);
  if (c < 0x80) return 1;
  if (c >= 0xC2 && c <= 0xDF) return tail(i + 1) ? 2 : 0;
  if (c >= 0xE0 && c <= 0xEF) {
    if (!tail(i + 1) || !tail(i + 2)) return 0;
    if (c == 0xE0 && at(i + 1) < 0xA0) return 0;
    if (c == 0xED && at(i + 1) > 0x9F) return 0;
    return 3;
  }
  if (c >= 0xF0 && c <= 0xF4) {
    if (!tail(i + 1) || !tail(i + 2) || !tail(i + 3)) return 0;
    if (c == 0xF0 && at(i + 1) < 0x90) return 0;
    if (c == 0xF4 && at(i + 1) > 0x8F) return 0;
    return 4;
  }
  return 0;
}

/// Offset of the first byte that is not UTF-8, or npos.
std::size_t firstBadUtf8(std::string_view s) {
  for (std::size_t i = 0; i < s.size();) {
    const int n = utf8Length(s, i);
    if (n == 0) return i;
    i += n;
  }
  return std::string_view::npos;
}

int lineOf(std::string_view s, std::size_t offset) {
  return 1 + static_cast<int>(std::count(s.begin(), s.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

/// How Cyrillic the text reads in a code page: the ten commonest letters of Russian count for it, a capital
/// after a small letter (the mark of the wrong page, whose cases are swapped) counts against it.
int cyrillicScore(std::string_view bytes, const std::array<unsigned char, 10>& small, int case_distance,
                  bool (*is_capital)(unsigned char)) {
  int score = 0;
  bool after_small = false;
  for (const char ch : bytes) {
    const auto c = static_cast<unsigned char>(ch);
    if (c < 0x80) {
      after_small = false;
      continue;
    }
    for (const unsigned char s : small) {
      if (c == s || c == static_cast<unsigned char>(s + case_distance)) score += 1;
    }
    if (after_small && is_capital(c)) score -= 3;
    after_small = !is_capital(c);
  }
  return score;
}

const char* guessCyrillic(std::string_view bytes) {
  // o e a i n t s r v l
  static constexpr std::array<unsigned char, 10> kKoi8{0xCF, 0xC5, 0xC1, 0xC9, 0xCE,
                                                       0xD4, 0xD3, 0xD2, 0xD7, 0xCC};
  static constexpr std::array<unsigned char, 10> k1251{0xEE, 0xE5, 0xE0, 0xE8, 0xED,
                                                       0xF2, 0xF1, 0xF0, 0xE2, 0xEB};
  const int koi8 = cyrillicScore(bytes, kKoi8, 0x20, [](unsigned char c) { return c >= 0xE0; });
  const int cp1251 =
      cyrillicScore(bytes, k1251, -0x20, [](unsigned char c) { return c >= 0xC0 && c <= 0xDF; });
  return koi8 > cp1251 ? "koi8-r" : "cp1251";
}

struct IconvHandle {
  iconv_t handle;
  explicit IconvHandle(const char* from) : handle(iconv_open("UTF-8", from)) {}
  ~IconvHandle() {
    if (ok()) iconv_close(handle);
  }
  IconvHandle(const IconvHandle&) = delete;
  IconvHandle& operator=(const IconvHandle&) = delete;
  bool ok() const { return handle != reinterpret_cast<iconv_t>(-1); }
};

Result<std::string> convert(const std::string& bytes, const char* system_name, const char* shown_name) {
  IconvHandle conv(system_name);
  if (!conv.ok()) return inputError(fmt::format("this system cannot convert {} text", shown_name));
  std::string out;
  out.resize(bytes.size() * 4 + 16);  // no encoding here gives more than four bytes a character
  char* in = const_cast<char*>(bytes.data());
  std::size_t in_left = bytes.size();
  char* to = out.data();
  std::size_t to_left = out.size();
  if (iconv(conv.handle, &in, &in_left, &to, &to_left) == static_cast<std::size_t>(-1)) {
    const std::size_t offset = bytes.size() - in_left;
    return inputError(fmt::format("line {}: byte {} of the file (0x{:02X}) is not {} text",
                                  lineOf(bytes, offset), offset + 1,
                                  static_cast<unsigned char>(bytes[offset]), shown_name));
  }
  out.resize(out.size() - to_left);
  return out;
}

struct EncodingName {
  TextEncoding encoding;
  const char* system_name;
  const char* shown_name;
};
constexpr std::array<EncodingName, 3> kCodePages{{{TextEncoding::kKoi8R, "KOI8-R", "koi8-r"},
                                                  {TextEncoding::kCp1251, "CP1251", "cp1251"},
                                                  {TextEncoding::kGb18030, "GB18030", "gb18030"}}};

/// What is too long for a block, or for the memory: a text is held several times, and its lines and blocks
/// take their places in tables.
Status checkSize(std::string_view bytes) {
  constexpr std::size_t kMostLine = std::size_t{4} << 20;
  std::size_t lines = 1, begin = 0, starts = 0;
  for (std::size_t i = 0; i <= bytes.size(); ++i) {
    const char c = i < bytes.size() ? bytes[i] : '\n';
    if (c == '%' || c == ';') ++starts;
    if (c != '\n' && c != '\r') continue;
    if (i - begin > kMostLine)
      return inputError(fmt::format("line {} has {} bytes: a line of a program has at most {}", lines,
                                    i - begin, kMostLine));
    ++lines;
    begin = i + 1;
  }
  constexpr double kOfLine = 80.0, kOfStart = 200.0, kCopies = 3.0;
  return memoryFor(kCopies * static_cast<double>(bytes.size()) + kOfLine * static_cast<double>(lines) +
                       kOfStart * static_cast<double>(starts),
                   "the program");
}

}  // namespace

Result<std::string> decodeText(const std::string& bytes, TextEncoding encoding, std::string* chosen) {
  if (Status fits = checkSize(bytes); !fits) return fits.error();
  const std::size_t nul = bytes.find('\0');
  if (nul != std::string::npos) {
    return inputError(fmt::format(
        "line {}: byte {} of the file is NUL: this is a binary or UTF-16 file, not a program text",
        lineOf(bytes, nul), nul + 1));
  }
  if (encoding == TextEncoding::kAuto || encoding == TextEncoding::kUtf8) {
    const std::size_t bad = firstBadUtf8(bytes);
    if (bad == std::string::npos) {
      if (chosen) *chosen = "utf-8";
      return bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
    }
    if (encoding == TextEncoding::kUtf8) {
      return inputError(fmt::format("line {}: byte {} of the file (0x{:02X}) is not utf-8 text",
                                    lineOf(bytes, bad), bad + 1, static_cast<unsigned char>(bytes[bad])));
    }
    const char* guess = guessCyrillic(bytes);
    if (chosen) *chosen = guess;
    return convert(bytes, guess == std::string_view("koi8-r") ? "KOI8-R" : "CP1251", guess);
  }
  for (const EncodingName& page : kCodePages) {
    if (page.encoding != encoding) continue;
    if (chosen) *chosen = page.shown_name;
    return convert(bytes, page.system_name, page.shown_name);
  }
  return inputError("unknown text encoding");
}

SourceText::SourceText(std::string name, std::string path, std::string utf8)
    : name_(std::move(name)), path_(std::move(path)), text_(std::move(utf8)) {
  splitLines();
}

SourceText::SourceText(const SourceText& whole, std::size_t first, std::size_t end)
    : name_(whole.name_), path_(whole.path_), encoding_(whole.encoding_), lines_(first), first_line_(first) {
  comments_end_in_line_ = whole.comments_end_in_line_;
  PROVEOUT_ASSERT(first < end && end <= whole.lines_.size());
  for (std::size_t k = first; k < end; ++k) {
    text_ += whole.lines_[k];
    text_ += '\n';
  }
  splitLines();
}

void SourceText::splitLines() {
  const std::string_view all = text_;
  lines_.reserve(lines_.size() + static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')) + 1);
  std::size_t start = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const char c = all[i];
    if (c != '\n' && c != '\r') continue;
    lines_.push_back(all.substr(start, i - start));
    if (c == '\r' && i + 1 < all.size() && all[i + 1] == '\n') ++i;
    start = i + 1;
  }
  if (start < all.size()) lines_.push_back(all.substr(start));
}

SourceText::Label SourceText::label(long long number, std::size_t from) {
  if (!labels_known_) indexLabels();
  const auto first = std::lower_bound(labels_.begin(), labels_.end(), NumberedLine{number, 0});
  if (first == labels_.end() || first->number != number) return {};
  const bool repeated = first + 1 != labels_.end() && (first + 1)->number == number;
  const auto next = std::lower_bound(first, labels_.end(), NumberedLine{number, from});
  const auto& found = next != labels_.end() && next->number == number ? *next : *first;
  return {static_cast<int>(found.line), repeated};
}

const LoopIndex& SourceText::loops() {
  if (loops_ == nullptr) loops_ = std::make_unique<const LoopIndex>(lines_, comments_end_in_line_);
  return *loops_;
}

namespace {

constexpr long long kNoNumber = -1;

/// The number behind the N at line[i], or kNoNumber.
long long numberAt(std::string_view line, std::size_t i) {
  while (i + 1 < line.size() && line[i + 1] == ' ') ++i;
  long long value = 0;
  int digits = 0;
  while (i + 1 < line.size() && line[i + 1] >= '0' && line[i + 1] <= '9' && digits < 17) {
    value = value * 10 + (line[++i] - '0');
    ++digits;
  }
  return digits == 0 ? kNoNumber : value;
}

/// Block number at the head of the line, or kNoNumber. `comment` tells whether the line starts inside a
/// comment and, afterwards, whether it ends inside one.
long long labelOf(std::string_view line, bool& comment) {
  bool head = !comment;  // nothing but blanks and skip marks seen yet
  long long number = kNoNumber;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (comment) {
      comment = c != ')';
    } else if (c == '(') {
      comment = true;
    } else if (head && c != ' ' && c != '\t') {
      if (c == '/') {
        while (i + 1 < line.size() && line[i + 1] >= '0' && line[i + 1] <= '9') ++i;
        continue;
      }
      head = false;
      if (c == 'N' || c == 'n') number = numberAt(line, i);
    }
  }
  return number;
}

/// Does the word stand in the line (outside of comments that end in it)?
bool hasWord(std::string_view line, char letter, int value) {
  bool comment = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    comment = comment ? c != ')' : c == '(';
    if (comment || (c != letter && c != letter + ('a' - 'A'))) continue;
    if (numberAt(line, i) == value) return true;
  }
  return false;
}

bool opensData(std::string_view line) {
  if (!hasWord(line, 'G', 10)) return false;
  for (const int l : {52, 75, 76, 77}) {
    if (hasWord(line, 'L', l)) return true;
  }
  return false;
}

}  // namespace

void SourceText::indexLabels() {
  labels_known_ = true;
  bool comment = false, data = false;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const std::string_view line = lines_[k];
    if (data && hasWord(line, 'G', 11)) data = false;
    if (comments_end_in_line_) comment = false;
    const long long number = labelOf(line, comment);
    if (number != kNoNumber && !data) labels_.push_back({number, k});
    if (!data && opensData(line)) data = true;
  }
  std::sort(labels_.begin(), labels_.end());
}

namespace {

/// A line as diagnostics carry it. Of one that nobody can read its place is enough: there may be many
/// diagnostics, and each holds its line.
std::string shownLine(std::string_view line) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 20;
  return line.size() <= kMostBytes ? std::string(line) : std::string();
}

}  // namespace

Diagnostic diagnosticAt(const SourceText* text, const SourceRef& at, Columns columns, Severity severity,
                        std::string code, std::string message) {
  Diagnostic d;
  d.severity = severity;
  d.code = std::move(code);
  d.message = boundedMessage(std::move(message));
  if (text == nullptr || at.line == 0) return d;
  if (severity == Severity::kError && !mayBeProgram(*text)) {
    const std::string language = foreignLanguage(text->lines());
    d.code = language.empty() ? "no-program" : "foreign-program";
    d.message = language.empty() ? "this is no NC program: its lines are no blocks"
                                 : fmt::format("this is {}; none of the controls here does: {}", language,
                                               fmt::join(builtControlNames(), ", "));
    d.where.file = text->name();
    return d;
  }
  d.where = {text->name(), static_cast<int>(at.line), columns.begin, columns.end};
  if (at.line <= text->lines().size()) d.source_line = shownLine(text->lines()[at.line - 1]);
  if (columns.begin != 0 || d.source_line.empty()) return d;
  d.where.column = static_cast<int>(d.source_line.find_first_not_of(" \t")) + 1;
  d.where.column_end = static_cast<int>(d.source_line.find_last_not_of(" \t")) + 2;
  return d;
}

std::string calledFrom(const SourceText& text, std::size_t line) {
  return fmt::format("called from {}:{}", text.name(), line);
}

namespace {

bool endsTape(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] == '%';
}

/// What is open behind a line, with `open` in front of it.
void readComments(std::string_view line, std::size_t index, std::optional<OpenComment>& open) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (open && line[i] == ')') {
      open.reset();
    } else if (!open && line[i] == '(') {
      const int column = static_cast<int>(i) + 1;
      open = OpenComment{index, {column, column + 1}};
    }
  }
}

}  // namespace

std::optional<OpenComment> commentOpenAtEnd(const std::vector<std::string_view>& lines, std::size_t from) {
  std::optional<OpenComment> open;
  for (std::size_t k = from; k < lines.size(); ++k) {
    if (!open && k > from && endsTape(lines[k])) break;
    readComments(lines[k], k, open);
  }
  return open;
}

std::optional<OpenComment> commentOpenInLine(const std::vector<std::string_view>& lines, std::size_t from) {
  for (std::size_t k = from; k < lines.size(); ++k) {
    std::optional<OpenComment> open;
    readComments(lines[k], k, open);
    if (open) return open;
  }
  return std::nullopt;
}

}  // namespace proveout::nc
