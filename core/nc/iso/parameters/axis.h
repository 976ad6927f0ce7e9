// Axes: names, kinds, diameters, turns; smoothing.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class AxisParam : std::uint16_t {
  kName1,
  kName2,
  kName3,
  kPlane,
  kInchEncoder,
  kIncrementSystem,
  kDiameter,
  kRotary,
  kDiameterByCode,
  kRollover,
  kRolloverShortest,
  kRolloverBySign,
  kRolloverPeriod,
  kPolarOffset,
  kReference1,
  kSmoothBlockMax,
  kSmoothBlockMin,
  kSmoothAngle,
  kSmoothMerge,
  kSmoothDeviationMax,
  kSmoothDeviationMin,
  kFineTolerance,
  kFineBlockMin,
  kCount
};
constexpr ParamId paramId(AxisParam p) { return {ParamChapter::kAxis, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
