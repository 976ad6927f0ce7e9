// Power-on codes, feeds, arcs, execution.
#pragma once

#include "core/nc/iso/parameters/parameter_types.h"

namespace proveout::nc {

enum class MotionParam : std::uint16_t {
  kDefaultFeedPerMinute,
  kDefaultFeedPerTurn,
  kDefaultG1,
  kDefaultG18,
  kDefaultG19,
  kDefaultG20,
  kDefaultG43,
  kDefaultG44,
  kDefaultG91,
  kDefaultG95,
  kDwellSeconds,
  kAbsoluteCentre,
  kHelixFeedSpace,
  kSkipKeepsLookAhead,
  kRadiusDifference,
  kCount
};
constexpr ParamId paramId(MotionParam p) { return {ParamChapter::kMotion, static_cast<std::uint16_t>(p)}; }

}  // namespace proveout::nc
