#include "app/session/findings/known_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "io/baseline.h"
#include "io/report_text.h"

namespace proveout {
namespace {

using report_text::figure;

/// Places of one finding, mm.
constexpr double kSamePlace = 1.0;
/// Growth that is still the same finding.
constexpr double kGrownShare = 0.1, kGrownSize = 0.5;
/// Areas and volumes that are within the rounding of a grid, mm2 and mm3.
constexpr double kRoundingSize = 1.0;

using Key = std::tuple<FindingKind, std::string, std::string, std::string>;

Key keyOf(const KnownFinding& f, const std::string& block) { return {f.kind, f.setup, f.file, block}; }

/// One of several blocks: its place is that of the deepest one, which may be another when some are gone.
bool isOfSeveral(const KnownFinding& f) { return f.spots > 1 && !isDeviation(f.kind); }

/// Distance of the places, mm; nothing: they are not those of one finding.
std::optional<double> distance(const KnownFinding& known, const KnownFinding& now) {
  if (known.where.has_value() != now.where.has_value()) return std::nullopt;
  if (!known.where) return 0.0;
  const double extent = std::sqrt(std::max(known.area_mm2.value_or(0.0), 0.0));
  const double d = (*known.where - *now.where).norm();
  if (isOfSeveral(known) || isOfSeveral(now)) return d;
  return d <= std::max(kSamePlace, extent) ? std::optional(d) : std::nullopt;
}

/// The entry of those that are left that lies nearest; of equally near ones that of the nearest line.
std::optional<std::size_t> nearest(const std::vector<KnownFinding>& baseline,
                                   const std::vector<std::size_t>& among, const std::vector<bool>& taken,
                                   const KnownFinding& now, double within_mm) {
  std::optional<std::size_t> best;
  std::pair<double, std::int64_t> least;
  for (const std::size_t k : among) {
    if (taken[k]) continue;
    const auto d = distance(baseline[k], now);
    if (!d || *d > within_mm) continue;
    const std::pair way(
        *d, std::abs(static_cast<std::int64_t>(baseline[k].line) - static_cast<std::int64_t>(now.line)));
    if (best && least <= way) continue;
    best = k;
    least = way;
  }
  return best;
}

double slackOf(FindingKind kind, const KnownSlack& slack) {
  if (kind == FindingKind::kGouge) return slack.gouge_mm;
  return kind == FindingKind::kExcess ? slack.excess_mm : slack.other_mm;
}

/// "0.35 mm before" where the figure has grown too far.
std::string grownText(const std::optional<double>& known, const std::optional<double>& now, double share,
                      double slack, const char* what, const char* unit) {
  if (!known || !now || *now <= *known + std::max(share * *known, slack)) return {};
  return fmt::format("{} {} {} was {}", what, figure(*now), unit, figure(*known));
}

std::string worseText(const KnownFinding& known, const KnownFinding& now, const KnownSlack& slack) {
  if (now.severity > known.severity)
    return fmt::format("{} was {}", severityName(now.severity), severityName(known.severity));
  std::string text =
      grownText(known.depth_mm, now.depth_mm, kGrownShare, slackOf(now.kind, slack), "depth", "mm");
  const double share = now.depth_mm ? kGrownSize : kGrownShare;
  if (text.empty()) text = grownText(known.volume_mm3, now.volume_mm3, share, kRoundingSize, "volume", "mm3");
  if (text.empty()) text = grownText(known.area_mm2, now.area_mm2, share, kRoundingSize, "area", "mm2");
  // Spots of a deviation are counted on samples; those of others are blocks.
  if (text.empty() && !isDeviation(now.kind) && now.spots > known.spots)
    text = fmt::format("{} places were {}", now.spots, known.spots);
  return text;
}

}  // namespace

std::vector<KnownFinding> markKnown(const std::vector<KnownFinding>& baseline, const KnownSlack& slack,
                                    std::vector<Finding>& findings) {
  std::map<Key, std::vector<std::size_t>> entries;
  for (std::size_t k = 0; k < baseline.size(); ++k) {
    const KnownFinding& known = baseline[k];
    entries[keyOf(known, known.block)].push_back(k);
    if (!known.last_block.empty() && known.last_block != known.block)
      entries[keyOf(known, known.last_block)].push_back(k);
  }
  std::vector<bool> taken(baseline.size()), met(findings.size());
  // What lies where it lay goes first, so that a new one beside it does not take its entry.
  constexpr double kThere = 1e-3, kAnywhere = 1e9;
  for (const double within_mm : {kThere, kAnywhere}) {
    for (std::size_t i = 0; i < findings.size(); ++i) {
      if (met[i] || isBinding(findings[i].kind)) continue;
      const KnownFinding now = knownFinding(findings[i]);
      const auto among = entries.find(keyOf(now, now.block));
      if (among == entries.end()) continue;
      const auto k = nearest(baseline, among->second, taken, now, within_mm);
      if (!k) continue;
      met[i] = taken[*k] = true;
      findings[i].worse = worseText(baseline[*k], now, slack);
      findings[i].known = findings[i].worse.empty();
    }
  }
  std::vector<KnownFinding> gone;
  for (std::size_t k = 0; k < baseline.size(); ++k) {
    if (!taken[k]) gone.push_back(baseline[k]);
  }
  return gone;
}

}  // namespace proveout
