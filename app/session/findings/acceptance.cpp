#include "app/session/findings/acceptance.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>

#include "core/base/nearest_name.h"
#include "core/base/printable.h"
#include "io/atomic_file.h"
#include "io/baseline.h"
#include "io/sha256.h"

namespace proveout {
namespace {

constexpr std::size_t kMaxBaselineBytes = std::size_t{64} << 20;

bool holds(const std::vector<FindingKind>& kinds, FindingKind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

Result<std::vector<FindingKind>> parseKinds(const std::vector<std::string>& lists, const char* option) {
  std::vector<FindingKind> kinds;
  for (const std::string& list : lists) {
    for (std::size_t at = 0; at <= list.size();) {
      const std::size_t end = std::min(list.find(',', at), list.size());
      const std::string name = list.substr(at, end - at);
      const auto kind = findingKindNamed(name);
      if (!kind) {
        return inputError(
            fmt::format("{}: there is no kind of finding '{}'{}; docs/reference/report.md lists them", option,
                        shortened(name), didYouMean(nearestName(name, findingKindNames()))));
      }
      if (holds(kinds, *kind)) return inputError(fmt::format("{}: {} is given twice", option, name));
      kinds.push_back(*kind);
      at = end + 1;
    }
  }
  return kinds;
}

/// Takes away the findings of which `out` is true, and counts them by kind.
void leaveOut(const std::function<bool(FindingKind)>& out, const std::string& by,
              std::vector<Finding>& findings, std::vector<LeftOut>& left_out) {
  std::vector<std::size_t> counts(findingKinds().size());
  std::erase_if(findings, [&](const Finding& finding) {
    if (!out(finding.kind)) return false;
    ++counts[static_cast<std::size_t>(finding.kind)];
    return true;
  });
  for (const FindingKindInfo& info : findingKinds()) {
    const std::size_t count = counts[static_cast<std::size_t>(info.kind)];
    if (count > 0) left_out.push_back({info.kind, count, by});
  }
}

/// Whether the kind is listed in runs of this job and filter.
bool isListed(FindingKind kind, const SeverityChoice& severities, const KindFilter& filter) {
  const auto chosen = severities.find(kind);
  if (chosen != severities.end() && !chosen->second) return false;
  if (!filter.select.empty() && !holds(filter.select, kind)) return false;
  return !holds(filter.ignore, kind);
}

/// Only a part of the programs was run: what was not found may be behind it.
bool isPart(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.kind == FindingKind::kPartial || finding.kind == FindingKind::kAlarm;
  });
}

BaselineUse useBaseline(const Job& job, const AcceptanceWish& wish, bool compared,
                        std::vector<Finding>& findings) {
  const NominalSpec tolerance = job.nominal.value_or(NominalSpec{});
  const KnownSlack slack{tolerance.gouge_mm, tolerance.excess_mm, job.simulation.contact_mm};
  BaselineUse use;
  use.file = wish.baseline->path;
  use.sha256 = wish.baseline->sha256;
  use.gone = markKnown(wish.baseline->findings, slack, findings);
  use.known = static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [](const Finding& finding) { return finding.known; }));
  use.looked_for_all = !isPart(findings);
  std::erase_if(use.gone, [&](const KnownFinding& known) {
    return !use.looked_for_all || !isListed(known.kind, job.severities, wish.filter) ||
           (isDeviation(known.kind) && !compared);
  });
  return use;
}

}  // namespace

Result<KindFilter> parseKindFilter(const std::vector<std::string>& select,
                                   const std::vector<std::string>& ignore) {
  const Result<std::vector<FindingKind>> wanted = parseKinds(select, "--select"),
                                         others = parseKinds(ignore, "--ignore");
  if (!wanted) return wanted.error();
  if (!others) return others.error();
  for (const FindingKind kind : *others) {
    if (isBinding(kind))
      return inputError(
          fmt::format("--ignore {} would hide that a result is missing or not whole", findingKindName(kind)));
    if (holds(*wanted, kind))
      return inputError(fmt::format("{} stands in --select and in --ignore", findingKindName(kind)));
  }
  return KindFilter{*wanted, *others};
}

Result<AcceptanceWish::File> loadBaseline(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error))
    return inputError(fmt::format("--baseline: {0}: no such file; --write-baseline {0} writes one", path));
  const Result<std::string> text = readWholeFile(path, kMaxBaselineBytes);
  if (!text) return Error{text.error().kind, "--baseline: " + text.error().message};
  Result<std::vector<KnownFinding>> findings = parseBaseline(*text, path);
  if (!findings) return Error{findings.error().kind, "--baseline: " + findings.error().message};
  return AcceptanceWish::File{path, sha256Hex(*text), std::move(*findings)};
}

ReportAcceptance accept(const Job& job, const AcceptanceWish& wish, bool compared,
                        std::vector<Finding>& findings) {
  ReportAcceptance done;
  done.severities = job.severities;
  done.filter = wish.filter;
  for (Finding& finding : findings) {
    const auto chosen = job.severities.find(finding.kind);
    if (chosen != job.severities.end() && chosen->second) finding.severity = *chosen->second;
  }
  const auto turnedOff = [&](FindingKind kind) { return !isListed(kind, job.severities, {}); };
  leaveOut(turnedOff, "the job", findings, done.left_out);
  const KindFilter& filter = wish.filter;
  const auto notSelected = [&](FindingKind kind) {
    return !isBinding(kind) && !isListed(kind, {}, {filter.select, {}});
  };
  leaveOut(notSelected, "--select", findings, done.left_out);
  leaveOut([&](FindingKind kind) { return holds(filter.ignore, kind); }, "--ignore", findings, done.left_out);
  if (wish.baseline) done.baseline = useBaseline(job, wish, compared, findings);
  return done;
}

}  // namespace proveout
