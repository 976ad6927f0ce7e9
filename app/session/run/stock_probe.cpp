#include "app/session/run/stock_probe.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/tool/tool_table.h"

namespace proveout {
namespace {

/// A tool that leaves a face goes this far before it counts as cutting into it again, mm.
constexpr double kLeaveMm = 2e-3;
/// To ask of more motions whether they cut takes longer than to cut.
constexpr std::size_t kMostAsked = 64;

Error turned() {
  return inputError(
      "measuring moves can be answered by the stock only where the tool is along +z and no rotary axis has "
      "turned");
}

bool standsStraight(const AxisSweep& axis) {
  if (!axis.alongZ()) return false;
  return std::all_of(axis.rotary.begin(), axis.rotary.begin() + axis.rotary_count,
                     [](const RotaryPosition& r) { return r.in_path || (r.from == 0.0 && r.to == 0.0); });
}

}  // namespace

Error undefinedTool(int number) {
  return inputError(fmt::format("tool {} is not defined; give it as [[tool]] in the job", number));
}

/// Motions that came since the last time, with the tools that they are cut with.
Status StockProbe::takeMotions() {
  const ToolTable tools(stock_.tools);
  for (; read_ < path_.motions.size(); ++read_) {
    Motion motion = path_.motions[read_];
    if (motion.axis >= 0 && !standsStraight(path_.axes[static_cast<std::size_t>(motion.axis)]))
      return turned();
    const Tool* tool = tools.ofMotion(motion.tool);
    if (tool == nullptr) return undefinedTool(motion.tool);
    motion.tool = tool->number;
    if (motion.arc >= 0) {
      cut_.arcs.push_back(path_.arcs[static_cast<std::size_t>(motion.arc)]);
      motion.arc = static_cast<std::int32_t>(cut_.arcs.size()) - 1;
    }
    motion.axis = -1;
    cut_.motions.push_back(motion);
  }
  return Done{};
}

/// Whether one of the motions from `first` on runs into the stock of the query.
bool StockProbe::mayHaveCut(std::size_t first) const {
  if (cut_.motions.size() - first > kMostAsked) return true;
  const ToolTable tools(stock_.tools);
  for (std::size_t i = first; i < cut_.motions.size(); ++i) {
    const Motion& motion = cut_.motions[i];
    if (motion.kind == MotionKind::kProbe) continue;
    if (motion.arc >= 0) return true;
    const double length = (motion.to - motion.from).norm();
    if (length <= kLeaveMm) continue;
    const Vec3 from = motion.from + (kLeaveMm / length) * (motion.to - motion.from);
    if (query_->firstContact(*tools.find(motion.tool), from, motion.to)) return true;
  }
  return false;
}

Status StockProbe::cutSoFar() {
  const std::size_t known = cut_.motions.size();
  if (Status taken = takeMotions(); !taken) return taken;
  if (query_ != nullptr && !mayHaveCut(known)) return Done{};
  Result<Stock> stock = stock_.make(progress_);
  if (!stock) return stock.error();
  const Result<RemovalSummary> cut = stock->remove(cut_, stock_.tools, stock_.options, progress_);
  if (!cut) return cut.error();
  SurfaceOptions options;
  options.simplify_mm = ContactQuery::kMeshMm;
  options.threads = stock_.options.threads;
  Result<StockSurface> surface = stock->surface(options, progress_);
  if (!surface) return surface.error();
  query_ = std::make_unique<ContactQuery>(std::move(*surface), cut_, stock_.tools, stock_.blank,
                                          stock->resolution());
  return Done{};
}

Result<std::optional<double>> StockProbe::firstContact(const Motion& move, const ArcGeometry* arc,
                                                       const AxisSweep* axis) {
  if (arc != nullptr || (axis != nullptr && !standsStraight(*axis))) return turned();
  const Tool* tool = ToolTable(stock_.tools).ofMotion(move.tool);
  if (tool == nullptr) return undefinedTool(move.tool);
  if (Status done = cutSoFar(); !done) {
    failure_ = done.error();
    return done.error();
  }
  return query_->firstContact(*tool, move.from, move.to);
}

}  // namespace proveout
