#include "app/session/part_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/session/comparison.h"
#include "app/session/findings/feature_table.h"
#include "app/session/findings/uncertainty.h"
#include "core/tool/tool_table.h"
#include "removal/compare/part/part_measure.h"

namespace proveout {
namespace {

/// Height of the marks that a nose leaves at a feed per turn: between circles beside each other.
double feedMark(const Motion& motion, const Insert& insert) {
  if (motion.kind != MotionKind::kFeed || motion.spindle == 0.0 || !(motion.feed > 0.0)) return 0.0;
  const double half = 0.5 * motion.feed / std::abs(motion.spindle), r = insert.nose_radius;
  return half < r ? r - std::sqrt(r * r - half * half) : 0.0;
}

Pass passOf(const RunResult& run, const SurfaceMaker& maker) {
  const std::size_t number = std::min<std::size_t>(maker.setup, run.setups.size() - 1);
  const SetupRun& setup = run.setups[number];
  const std::vector<Motion>& motions = setup.interpreted.path.motions;
  if (maker.motion >= motions.size()) return {};
  const Motion& motion = motions[maker.motion];
  const Tool* tool = ToolTable(setup.job.tools).find(motion.tool);
  if (tool == nullptr) return {};
  Pass pass;
  // Tools of one number may differ from clamping to clamping.
  pass.tool = static_cast<int>(number) * 100'000'000 + motion.tool;
  if (tool->insert) {
    pass.feed_mark_mm = feedMark(motion, *tool->insert);
  } else if (tool->type != ToolType::kWire) {
    pass.diameter_mm = tool->diameter;
    for (const OutlinePoint& point : tool->outline)
      pass.diameter_mm = std::max(pass.diameter_mm, 2.0 * point.r);
  }
  return pass;
}

bool isKept(const PartRule& rule, double value) {
  return (!rule.min || value >= *rule.min) && (!rule.max || value <= *rule.max);
}

std::string limitsText(const PartRule& rule) {
  if (rule.min && rule.max) return fmt::format("{:g} to {:g}", *rule.min, *rule.max);
  return rule.min ? fmt::format("at least {:g}", *rule.min) : fmt::format("at most {:g}", *rule.max);
}

/// A part that has nothing of the kind keeps every limit: no crest is none too high.
bool isGood(const PartRule& rule, const PartFeature& feature) {
  return feature.measured ? isKept(rule, *feature.measured) : feature.measurable;
}

std::string faultText(const PartRule& rule, const PartFeature& feature) {
  const std::string unit = unitOf(rule.quantity);
  const std::string name = rule.name.empty() ? "" : ", " + rule.name;
  if (!feature.measurable)
    return fmt::format(
        "{} cannot be measured on a part that a wire cut or whose blank is a saved grid "
        "(allowed {} {}{})",
        quantityName(rule.quantity), limitsText(rule), unit, name);
  const bool sharp = rule.quantity == Quantity::kInnerRadius && *feature.measured == 0.0;
  return fmt::format("{} is {:.4f} {}{} (allowed {}{})", quantityName(rule.quantity), *feature.measured, unit,
                     sharp ? ", a sharp corner" : "", limitsText(rule), name);
}

}  // namespace

Status checkPart(const Job& job, const RunSources& sources, const Blank& blank, RunResult& run,
                 Progress& progress) {
  if (job.part_characteristics.empty()) return Done{};
  Result<std::unique_ptr<ExactPart>> exact = makeExactPart(blank.shape, run);
  if (!exact) return exact.error();
  MeasuredPart part{run.surface().mesh,    exact->get(),
                    partUncertainty(run),  run.resolution_mm,
                    run.setups.size() > 1, [&run](const SurfaceMaker& maker) { return passOf(run, maker); }};
  Result<std::vector<PartFeature>> measured = measurePart(part, job.part_characteristics, progress);
  if (!measured) return measured.error();
  run.part_features = std::move(*measured);
  for (std::size_t k = 0; k < run.part_features.size(); ++k) {
    const PartRule& rule = job.part_characteristics[k];
    const PartFeature& feature = run.part_features[k];
    if (isGood(rule, feature)) continue;
    Finding finding(FindingKind::kCharacteristic);
    if (feature.measured) finding.where = feature.where;
    finding.message = faultText(rule, feature);
    run.findings.push_back(std::move(finding));
    if (feature.measured)
      blameMaker(feature.maker, feature.where, 2.0 * run.resolution_mm, sources, run, run.findings.back());
  }
  return Done{};
}

std::vector<ReportCharacteristic> partCharacteristics(const Job& job, const RunResult& run) {
  std::vector<ReportCharacteristic> out;
  for (std::size_t k = 0; k < run.part_features.size(); ++k) {
    const PartRule& rule = job.part_characteristics[k];
    const PartFeature& feature = run.part_features[k];
    ReportCharacteristic row;
    row.name = quantityName(rule.quantity);
    row.label = rule.name;
    row.unit = unitOf(rule.quantity);
    row.measured = feature.measured;
    if (feature.measured) row.where = feature.where;
    row.lower = rule.min;
    row.upper = rule.max;
    row.tolerance = "job";
    row.verdict = isGood(rule, feature) ? "pass" : "fail";
    out.push_back(std::move(row));
  }
  return out;
}

}  // namespace proveout
