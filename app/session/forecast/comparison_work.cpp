#include "app/session/forecast/comparison_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace proveout {
namespace {

// Measured on meshes of 12 to 5,000,000 triangles, with 90,000 to 2,500,000 samples.
constexpr double kBaseMb = 34.0;             ///< program, libraries, threads, CGAL's tables
constexpr double kBytesPerSample = 210.0;    ///< their search trees and deviations
constexpr double kBytesPerTriangle = 210.0;  ///< of the files: read as curved faces everywhere
constexpr double kMostSamples = 1.8e6;       ///< the comparison widens its samples beyond
constexpr double kBytesPerPixel = 10.0;      ///< two pictures, and a file
constexpr double kDrawingMb = 27.0;          ///< rows of what pixels show, Embree
constexpr double kBytesPerDrawnTriangle = 140.0;
constexpr double kBaseS = 0.03;
constexpr double kSecondsPerSample = 0.8e-6, kSecondsPerTriangle = 2.3e-6, kSecondsPerPixel = 1.5e-7;

double samplesOf(const ComparisonWork& work, double spacing_mm) {
  return std::min(work.area_mm2 / (spacing_mm * spacing_mm), kMostSamples);
}

std::string fittingText(const ComparisonWork& work, double spacing_mm, double limit_mb) {
  constexpr int kDoublings = 20;
  double wider = spacing_mm;
  for (int k = 0; k < kDoublings; ++k) {
    wider *= 2.0;
    if (predict(work, wider).memory_mb <= limit_mb)
      return fmt::format("samples {:g} mm apart would fit (--resolution)", wider);
  }
  return "no spacing would fit";
}

}  // namespace

Prediction predict(const ComparisonWork& work, double spacing_mm) {
  const double samples = samplesOf(work, spacing_mm);
  const double comparing = samples * kBytesPerSample;
  const double drawing = work.pictures > 0 ? 1e6 * kDrawingMb + work.pixels * kBytesPerPixel +
                                                 work.triangles * kBytesPerDrawnTriangle
                                           : 0.0;
  const double serial_s = work.triangles * kSecondsPerTriangle;
  return {kBaseMb + 1e-6 * (work.triangles * kBytesPerTriangle + std::max(comparing, drawing)),
          kBaseS + serial_s + samples * kSecondsPerSample + work.pictures * work.pixels * kSecondsPerPixel,
          serial_s};
}

Status checkLimits(const ComparisonWork& work, double spacing_mm, const Prediction& prediction,
                   const ComparisonLimits& limits) {
  constexpr double kDoubt = 2.0;
  if (limits.memory_mb > 0.0 && prediction.memory_mb > limits.memory_mb) {
    return Error{
        ErrorKind::kResourceLimit,
        fmt::format("the comparison would need about {:.0f} MB, {:.0f} MB are allowed; {}, or allow "
                    "more (--max-memory)",
                    prediction.memory_mb, limits.memory_mb, fittingText(work, spacing_mm, limits.memory_mb))};
  }
  if (limits.time_s <= 0.0 || prediction.time_s <= kDoubt * limits.time_s) return Done{};
  return Error{
      ErrorKind::kResourceLimit,
      fmt::format("the comparison would take about {:.0f} s, {:g} s are allowed; take samples further "
                  "apart (--resolution), or allow more (--max-time)",
                  prediction.time_s, limits.time_s)};
}

}  // namespace proveout
