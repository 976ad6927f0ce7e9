#include "removal/compare/point_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

class PointDeviation final : public DeviationField {
 public:
  PointDeviation(std::shared_ptr<const NominalModel> nominal, const CompareOptions& options)
      : nominal_(std::move(nominal)), options_(options) {}

  float at(const Vec3& p) const override {
    for (const IgnoredRegion& region : options_.ignored) {
      if (region.contains(p)) return std::numeric_limits<float>::quiet_NaN();
    }
    return static_cast<float>(measure(p).deviation);
  }

  NominalFoot footOf(const Vec3& p) const override {
    const SurfaceDistance distance = measure(p).distance;
    NominalFoot foot;
    foot.normal = distance.gradient.cast<double>();
    if (options_.nominal_faces != nullptr) foot.face = options_.nominal_faces->of_triangle[distance.triangle];
    return foot;
  }

 private:
  struct Measured {
    SurfaceDistance distance;
    double deviation;
  };
  Measured measureAt(const Vec3& p) const {
    const SurfaceDistance distance = nominal_->distance.at(p);
    return {distance, nominal_->deviation(distance, p)};
  }
  Measured measure(const Vec3& p) const {
    const Measured on_mesh = measureAt(p);
    const double size = std::abs(on_mesh.deviation);
    if (options_.part == nullptr || size <= kUnseen * std::min(options_.gouge_mm, options_.excess_mm) ||
        size > 2.0 * options_.resolution_mm)
      return on_mesh;
    const SettledPoint at = settle(*options_.part, p, 1.2 * size + options_.uncertainty_mm + 0.01);
    return at.found ? measureAt(at.p) : on_mesh;
  }

  static constexpr double kUnseen = 0.2;  ///< of a tolerance: no colour shows less
  std::shared_ptr<const NominalModel> nominal_;
  CompareOptions options_;
};

}  // namespace

std::unique_ptr<DeviationField> makeDeviationField(std::shared_ptr<const NominalModel> nominal,
                                                   const CompareOptions& options) {
  return std::make_unique<PointDeviation>(std::move(nominal), options);
}

}  // namespace proveout
