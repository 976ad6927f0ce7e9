#include "removal/cut/near_samples.h"

#include <array>
#include <bit>

namespace proveout {
namespace {

/// Sides of a part whose nearest samples are told apart, by the cosine between their directions.
constexpr std::size_t kMostSides = 4;
constexpr double kSameSide = 0.8;

class Sides {
 public:
  void add(const SweepSample& sample, const Vec3& at) {
    for (std::size_t i = 0; i < count_; ++i) {
      if (sides_[i].direction.dot(sample.gradient) < kSameSide) continue;
      if (sample.value < sides_[i].distance) sides_[i] = {sample.value, sample.gradient, at};
      return;
    }
    if (count_ < kMostSides) sides_[count_++] = {sample.value, sample.gradient, at};
  }
  void report(std::uint32_t number, std::vector<NearSample>& out) const {
    for (std::size_t i = 0; i < count_; ++i) out.push_back({number, sides_[i].at});
  }

 private:
  struct Side {
    double distance;
    Vec3 direction, at;
  };
  std::array<Side, kMostSides> sides_;
  std::size_t count_ = 0;
};

/// Of a run of samples above each other the ends and the middle.
unsigned thinned(unsigned run) {
  const int low = std::countr_zero(run), high = std::bit_width(run) - 1;
  return run & (1u << low | 1u << high | 1u << ((low + high) / 2));
}

}  // namespace

void addNearSamples(const PassTable& table, std::uint32_t number, const LeafColumns& leaf, int quarter,
                    std::vector<NearSample>& out) {
  const SweptField sweep = table.passes[number].body.field();
  const double reach = (kNearLevel + kNearUpright) * leaf.h;
  Sides sides;
  for (int c = quarter * kQuarter; c < (quarter + 1) * kQuarter; ++c) {
    const unsigned near = leaf.covered[c] & leaf.material[c];
    if (near == 0) continue;
    for (unsigned left = thinned(near); left != 0; left &= left - 1) {
      const Vec3 at(leaf.x[c], leaf.y[c], leaf.z[std::countr_zero(left)]);
      const SweepSample sample = sweep.sample(at);
      if (sample.value < -kContactToleranceMm) return;
      if (sample.value < reach) sides.add(sample, at);
    }
  }
  sides.report(number, out);
}

}  // namespace proveout
