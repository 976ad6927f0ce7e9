// What comparing two meshes will take, before it is started.
#pragma once

#include "app/session/forecast/prediction.h"
#include "core/base/result.h"

namespace proveout {

struct ComparisonWork {
  double area_mm2 = 0.0;   ///< of both meshes
  double triangles = 0.0;  ///< of both
  double pixels = 0.0;     ///< of one picture
  int pictures = 0;
};

/// `spacing_mm`: of the samples, above 0.
Prediction predict(const ComparisonWork& work, double spacing_mm);

/// What it may take. 0: not limited.
struct ComparisonLimits {
  double memory_mb = 0.0, time_s = 0.0;
};

/// Errors: more memory than allowed, or more than twice the time; says which spacing would fit.
Status checkLimits(const ComparisonWork& work, double spacing_mm, const Prediction& prediction,
                   const ComparisonLimits& limits);

}  // namespace proveout
