// Settings of Fanuc-like controls: `[control.fanuc]` of a job, numbers are Fanuc's parameters.
#pragma once

#include <cstdint>

#include "core/nc/iso/parameters/parameter_table.h"

namespace proveout::nc {

/// Settings that only these controls have. Those of the shared rules are in iso/parameters.
enum class FanucParam : std::uint16_t {
  kFlavour,  ///< 0 Fanuc, 1 Haas
  kDecimal,  ///< 3401#0 DPI: 0 a number without a point counts in units, 1 in least increments
  kCount
};
constexpr ParamId paramId(FanucParam p) { return {ParamChapter::kOwn, static_cast<std::uint16_t>(p)}; }

const ParameterTable& fanucParameters();

}  // namespace proveout::nc
