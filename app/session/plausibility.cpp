#include "app/session/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/session/blame.h"
#include "io/report_text.h"

namespace proveout {
namespace {

constexpr double kLongMotion = 1800.0, kLongProgram = 86400.0;  ///< s
constexpr double kRounding = 1.0 + 1e-6;

/// The feed per revolution that an insert cannot have, mm, and why; 0: not known.
struct FeedLimit {
  double mm = 0.0;
  const char* what = "";
};

FeedLimit feedLimit(const Tool& tool) {
  if (!tool.insert || tool.insert->shape == InsertShape::kThread) return {};
  if (tool.insert->shape == InsertShape::kGroove) return {tool.insert->width, "the width of the blade"};
  return {tool.insert->nose_radius, "its nose radius"};
}

Finding findingAt(FindingKind kind, MotionId motion, const SetupRun& setup, const RecordingSource& texts) {
  Finding finding(kind);
  finding.where = setup.interpreted.path.motions[motion].to;
  blame(finding, motion, setup.interpreted.path, texts);
  return finding;
}

void addFeed(const SetupRun& setup, const Tool& tool, const RecordingSource& texts,
             std::vector<Finding>& findings) {
  const FeedLimit limit = feedLimit(tool);
  if (!(limit.mm > 0.0)) return;
  const auto& motions = setup.interpreted.path.motions;
  MotionId worst = kNoMotion;
  double most = 0.0;
  std::size_t count = 0;
  for (MotionId id = 0; id < setup.removal.removed_mm3.size(); ++id) {
    const Motion& m = motions[id];
    if (m.tool != tool.number || m.kind != MotionKind::kFeed || m.spindle == 0.0) continue;
    const double feed = m.feed / std::abs(m.spindle);
    if (feed <= limit.mm * kRounding || !(setup.removal.removed_mm3[id] > 0.0F)) continue;
    ++count;
    if (feed <= most) continue;
    most = feed;
    worst = id;
  }
  if (worst == kNoMotion) return;
  Finding finding = findingAt(FindingKind::kFeedRate, worst, setup, texts);
  finding.spots = count;
  finding.message = fmt::format("the feed of {} mm a turn is more than {} of {:g} mm ({} such motions)",
                                report_text::figure(most), limit.what, limit.mm, count);
  findings.push_back(std::move(finding));
}

void addTimes(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  const auto& motions = setup.interpreted.path.motions;
  const auto longest = std::max_element(motions.begin(), motions.end(),
                                        [](const Motion& a, const Motion& b) { return a.time_s < b.time_s; });
  if (longest == motions.end()) return;
  double sum = 0.0;
  for (const Motion& motion : motions) sum += motion.time_s;
  if (longest->time_s <= kLongMotion && sum <= kLongProgram) return;
  Finding finding =
      findingAt(FindingKind::kCycleTime, static_cast<MotionId>(longest - motions.begin()), setup, texts);
  finding.message =
      fmt::format("this motion alone takes {}, the motions of the program {}: is the feed right?",
                  report_text::duration(longest->time_s), report_text::duration(sum));
  findings.push_back(std::move(finding));
}

}  // namespace

void addImplausible(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const Tool& tool : setup.job.tools) addFeed(setup, tool, texts, findings);
  addTimes(setup, texts, findings);
}

}  // namespace proveout
