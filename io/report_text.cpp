#include "io/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/printable.h"

namespace proveout::report_text {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Characters outside the Char production of XML 1.0, and those that act on a terminal that shows the file.
bool forbidden(std::string_view sequence) {
  const char c = sequence[0];
  if (c == '\t' || c == '\n' || c == '\r') return false;
  if (isControlCharacter(sequence)) return true;
  return sequence == "\xEF\xBF\xBE" || sequence == "\xEF\xBF\xBF";
}

std::string_view entity(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return {};
  }
}

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const std::string_view sequence = text.substr(0, std::max<std::size_t>(1, length));
    if (length == 0 || forbidden(sequence)) {
      out += kReplacement;
    } else if (const std::string_view name = entity(sequence[0]); !name.empty()) {
      out += name;
    } else {
      out += sequence;
    }
    text.remove_prefix(sequence.size());
  }
  return out;
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  if (zero && text.front() == '-') text.erase(0, 1);
  return text;
}

std::string figure(double value) {
  if (!std::isfinite(value)) return fixed(value, 4);
  const double size = std::abs(value);
  const int decimals =
      size >= 1e-4 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(size))), 0, 4) : 4;
  std::string text = fixed(value, decimals);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::optional<double> facetsMm(const Report& report) {
  for (const ErrorTerm& term : report.error_budget) {
    if (term.source == "facets") return term.bound_mm;
  }
  return std::nullopt;
}

std::string grouped(double value, int decimals) {
  std::string text = fixed(value, decimals);
  const std::size_t first = text.front() == '-' ? 1 : 0;
  std::size_t at = std::min(text.find('.'), text.size());
  while (at > first + 3) {
    at -= 3;
    text.insert(at, "\u202F");  // narrow space that does not break
  }
  return text;
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0.0) return "-";
  if (seconds < 60.0) return fixed(seconds, 1) + " s";
  const auto whole = static_cast<long long>(std::min(seconds + 0.5, 1e15));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min {:02} s", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string spoken(FindingKind kind) {
  std::string out(findingKindName(kind));
  std::replace(out.begin(), out.end(), '_', ' ');
  return out;
}

std::string place(const BlockRef& block) {
  std::string out = fmt::format("{}:{}", block.file, block.line);
  if (block.block >= 0) out += fmt::format(" (N{})", block.block);
  return out;
}

std::string place(const std::string& setup, const BlockRef& block) {
  return setup.empty() ? place(block) : fmt::format("{}: {}", setup, place(block));
}

std::string place(const Finding& finding) {
  if (!finding.source) return {};
  const std::string first = place(finding.setup, *finding.source);
  return finding.last_source ? first + " to " + place(*finding.last_source) : first;
}

/// Of causes that say what is wrong; others name a word or a datum that may be.
bool isStatement(const Cause& cause) { return cause.what == kUncut || cause.what == kNoOffset; }

std::string causeLine(const Cause& cause) {
  std::string out = cause.what;
  if (cause.source) {
    if (!cause.value.empty()) out += (isStatement(cause) ? "; " : " ") + cause.value;
    out += " (" + place(*cause.source) + ")";
  } else if (!cause.value.empty()) {
    out += " = " + cause.value;
  }
  for (const BlockRef& from : cause.from) out += fmt::format(", from {}", place(from));
  if (cause.off_mm) {
    out += fmt::format(": {} off by {}{} mm, explains {:.0f} %", cause.along, *cause.off_mm < 0 ? "-" : "+",
                       figure(std::abs(*cause.off_mm)), 100.0 * cause.explains);
  }
  if (cause.incremental) out += " (a step: words before it count as well)";
  if (cause.left_mm)
    out += *cause.left_mm == 0.0
               ? fmt::format("; with {} nothing of it is left", cause.with)
               : fmt::format("; with {} {} mm of it are left", cause.with, figure(*cause.left_mm));
  return out;
}

std::string causeNote(const Cause& cause) {
  if (isStatement(cause)) return causeLine(cause);
  return (cause.left_mm == 0.0 ? "cause: " : "could be ") + causeLine(cause);
}

std::string untriedNote(const Finding& finding) {
  return fmt::format("{} more {} not tried: trials took about as much as the run itself",
                     finding.untried_causes,
                     finding.untried_causes == 1 ? "word or datum was" : "words and data were");
}

std::string blocksLine(const Finding& finding, std::size_t most) {
  std::string out;
  for (std::size_t i = 0; i < std::min(most, finding.blocks.size()); ++i) {
    const BlockShare& b = finding.blocks[i];
    out += fmt::format("{}{} {:.0f} %", out.empty() ? "" : ", ", place(b.setup, b.block), 100.0 * b.share);
  }
  if (finding.blocks.size() > most) out += fmt::format(" and {} more", finding.blocks.size() - most);
  return out;
}

std::string summaryLine(const Finding& finding) {
  std::string out = place(finding);
  if (!out.empty()) out += ": ";
  out += fmt::format("{}{}: {}: {}", finding.known ? "known " : "", severityName(finding.severity),
                     spoken(finding.kind), finding.message);
  if (!finding.worse.empty()) out += " (worse than known: " + finding.worse + ")";
  std::string figures;
  const auto add = [&](const char* name, const std::optional<double>& value, const char* unit) {
    if (value) figures += fmt::format("{}{} {:.4g} {}", figures.empty() ? "" : ", ", name, *value, unit);
  };
  add("depth", finding.depth_mm, "mm");
  add("area", finding.area_mm2, "mm2");
  add("volume", finding.volume_mm3, "mm3");
  if (finding.where) {
    figures += fmt::format("{}at x {} y {} z {}", figures.empty() ? "" : ", ", fixed(finding.where->x(), 3),
                           fixed(finding.where->y(), 3), fixed(finding.where->z(), 3));
  }
  return figures.empty() ? out : out + " [" + figures + "]";
}

namespace {

std::string namesText(const std::vector<FindingKind>& kinds) {
  std::string out;
  for (const FindingKind kind : kinds) out += (out.empty() ? "" : ", ") + std::string(findingKindName(kind));
  return out;
}

std::string leftOutText(const std::vector<LeftOut>& all) {
  std::string out;
  for (const LeftOut& one : all) {
    out += fmt::format("{}{} {} {}", out.empty() ? "" : ", ", one.count, findingKindName(one.kind),
                       one.by == "the job" ? "turned off by the job" : "by " + one.by);
  }
  return out;
}

std::string baselineText(const BaselineUse& use) {
  return fmt::format("{} known of {}, {}", use.known, use.file,
                     use.looked_for_all ? fmt::format("{} gone", use.gone.size())
                                        : "which of the others are gone is not known");
}

}  // namespace

std::vector<std::string> acceptanceLines(const ReportAcceptance& acceptance) {
  std::vector<std::string> lines;
  std::string changed;
  for (const auto& [kind, severity] : acceptance.severities) {
    changed += fmt::format("{}{} = {}", changed.empty() ? "" : ", ", findingKindName(kind),
                           severity ? severityName(*severity) : "off");
  }
  const KindFilter& filter = acceptance.filter;
  if (!changed.empty()) lines.push_back("severities by the job: " + changed);
  if (!filter.select.empty()) lines.push_back("only " + namesText(filter.select) + " (--select)");
  if (!filter.ignore.empty()) lines.push_back("without " + namesText(filter.ignore) + " (--ignore)");
  if (!acceptance.left_out.empty()) lines.push_back("not listed: " + leftOutText(acceptance.left_out));
  if (acceptance.baseline) lines.push_back(baselineText(*acceptance.baseline));
  return lines;
}

std::string goneLine(const KnownFinding& known) {
  std::string out = known.setup.empty() ? "" : known.setup + ": ";
  if (!known.file.empty()) out += fmt::format("{}:{}: ", known.file, known.line);
  return out + fmt::format("{}: {}", spoken(known.kind), known.message);
}

std::string diagnosticLine(const Diagnostic& diagnostic) {
  std::string out;
  if (!diagnostic.where.file.empty()) out += diagnostic.where.file + ":";
  if (diagnostic.where.line > 0) out += fmt::format("{}:", diagnostic.where.line);
  if (!out.empty()) out += " ";
  out += severityName(diagnostic.severity);
  if (!diagnostic.code.empty()) out += "[" + diagnostic.code + "]";
  return out + ": " + diagnostic.message;
}

}  // namespace proveout::report_text
