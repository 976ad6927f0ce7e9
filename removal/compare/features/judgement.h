// Tolerances of characteristics, and which of them the part keeps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "removal/compare/features/feature.h"
#include "removal/compare/features/general_tolerance.h"

namespace proveout {

/// Says what some characteristics of the nominal are to be: `[[characteristic]]` of a job. What is not given
/// leaves nothing out.
struct CharacteristicRule {
  std::string name;  ///< for people: "bearing seat"
  std::optional<FeatureKind> kind;
  std::string face;            ///< name of a face of the CAD model
  std::optional<Vec3> at;      ///< on the feature, or in it: the one that is nearest, within 1 mm
  std::optional<double> size;  ///< diameter, radius or width of the model, mm
  std::string part;            ///< "step of 12"
  std::optional<Quantity> quantity;
  std::optional<double> nominal;       ///< of the drawing, where that is not the model's
  std::optional<double> lower, upper;  ///< allowed deviations, lower <= upper; of zones the upper one alone
};

/// What the features of a comparison are judged by.
struct FeatureTolerances {
  double gouge_mm = 0.0, excess_mm = 0.0;  ///< of the surface
  GeneralTolerance general;
  std::vector<CharacteristicRule> rules;  ///< of several that fit the last one holds
};

enum class ToleranceSource : std::uint8_t {
  kNone,
  kSurface,  ///< what the tolerances of the surface leave for the characteristic
  kGeneral,
  kRule
};
enum class CharacteristicVerdict : std::uint8_t { kNone, kPass, kFail };

struct JudgedCharacteristic {
  double nominal = 0.0;
  std::optional<double> lower, upper;  ///< allowed deviations from it
  ToleranceSource source = ToleranceSource::kNone;
  const CharacteristicRule* rule = nullptr;  ///< of kRule
  CharacteristicVerdict verdict = CharacteristicVerdict::kNone;
};

struct Judgement {
  /// In the order of the features and their characteristics.
  std::vector<std::vector<JudgedCharacteristic>> features;
  std::vector<const CharacteristicRule*> unused;  ///< rules that no characteristic fits
};

/// `tolerances` has to outlive what is told. What was not measured fails where it has a tolerance.
Judgement judgeFeatures(const std::vector<Feature>& features, const CadFaces& faces,
                        const FeatureTolerances& tolerances);

}  // namespace proveout
