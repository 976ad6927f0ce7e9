// Blanks.
#include <cmath>
#include <numbers>

#include "tests/soak/second/makers.h"

namespace proveout::soak::second {
namespace {

Solid boxAt(Dice& dice, const Spot& size) {
  Solid solid;
  for (int axis = 0; axis < 3; ++axis) solid.min[axis] = dice.oneIn(3) ? 0 : dice.mm(-15, 15);
  if (dice.oneIn(3)) solid.min.z() = -size.z();
  solid.max = solid.min + size;
  return solid;
}

Solid roundAt(Dice& dice, double radius, double length, int axis, double least_wall) {
  Solid solid;
  solid.shape = Solid::Shape::kRound;
  solid.axis = axis;
  for (int i = 0; i < 3; ++i) solid.base[i] = dice.mm(-10, 10);
  solid.radius = radius;
  solid.length = length;
  if (dice.oneIn(3) && radius > 2 * least_wall) solid.inner = dice.mm(0.3 * radius, radius - least_wall);
  return solid;
}

Spot asSaid(const Spot& p) { return (1e6 * p).array().round().matrix() * 1e-6; }

void addFan(const std::vector<int>& ring, std::vector<std::array<int, 3>>& faces) {
  for (std::size_t i = 2; i < ring.size(); ++i) faces.push_back({ring[0], ring[i - 1], ring[i]});
}

/// A frustum over a polygon, leant by any angle. Its ends are convex.
Solid frustum(Dice& dice, double radius, double height) {
  const int n = 3 + dice.below(5);
  const double top = dice.of({1.0, 1.0, 0.7, 1.25}), w0 = dice.multiple(0, 6, 0.01);
  const double lean = dice.oneIn(2) ? 0 : dice.multiple(0, 1.5, 0.01), spin = dice.multiple(0, 6, 0.01);
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(spin, Spot::UnitZ()) * Eigen::AngleAxisd(lean, Spot::UnitX())).matrix();
  const Spot middle(dice.mm(-10, 10), dice.mm(-10, 10), dice.mm(-10, 10));
  Solid solid;
  solid.shape = Solid::Shape::kMesh;
  std::vector<int> low, high;
  for (int level = 0; level < 2; ++level) {
    for (int i = 0; i < n; ++i) {
      const double w = w0 + 2 * std::numbers::pi * i / n, r = radius * (level == 0 ? 1 : top);
      (level == 0 ? low : high).push_back(static_cast<int>(solid.points.size()));
      solid.points.push_back(
          asSaid(middle + turn * Spot(r * std::cos(w), r * std::sin(w), (level - 0.5) * height)));
    }
  }
  addFan({low.rbegin(), low.rend()}, solid.faces);
  addFan(high, solid.faces);
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    solid.faces.push_back({low[static_cast<std::size_t>(i)], low[static_cast<std::size_t>(k)],
                           high[static_cast<std::size_t>(k)]});
    solid.faces.push_back({low[static_cast<std::size_t>(i)], high[static_cast<std::size_t>(k)],
                           high[static_cast<std::size_t>(i)]});
  }
  return solid;
}

}  // namespace

Box Solid::bounds() const {
  if (shape == Shape::kBox) return {min, max};
  Box box;
  for (const Spot& p : points) box.extend(p);
  if (shape == Shape::kMesh) return box;
  const Spot wide = Spot::Constant(radius) - radius * Spot::Unit(axis);
  return {base - wide, base + wide + length * Spot::Unit(axis)};
}

double Solid::volume() const {
  if (shape == Shape::kBox) return (max - min).prod();
  if (shape == Shape::kRound) return std::numbers::pi * (radius * radius - inner * inner) * length;
  double sum = 0;
  for (const auto& f : faces) {
    const auto point = [&](int i) {
      return points[static_cast<std::size_t>(f[static_cast<std::size_t>(i)])];
    };
    sum += point(0).dot(point(1).cross(point(2)));
  }
  return sum / 6;
}

Solid milledBlank(Dice& dice, double grid) {
  const double low = 6 * grid, high = 30 * grid;
  const int kind = dice.below(7);
  if (kind < 3) return boxAt(dice, {dice.mm(low, high), dice.mm(low, high), dice.mm(2.2 * grid, 16 * grid)});
  if (kind == 3)
    return roundAt(dice, dice.mm(3 * grid, 14 * grid), dice.mm(4 * grid, 14 * grid), 2, 2.1 * grid);
  if (kind == 4)
    return roundAt(dice, dice.mm(3 * grid, 8 * grid), dice.mm(8 * grid, 24 * grid), dice.below(2),
                   2.1 * grid);
  return frustum(dice, dice.mm(6 * grid, 14 * grid), dice.mm(5 * grid, 12 * grid));
}

Solid uprightBlank(Dice& dice, double grid) {
  const double low = 10 * grid, high = 36 * grid, height = dice.mm(3 * grid, 14 * grid);
  if (dice.below(3) < 2) return boxAt(dice, {dice.mm(low, high), dice.mm(low, high), height});
  return roundAt(dice, dice.mm(0.6 * low, 0.5 * high), height, 2, 2.1 * grid);
}

Solid barBlank(Dice& dice, double grid) {
  Solid bar = roundAt(dice, dice.mm(5 * grid, 16 * grid), dice.mm(8 * grid, 36 * grid), 2, 2.5 * grid);
  bar.base = {0, 0, -bar.length + dice.of({0.0, 0.0, 0.3, 1.0})};
  return bar;
}

}  // namespace proveout::soak::second
