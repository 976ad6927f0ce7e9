#include "app/session/findings/feature_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace proveout {

std::string unitOf(Quantity quantity) {
  if (isAngle(quantity)) return "deg";
  if (quantity == Quantity::kSkin) return "mm2";
  return quantity == Quantity::kRoughness ? "um" : "mm";
}

namespace {

std::string sourceText(const JudgedCharacteristic& judged, const FeatureTolerances& tolerances) {
  switch (judged.source) {
    case ToleranceSource::kSurface:
      return "surface";
    case ToleranceSource::kGeneral:
      return tolerances.general.text();
    case ToleranceSource::kRule:
      return "job";
    default:
      return "";
  }
}

ReportCharacteristic rowOf(const Characteristic& c, const JudgedCharacteristic& judged,
                           const FeatureTolerances& tolerances) {
  ReportCharacteristic row;
  row.name = quantityName(c.quantity);
  row.part = c.part;
  if (judged.rule != nullptr) row.label = judged.rule->name;
  row.unit = unitOf(c.quantity);
  row.nominal = judged.nominal;
  row.measured = c.measured;
  row.lower = judged.lower;
  row.upper = judged.upper;
  row.tolerance = sourceText(judged, tolerances);
  if (judged.verdict != CharacteristicVerdict::kNone)
    row.verdict = judged.verdict == CharacteristicVerdict::kPass ? "pass" : "fail";
  return row;
}

std::string limitsText(const JudgedCharacteristic& judged) {
  if (judged.lower && judged.upper)
    return fmt::format("{:+g} to {:+g}", *judged.lower + 0.0, *judged.upper + 0.0);
  if (judged.upper) return fmt::format("up to {:g}", *judged.upper);
  return fmt::format("from {:+g}", *judged.lower);
}

/// "diameter of the through hole ... is 8.053 mm, +0.053 off 8 (allowed -0.02 to +0.02, bearing seat)".
std::string faultText(const Feature& feature, const Characteristic& c, const JudgedCharacteristic& judged,
                      const FeatureTolerances& tolerances) {
  const std::string name = judged.rule == nullptr || judged.rule->name.empty()
                               ? sourceText(judged, tolerances)
                               : judged.rule->name;
  const std::string what = fmt::format("{} of the {}{}", quantityName(c.quantity), feature.name,
                                       c.part.empty() ? "" : ", " + c.part + ",");
  if (!c.measured)
    return fmt::format("{} cannot be measured: the part has too little of it (allowed {}, {})", what,
                       limitsText(judged), name);
  return fmt::format("{} is {:.4f} {}, {:+.4f} off {:.6g} (allowed {}, {})", what, *c.measured,
                     unitOf(c.quantity), *c.measured - judged.nominal, judged.nominal, limitsText(judged),
                     name);
}

const FaceFit* fitOf(const Comparison& comparison, const std::vector<std::uint32_t>& faces) {
  for (const std::uint32_t face : faces) {
    for (const FaceFit& fit : comparison.face_fits)
      if (fit.face == face && fit.points > 0) return &fit;
  }
  return nullptr;
}

std::string ruleText(const CharacteristicRule& rule) {
  std::string out =
      rule.name.empty() ? "the characteristic" : fmt::format("the characteristic '{}'", rule.name);
  if (rule.quantity) out += fmt::format(" ({})", quantityName(*rule.quantity));
  return out;
}

}  // namespace

std::string featureAt(std::uint32_t face, const Comparison& comparison) {
  for (const Feature& feature : comparison.features)
    if (std::find(feature.faces.begin(), feature.faces.end(), face) != feature.faces.end())
      return feature.name;
  return describe(comparison.nominal_faces->faces[face]);
}

std::vector<ReportFeature> featureTable(const Comparison& comparison, const FeatureTolerances& tolerances) {
  std::vector<ReportFeature> out;
  if (comparison.features.empty()) return out;
  const Judgement judgement = judgeFeatures(comparison.features, *comparison.nominal_faces, tolerances);
  for (std::size_t k = 0; k < comparison.features.size(); ++k) {
    const Feature& feature = comparison.features[k];
    ReportFeature row;
    row.id = fmt::format("F{}", k + 1);
    row.kind = featureKindName(feature.kind);
    row.feature = feature.name;
    row.at = feature.at;
    row.missing = feature.missing;
    if (comparison.faces_found) {
      row.residual_mm = 0.0;
      for (const std::uint32_t f : feature.faces)
        row.residual_mm = std::max(*row.residual_mm, comparison.nominal_faces->faces[f].residual_mm);
    }
    for (std::size_t i = 0; i < feature.characteristics.size(); ++i)
      row.characteristics.push_back(rowOf(feature.characteristics[i], judgement.features[k][i], tolerances));
    out.push_back(std::move(row));
  }
  return out;
}

std::vector<CharacteristicFault> addCharacteristics(const Comparison& comparison,
                                                    const FeatureTolerances& tolerances,
                                                    std::vector<Finding>& findings) {
  std::vector<CharacteristicFault> faults;
  static const CadFaces kNoFaces;
  const CadFaces& faces = comparison.nominal_faces == nullptr ? kNoFaces : *comparison.nominal_faces;
  const Judgement judgement = judgeFeatures(comparison.features, faces, tolerances);
  for (std::size_t k = 0; k < comparison.features.size(); ++k) {
    const Feature& feature = comparison.features[k];
    for (std::size_t i = 0; i < feature.characteristics.size(); ++i) {
      const Characteristic& c = feature.characteristics[i];
      const JudgedCharacteristic& judged = judgement.features[k][i];
      const bool own = judged.source == ToleranceSource::kRule || judged.source == ToleranceSource::kGeneral;
      if (!own || judged.verdict != CharacteristicVerdict::kFail) continue;
      Finding finding(FindingKind::kCharacteristic);
      finding.where = feature.at;
      finding.feature = feature.name;
      if (c.measured && !isAngle(c.quantity)) finding.depth_mm = std::abs(*c.measured - judged.nominal);
      finding.message = feature.missing ? fmt::format("the {} is missing", feature.name)
                                        : faultText(feature, c, judged, tolerances);
      if (const FaceFit* fit = fitOf(comparison, c.faces))
        faults.push_back({findings.size(), fit->maker, fit->middle});
      findings.push_back(std::move(finding));
      if (feature.missing) break;  // once
    }
  }
  for (const CharacteristicRule* rule : judgement.unused) {
    Finding finding(FindingKind::kCharacteristic);
    finding.where = rule->at;
    finding.message = ruleText(*rule) + " is of no feature of the nominal: see the features in report.json";
    findings.push_back(std::move(finding));
  }
  return faults;
}

}  // namespace proveout
