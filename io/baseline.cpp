#include "io/baseline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>

#include "core/base/printable.h"

namespace proveout {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema = "proveout.baseline/1";
constexpr std::size_t kMostFindings = 1'000'000;

/// To 0.0001; no -0.
double rounded(double x) { return std::isfinite(x) ? std::round(x * 1e4) / 1e4 + 0.0 : 0.0; }

std::string_view fileName(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

/// Without its number, which changes when blocks are put in before it, and with single blanks.
std::string blockText(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\t' || c == '\r';
    if (!blank)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  std::size_t digits = 1;
  while (digits < out.size() && out[digits] >= '0' && out[digits] <= '9') ++digits;
  if (!out.empty() && (out[0] == 'N' || out[0] == 'n') && digits > 1)
    out.erase(0, digits < out.size() && out[digits] == ' ' ? digits + 1 : digits);
  return printable(out);
}

Json entryJson(const KnownFinding& f) {
  Json out = {{"kind", findingKindName(f.kind)}, {"severity", severityName(f.severity)}};
  if (!f.setup.empty()) out["setup"] = f.setup;
  if (!f.file.empty()) {
    out["file"] = f.file;
    out["line"] = f.line;
    out["block"] = f.block;
    if (!f.last_block.empty()) out["last_block"] = f.last_block;
  }
  if (f.where) out["where"] = {f.where->x(), f.where->y(), f.where->z()};
  if (f.depth_mm) out["depth_mm"] = *f.depth_mm;
  if (f.area_mm2) out["area_mm2"] = *f.area_mm2;
  if (f.volume_mm3) out["volume_mm3"] = *f.volume_mm3;
  if (f.spots > 1) out["spots"] = f.spots;
  out["message"] = f.message;
  return out;
}

/// Reads the entries of a baseline; what is wrong with the first bad one is kept.
class EntryReader {
 public:
  std::optional<KnownFinding> read(const Json& json) {
    if (!json.is_object()) return fail("it is no object");
    KnownFinding f;
    const auto kind = findingKindNamed(text(json, "kind"));
    if (!kind) return fail("there is no kind of finding '" + shortened(text(json, "kind")) + "'");
    if (isBinding(*kind)) return fail("findings of kind '" + text(json, "kind") + "' are never known");
    f.kind = *kind;
    const auto severity = severityNamed(text(json, "severity"));
    if (!severity) return fail("its severity is none of note, warning, error");
    f.severity = *severity;
    f.setup = text(json, "setup");
    f.file = text(json, "file");
    f.block = text(json, "block");
    f.last_block = text(json, "last_block");
    f.message = text(json, "message");
    f.line = static_cast<std::uint32_t>(count(json, "line", 0));
    f.spots = count(json, "spots", 1);
    f.where = point(json);
    f.depth_mm = number(json, "depth_mm");
    f.area_mm2 = number(json, "area_mm2");
    f.volume_mm3 = number(json, "volume_mm3");
    return why.empty() ? std::optional(std::move(f)) : std::nullopt;
  }

  std::string why;

 private:
  std::nullopt_t fail(std::string text) {
    if (why.empty()) why = std::move(text);
    return std::nullopt;
  }

  static std::optional<Severity> severityNamed(const std::string& name) {
    for (const Severity one : {Severity::kNote, Severity::kWarning, Severity::kError}) {
      if (severityName(one) == name) return one;
    }
    return std::nullopt;
  }

  std::string text(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end()) return {};
    if (found->is_string()) return found->get<std::string>();
    fail(fmt::format("{} is no text", key));
    return {};
  }

  std::optional<double> number(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end()) return std::nullopt;
    if (found->is_number() && std::isfinite(found->get<double>())) return found->get<double>();
    return fail(fmt::format("{} is no number", key));
  }

  std::size_t count(const Json& json, const char* key, std::size_t otherwise) {
    const std::optional<double> value = number(json, key);
    if (!value) return otherwise;
    if (*value >= 0.0 && *value <= 4e9 && *value == std::floor(*value))
      return static_cast<std::size_t>(*value);
    fail(fmt::format("{} is no count", key));
    return otherwise;
  }

  std::optional<Vec3> point(const Json& json) {
    const auto found = json.find("where");
    if (found == json.end()) return std::nullopt;
    if (!found->is_array() || found->size() != 3) return fail("where is no list of three numbers");
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const Json& item = (*found)[static_cast<std::size_t>(k)];
      if (!item.is_number() || !std::isfinite(item.get<double>()))
        return fail("where is no list of three numbers");
      p[k] = item.get<double>();
    }
    return p;
  }
};

std::vector<KnownFinding> keptOf(const std::vector<Finding>& findings) {
  std::vector<KnownFinding> kept;
  for (const Finding& finding : findings) {
    if (!isBinding(finding.kind)) kept.push_back(knownFinding(finding));
  }
  const auto place = [](const KnownFinding& f) {
    const Vec3 p = f.where.value_or(Vec3::Zero());
    return std::tuple(p.x(), p.y(), p.z());
  };
  std::sort(kept.begin(), kept.end(), [&](const KnownFinding& a, const KnownFinding& b) {
    return std::tuple(std::tie(a.setup, a.file, a.line, a.kind), place(a), std::tie(a.depth_mm, a.message)) <
           std::tuple(std::tie(b.setup, b.file, b.line, b.kind), place(b), std::tie(b.depth_mm, b.message));
  });
  return kept;
}

}  // namespace

KnownFinding knownFinding(const Finding& finding) {
  KnownFinding f;
  f.kind = finding.kind;
  f.severity = finding.severity;
  f.setup = printable(finding.setup);
  if (finding.source) {
    f.file = printable(fileName(finding.source->file));
    f.line = finding.source->line;
    f.block = blockText(finding.source->text);
    if (finding.last_source) f.last_block = blockText(finding.last_source->text);
  }
  const auto round = [](const std::optional<double>& x) {
    return x ? std::optional(rounded(*x)) : std::nullopt;
  };
  if (finding.where)
    f.where = Vec3(rounded(finding.where->x()), rounded(finding.where->y()), rounded(finding.where->z()));
  f.depth_mm = round(finding.depth_mm);
  f.area_mm2 = round(finding.area_mm2);
  f.volume_mm3 = round(finding.volume_mm3);
  f.spots = finding.spots;
  f.message = printable(finding.message);
  return f;
}

std::string baselineText(const std::vector<Finding>& findings) {
  std::string text = fmt::format("{{\n  \"schema\": \"{}\",\n  \"findings\": [", kSchema);
  const char* separator = "\n";
  for (const KnownFinding& finding : keptOf(findings)) {
    text += separator;
    text += "    " + jsonPrintable(entryJson(finding).dump(-1, ' ', false, Json::error_handler_t::replace));
    separator = ",\n";
  }
  return text + "\n  ]\n}\n";
}

std::size_t baselineCount(const std::vector<Finding>& findings) {
  return static_cast<std::size_t>(std::count_if(
      findings.begin(), findings.end(), [](const Finding& finding) { return !isBinding(finding.kind); }));
}

Result<std::vector<KnownFinding>> parseBaseline(const std::string& text, const std::string& name) {
  const auto wrong = [&](const std::string& what) {
    return inputError(fmt::format(
        "{}: no baseline that this version reads: {}; write it anew with --write-baseline", name, what));
  };
  const Json root = Json::parse(text, nullptr, false);
  if (root.is_discarded() || !root.is_object()) return wrong("it is no JSON document, or is cut short");
  const auto schema = root.find("schema");
  const std::string called = schema != root.end() && schema->is_string() ? schema->get<std::string>() : "";
  if (called.starts_with("proveout.report/")) return wrong("it is a report");
  if (called != kSchema)
    return wrong(called.empty()
                     ? fmt::format("it has no schema, \"{}\"", kSchema)
                     : fmt::format("its schema is \"{}\", not \"{}\"", shortened(called), kSchema));
  const auto list = root.find("findings");
  if (list == root.end() || !list->is_array()) return wrong("it has no list of findings");
  if (list->size() > kMostFindings) return wrong(fmt::format("it has more than {} findings", kMostFindings));
  std::vector<KnownFinding> findings;
  for (const Json& json : *list) {
    EntryReader reader;
    auto finding = reader.read(json);
    if (!finding) return wrong(fmt::format("finding {}: {}", findings.size() + 1, reader.why));
    findings.push_back(std::move(*finding));
  }
  return findings;
}

}  // namespace proveout
