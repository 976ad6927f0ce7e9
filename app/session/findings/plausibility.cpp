#include "app/session/findings/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/session/findings/blame.h"
#include "io/report_text.h"

namespace proveout {
namespace {

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
  Finding finding(FindingKind::kFeedRate);
  finding.where = motions[worst].to;
  blame(finding, worst, setup.interpreted.path, texts);
  finding.spots = count;
  finding.message = fmt::format("the feed of {} mm a turn is more than {} of {:g} mm ({} such motions)",
                                report_text::figure(most), limit.what, limit.mm, count);
  findings.push_back(std::move(finding));
}

}  // namespace

void addImplausible(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings) {
  for (const Tool& tool : setup.job.tools) addFeed(setup, tool, texts, findings);
}

}  // namespace proveout
