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
    const double deviation = nominal_->deviation(nominal_->distance.at(p), p), size = std::abs(deviation);
    if (options_.part == nullptr || size <= kUnseen * std::min(options_.gouge_mm, options_.excess_mm) ||
        size > 2.0 * options_.resolution_mm)
      return static_cast<float>(deviation);
    const SettledPoint at = settle(*options_.part, p, 1.2 * size + options_.uncertainty_mm + 0.01);
    if (!at.found) return static_cast<float>(deviation);
    return static_cast<float>(nominal_->deviation(nominal_->distance.at(at.p), at.p));
  }

 private:
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
