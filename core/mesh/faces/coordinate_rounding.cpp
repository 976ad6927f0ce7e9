#include "core/mesh/faces/coordinate_rounding.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace proveout {
namespace rounding_detail {

/// So many coordinates are looked at, spread over the mesh.
constexpr std::size_t kMostLookedAt = 30'000;
constexpr double kUlp = 1.0 / (1 << 24);  // half a step of single precision, for a value of 1

std::vector<double> someCoordinates(const TriMesh& mesh) {
  std::vector<double> out;
  const std::size_t step = std::max<std::size_t>(1, 3 * mesh.positions.size() / kMostLookedAt);
  for (std::size_t i = 0; i < mesh.positions.size(); i += step)
    for (int k = 0; k < 3; ++k) out.push_back(mesh.positions[i][k]);
  return out;
}

/// Whether all values of each axis, in threes, are multiples of the grid apart, but for single precision: the
/// mesh may have been moved.
bool allOn(const std::vector<double>& values, double grid) {
  for (std::size_t i = 3; i < values.size(); ++i) {
    const double first = values[i % 3], off = values[i] - first;
    const double step = 3.0 * kUlp * (std::abs(values[i]) + std::abs(first)) + 1e-12;
    if (std::abs(off - grid * std::round(off / grid)) > step) return false;
  }
  return true;
}

/// Whether all values have no more than so many significant digits.
bool allShort(const std::vector<double>& values, int digits) {
  return std::all_of(values.begin(), values.end(), [digits](double v) {
    if (v == 0.0) return true;
    const double grid = std::pow(10.0, std::floor(std::log10(std::abs(v))) + 1 - digits);
    return std::abs(v - grid * std::round(v / grid)) <= 2.0 * kUlp * std::abs(v) + 1e-12;
  });
}

}  // namespace rounding_detail

double coordinateRounding(const TriMesh& mesh) {
  using namespace rounding_detail;
  constexpr double kInch = 25.4;
  constexpr int kFewestDecimals = 3, kMostDecimals = 6, kFewestDigits = 5, kMostDigits = 6;
  constexpr double kNotable = 8.0;  // a grid as fine as single precision itself is none
  const std::vector<double> values = someCoordinates(mesh);
  double size = 0.0;
  for (const auto& p : mesh.positions) size = std::max(size, static_cast<double>(p.cwiseAbs().maxCoeff()));
  const double own = kUlp * size;
  // A handful of points is on a grid by chance: a box has whole numbers.
  constexpr std::size_t kFewest = 100;
  if (values.size() < kFewest) return own;
  for (int decimals = kFewestDecimals; decimals <= kMostDecimals; ++decimals) {
    for (const double unit : {1.0, kInch}) {
      const double grid = unit * std::pow(10.0, -decimals);
      if (grid > kNotable * own && allOn(values, grid)) return std::max(own, 0.5 * grid);
    }
  }
  for (int digits = kFewestDigits; digits <= kMostDigits; ++digits)
    if (allShort(values, digits))
      return std::max(own, 0.5 * std::pow(10.0, std::floor(std::log10(size)) + 1 - digits));
  return own;
}

}  // namespace proveout
