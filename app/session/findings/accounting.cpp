#include "app/session/findings/accounting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "core/base/assert.h"

namespace proveout {
namespace {

/// Mean section of chip up to which a motion counts as one through air, mm2: a chip of 3 by 3 micrometres.
/// Below it lies what rounding leaves where a cutter follows a surface that it made before.
constexpr double kAirSectionMm2 = 1e-5;

/// Steps of the rate series: more than a chart has pixels to show.
constexpr std::size_t kRateSteps = 1000;

/// A motion or an event of a path, in the order in which they start.
struct Step {
  int channel = 0;
  const Motion* motion = nullptr;  ///< null: an event
  const SourceRef* source = nullptr;
  int tool = 0;  ///< of the motion; of the next motion (else the last) for an event
  double start_s = 0.0, time_s = 0.0, length_mm = 0.0, removed_mm3 = 0.0;
  double cut_mm = 0.0;    ///< the way of the edge through the material: of a turning tool round the part
  double wire_mm2 = 0.0;  ///< that a wire passes through, where it removes anything
};

template <typename Use>
void walk(const CutPath& cut, double start_s, const Use& use) {
  PROVEOUT_ASSERT(cut.path != nullptr && cut.removed_mm3 != nullptr);
  const Toolpath& path = *cut.path;
  std::array<double, 1 + std::numeric_limits<std::uint8_t>::max()> clocks;  // each channel has its own
  clocks.fill(start_s);
  std::size_t next_event = 0;
  const auto passEvents = [&](std::size_t before) {
    for (; next_event < path.events.size() && path.events[next_event].before <= before; ++next_event) {
      const PathEvent& event = path.events[next_event].event;
      if (event.time_s <= 0.0) continue;
      double& now = clocks[event.channel];
      Step step;
      step.channel = event.channel;
      step.source = &event.source;
      if (!path.motions.empty()) step.tool = path.motions[std::min(before, path.motions.size() - 1)].tool;
      step.start_s = now;
      step.time_s = event.time_s;
      use(step);
      now += event.time_s;
    }
  };
  for (std::size_t i = 0; i < path.motions.size(); ++i) {
    passEvents(i);
    const Motion& motion = path.motions[i];
    double& now = clocks[motion.channel];
    Step step{motion.channel,      &motion, &motion.source, motion.tool, now, motion.time_s,
              path.length(motion), 0.0};
    if (i < cut.removed_mm3->size()) step.removed_mm3 = static_cast<double>((*cut.removed_mm3)[i]);
    step.cut_mm = cut.part_turns ? lengthOfCut(path, motion, step.removed_mm3) : step.length_mm;
    if (isChip(step.removed_mm3, step.cut_mm)) step.wire_mm2 = cut.wire_height_mm * step.cut_mm;
    use(step);
    now += motion.time_s;
  }
  passEvents(path.motions.size());
}

void add(const Step& step, CutFigures& figures) {
  figures.removed_mm3 += step.removed_mm3;
  if (step.motion == nullptr) {
    figures.other_s += step.time_s;
    return;
  }
  const bool rapid = step.motion->kind == MotionKind::kRapid;
  const bool cuts = isChip(step.removed_mm3, step.cut_mm);
  (rapid ? figures.rapid_s : figures.feed_s) += step.time_s;
  figures.length_mm += step.length_mm;
  if (cuts) {
    figures.engaged_s += step.time_s;
    figures.engaged_mm += step.cut_mm;
    figures.wire_mm2 += step.wire_mm2;
    if (step.wire_mm2 > 0.0) figures.wire_s += step.time_s;
  } else if (!rapid) {
    figures.air_s += step.time_s;
  }
}

/// Spreads the motions over equal steps of time.
class RateCollector {
 public:
  RateCollector(double total_s, bool by_area) {
    rate_.by_area = by_area;
    if (!(total_s > 0.0)) return;
    rate_.step_s = total_s / static_cast<double>(kRateSteps);
    rate_.mean.assign(kRateSteps, 0.0);
    rate_.max.assign(kRateSteps, 0.0);
  }

  void startPath(const std::string& setup) {
    spans_.clear();
    setup_ = setup;
  }

  void add(const Step& step) {
    if (rate_.mean.empty() || !(step.time_s > 0.0)) return;
    PROVEOUT_ASSERT(rate_.max.size() == rate_.mean.size());
    addSpan(step);
    const double taken = rate_.by_area ? step.wire_mm2 : step.removed_mm3;
    if (!(taken > 0.0)) return;
    const double rate = 60.0 * taken / step.time_s;
    const double end_s = step.start_s + step.time_s;
    for (std::size_t i = indexAt(step.start_s); i <= indexAt(end_s); ++i) {
      const double low = static_cast<double>(i) * rate_.step_s;
      const double share = std::min(end_s, low + rate_.step_s) - std::max(step.start_s, low);
      if (share <= 0.0) continue;
      rate_.mean[i] += rate * share / rate_.step_s;
      rate_.max[i] = std::max(rate_.max[i], rate);
    }
  }

  RateSeries take() { return std::move(rate_); }

 private:
  std::size_t indexAt(double s) const {
    return std::min(kRateSteps - 1, static_cast<std::size_t>(std::max(0.0, s / rate_.step_s)));
  }
  void addSpan(const Step& step) {
    const auto [open, first] = spans_.try_emplace(step.channel);
    if (first || step.tool != open->second.tool) {
      const std::string before = setup_.empty() ? "" : setup_ + " ";
      open->second = {step.tool, rate_.spans.size()};
      rate_.spans.push_back({step.start_s, step.start_s, fmt::format("{}T{}", before, step.tool)});
    }
    PROVEOUT_ASSERT(open->second.index < rate_.spans.size());
    rate_.spans[open->second.index].to_s = step.start_s + step.time_s;
  }

  struct Open {
    int tool = 0;
    std::size_t index = 0;  ///< in rate_.spans
  };
  RateSeries rate_;
  std::string setup_;
  std::map<int, Open> spans_;  ///< that go on, by channel
};

std::string_view kindOf(const Step& step) {
  return step.motion ? motionKindName(step.motion->kind) : std::string_view("event");
}

}  // namespace

double lengthOfCut(const Toolpath& path, const Motion& motion, double removed_mm3) {
  const double length = path.length(motion), turns = std::abs(motion.spindle) * motion.time_s / 60.0;
  if (!(turns > 0.0) || !(length > 0.0)) return length;
  // A layer of depth d beside the way, which has its middle at r, has the volume 2 pi (r + k d / 2) d length;
  // k is how much the layer lies farther out: all of d along the axis, nothing across it.
  const double r = 0.5 * std::abs(motion.from.x() + motion.to.x()),
               k = std::abs(motion.to.z() - motion.from.z()) / length,
               half = std::max(0.0, removed_mm3) / (2.0 * kPi * length);
  const double root = std::sqrt(r * r + 2.0 * k * half);
  const double depth = root + r > 0.0 ? 2.0 * half / (root + r) : 0.0;
  return std::hypot(length, 2.0 * kPi * (r + 0.5 * k * depth) * turns);
}

bool isChip(double removed_mm3, double length_mm) { return removed_mm3 > kAirSectionMm2 * length_mm; }

ReportAccounting accountFor(const std::vector<CutPath>& paths) {
  ReportAccounting result;
  std::map<int, CutFigures> tools;
  double end_s = 0.0;
  for (const CutPath& cut : paths) {
    const double now = end_s;
    walk(cut, now, [&](const Step& step) {
      add(step, result.total);
      add(step, tools[step.tool]);
      end_s = std::max(end_s, step.start_s + step.time_s);
    });
  }
  for (const auto& [number, figures] : tools) result.per_tool.push_back({number, figures});
  const bool by_area = !paths.empty() && std::all_of(paths.begin(), paths.end(), [](const CutPath& cut) {
    return cut.wire_height_mm > 0.0;
  });
  RateCollector rate(end_s, by_area);
  double start_s = 0.0;
  for (const CutPath& cut : paths) {
    const double now = start_s;
    rate.startPath(cut.setup);
    walk(cut, now, [&](const Step& step) {
      rate.add(step);
      start_s = std::max(start_s, step.start_s + step.time_s);
    });
  }
  result.rate = rate.take();
  return result;
}

void forEachBlock(const CutPath& cut, double start_s, const std::function<void(const BlockFigures&)>& row) {
  const SourceRef* last = nullptr;
  BlockFigures block;
  walk(cut, start_s, [&](const Step& step) {
    if (last == nullptr || !sameBlock(*last, *step.source)) {
      if (last != nullptr) row(block);
      const SourceRef& source = *step.source;
      block = BlockFigures();
      block.setup = cut.setup;
      if (source.file < cut.path->files.size()) block.file = cut.path->files[source.file];
      block.line = source.line;
      block.block = source.block;
      block.depth = source.depth;
      block.kind = kindOf(step);
      block.start_s = step.start_s;
    }
    last = step.source;
    if (block.kind == "event" && step.motion) block.kind = kindOf(step);
    if (step.motion && block.kind != kindOf(step)) block.kind = "mixed";
    block.tool = step.tool;
    add(step, block.figures);
  });
  if (last != nullptr) row(block);
}

}  // namespace proveout
