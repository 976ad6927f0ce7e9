// Parameters of the nct control that the simulation knows, by the control's own numbers.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/nc/interpreter.h"

namespace proveout::nc {

/// Order of nctParameterTable().
enum class NctParam : std::size_t {
  kDefaultFeedPerMinute,
  kDefaultFeedPerTurn,
  kSpindleOrients,
  kSpindleIndexes,
  kDefaultG1,
  kDefaultG18,
  kDefaultG19,
  kDefaultG43,
  kDefaultG44,
  kDefaultG91,
  kDefaultG95,
  kDwellSeconds,
  kAbsoluteCentre,
  kHelixFeedSpace,
  kSkipKeepsLookAhead,
  kToolChangeOnM6,
  kRadiusDifference,
  kToolOffsets,
  kInterferenceCheck,
  kInterferenceAlarm,
  kExtraLookAhead,
  kMinCompStep,
  kLengthAlwaysZ,
  kLengthByPlane,
  kChipBreakReturn,
  kPeckClearance,
  kBoreRetract,
  kTapRetract,
  kTapOrient,
  kTapReturnsToR,
  kTapExtraction,
  kRigidChipBreakReturn,
  kRigidPeckClearance,
  kCount
};

const std::array<ParameterInfo, static_cast<std::size_t>(NctParam::kCount)>& nctParameterTable();

/// Values of all parameters. Lengths mm.
class NctParameters {
 public:
  NctParameters();
  double operator[](NctParam p) const { return values_[static_cast<std::size_t>(p)]; }
  bool flag(NctParam p) const { return (*this)[p] != 0.0; }
  /// Whether set() gave the parameter a value.
  bool given(NctParam p) const { return given_[static_cast<std::size_t>(p)]; }
  /// Overwrites defaults. Error: unknown name (names the nearest) or value out of range.
  Status set(const std::map<std::string, double>& values);

 private:
  std::array<double, static_cast<std::size_t>(NctParam::kCount)> values_;
  std::array<bool, static_cast<std::size_t>(NctParam::kCount)> given_{};
};

}  // namespace proveout::nc
