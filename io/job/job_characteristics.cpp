// What features of the nominal are to be: [[characteristic]], and the general tolerances of [nominal].
#include <fmt/format.h>

#include <cmath>

#include "io/job/job_sections.h"
#include "removal/compare/features/judgement.h"

namespace proveout {
namespace {

const std::vector<std::string>& kindNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (int k = 0; k <= static_cast<int>(FeatureKind::kRound); ++k)
      out.emplace_back(featureKindName(static_cast<FeatureKind>(k)));
    return out;
  }();
  return names;
}

const std::vector<std::string>& quantityNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (int k = 0; k <= static_cast<int>(Quantity::kRoughness); ++k)
      out.emplace_back(quantityName(static_cast<Quantity>(k)));
    return out;
  }();
  return names;
}

/// `tolerance`, or `lower` and `upper`.
void readLimits(ConfigTable& table, CharacteristicRule& rule) {
  const bool both = table.find("tolerance") != nullptr;
  const bool apart = table.find("lower") != nullptr || table.find("upper") != nullptr;
  if (both == apart) {
    table.error("tolerance", "job-missing",
                "a characteristic has `tolerance` (to both sides), or `lower` and `upper` (deviations from "
                "nominal)");
    return;
  }
  if (const auto tolerance = table.number("tolerance", kLengthOrZero)) {
    rule.lower = -*tolerance;
    rule.upper = *tolerance;
  }
  if (!apart) return;
  rule.lower = table.number("lower", kAnyLength);
  rule.upper = table.number("upper", kAnyLength);
  if (rule.lower && rule.upper && *rule.lower > *rule.upper)
    table.error("lower", "job-value", "`lower` is not above `upper`");
  const bool zone = rule.quantity && isZone(*rule.quantity);
  if (zone && (rule.lower || (rule.upper && *rule.upper < 0.0)))
    table.error(
        "lower", "job-value",
        fmt::format("{} is a zone: it has an upper limit of 0 or more alone", quantityName(*rule.quantity)));
}

/// A characteristic of the part as a whole: least and largest value, where it is looked for.
PartRule readPartRule(ConfigTable& table, Quantity quantity) {
  PartRule rule;
  rule.quantity = quantity;
  if (const auto name = table.text("name")) rule.name = *name;
  table.must("what").choice("what", quantityNames());
  constexpr NumberRange kAnyValue{0.0, 1e9, true};
  rule.min = table.number("least", kAnyValue);
  rule.max = table.number("most", kAnyValue);
  if (!rule.min && !rule.max)
    table.error("what", "job-missing",
                fmt::format("{} has `least` or `most`, the allowed values", quantityName(quantity)));
  if (rule.min && rule.max && *rule.min > *rule.max)
    table.error("least", "job-value", "`least` is not above `most`");
  if (hasRegion(table)) rule.region = readRegion(table, "what");
  table.refuseOthers();
  return rule;
}

CharacteristicRule readRule(ConfigTable& table) {
  CharacteristicRule rule;
  if (const auto name = table.text("name")) rule.name = *name;
  if (const auto kind = table.choice("feature", kindNames())) rule.kind = featureKindNamed(*kind);
  if (const auto face = table.text("face")) rule.face = *face;
  if (const auto part = table.text("part")) rule.part = *part;
  rule.at = table.point("at");
  rule.size = table.number("size", kPositiveLength);
  if (const auto what = table.must("what").choice("what", quantityNames()))
    rule.quantity = quantityNamed(*what);
  rule.nominal = table.number("nominal", kAnyLength);
  if (rule.nominal && rule.quantity && isZone(*rule.quantity))
    table.error("nominal", "job-value",
                fmt::format("the nominal value of {} is 0", quantityName(*rule.quantity)));
  readLimits(table, rule);
  table.refuseOthers();
  return rule;
}

}  // namespace

void readFeatureKeys(ConfigTable& table, NominalSpec& nominal) {
  if (const auto wanted = table.flag("features")) nominal.features = *wanted;
  const auto text = table.text("general_tolerance");
  if (!text) return;
  if (Result<GeneralTolerance> general = parseGeneralTolerance(*text)) {
    nominal.general = *general;
  } else {
    table.error("general_tolerance", "job-value", general.error().message);
  }
}

void readCharacteristics(ConfigTable& root, Job& job) {
  for (ConfigTable& table : root.tables("characteristic", 10'000)) {
    const ConfigValue* what = table.find("what");
    const std::optional<Quantity> quantity = what == nullptr ? std::nullopt : quantityNamed(what->text);
    if (quantity && isOfPart(*quantity)) {
      job.part_characteristics.push_back(readPartRule(table, *quantity));
      continue;
    }
    CharacteristicRule rule = readRule(table);
    if (!job.nominal) {
      table.error("what", "job-missing", "characteristics are of the nominal: the job has no [nominal]");
      return;
    }
    if (!job.nominal->measuresFeatures()) {
      table.error("what", "job-value", "`features = false` in [nominal] leaves no characteristics");
      return;
    }
    job.nominal->characteristics.push_back(std::move(rule));
  }
}

}  // namespace proveout
