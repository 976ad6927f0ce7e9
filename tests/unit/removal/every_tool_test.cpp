// Every tool shape along level, plunging and slanted moves: removed volume against the integral of the tool's
// lower envelope.
#include <cmath>
#include <functional>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

constexpr double kGrid = 0.25;
const BoxShape kBlank{{-30, -15, -20}, {30, 15, 0}};

enum class Move { kLevel, kPlunge, kSlanted };

struct ToolCase {
  const char* option;
  double radius;
  std::function<double(double)>
      lower;                ///< height of the tool's lower side at radius r, from the drawing of its type
  double curvature_radius;  ///< least radius of its round surfaces, mm
};

const double kTan30 = std::tan(degToRad(30)), kTan59 = std::tan(degToRad(59));

const ToolCase kTools[] = {
    {"1=flat:6", 3, [](double) { return 0.0; }, 3},
    {"1=ball:6", 3, [](double r) { return 3 - std::sqrt(std::max(0.0, 9 - r * r)); }, 3},
    {"1=bull:8:1.5", 4,
     [](double r) {
       const double over = std::max(0.0, r - 2.5);
       return 1.5 - std::sqrt(std::max(0.0, 2.25 - over * over));
     },
     1.5},
    {"1=cone:8:1:60", 4, [](double r) { return std::max(0.0, r - 0.5) / kTan30; }, 0.5},
    {"1=drill:6:118", 3, [](double r) { return r / kTan59; }, 1.5},
};

struct MoveData {
  Vec3 from, to;
};

MoveData moveData(Move move) {
  switch (move) {
    case Move::kLevel:
      return {{-10.2, 1.3, -6.1}, {12.1, 1.3, -6.1}};
    case Move::kPlunge:
      return {{2.2, 1.3, 2}, {2.2, 1.3, -9.1}};
    case Move::kSlanted:
      return {{-10.2, 1.3, -2.1}, {12.1, 1.3, -9.1}};
  }
  return {};
}

/// Volume below z = 0: in each slice the lowest position at every x, by a search on a convex function.
double expectedVolume(const ToolCase& tool, const MoveData& m) {
  const double length = m.to.x() - m.from.x(), fall = m.to.z() - m.from.z(), R = tool.radius;
  const int slices = 240, columns = 500;
  double volume = 0.0;
  for (int i = 0; i < slices; ++i) {
    const double angle = kPi * ((i + 0.5) / slices - 0.5);  // y = R sin: no steep ends
    const double y = R * std::sin(angle), w = R * std::cos(angle);
    const double dy = R * std::cos(angle) * kPi / slices, dx = (length + 2 * w) / columns;
    for (int j = 0; j < columns; ++j) {
      const double x = -w + (j + 0.5) * dx;
      const auto height = [&](double s) {
        const double t = length > 0 ? s / length : 1.0;
        return m.from.z() + fall * t + tool.lower(std::sqrt(std::min(R * R, y * y + (x - s) * (x - s))));
      };
      double low = std::max(0.0, x - w), high = std::min(length, x + w);
      for (int k = 0; k < 40 && length > 0; ++k) {
        const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
        (height(a) < height(b) ? high : low) = height(a) < height(b) ? b : a;
      }
      volume += dx * dy * std::max(0.0, -std::min({height(low), height(high), height(0.5 * (low + high))}));
    }
  }
  return volume;
}

class EveryTool : public ::testing::TestWithParam<std::tuple<int, Move>> {};

TEST_P(EveryTool, RemovesItsSweptVolume) {
  const ToolCase& shape = kTools[std::get<0>(GetParam())];
  const MoveData m = moveData(std::get<1>(GetParam()));
  const Cut c = cut(kBlank, PathMaker().line(m.from, m.to).path(), {tool(shape.option)}, kGrid);
  const double expected = expectedVolume(shape, m);
  // Faceting: chords of the grid lie h^2 / 8r off a round surface of radius r, here at most the whole swept
  // surface.
  const double path = (m.to - m.from).head<2>().norm();
  const double area = (2 * path + 2 * kPi * shape.radius) * (shape.radius + 9.1);
  const double faceting = area * kGrid * kGrid / (8 * shape.curvature_radius) / 3;
  EXPECT_NEAR(c.initial - c.mesh_volume, expected, 5e-4 * expected + faceting);
  EXPECT_NEAR(c.initial - c.volume, expected, 1.5e-4 * expected);
  RecordProperty("facets_relative_error", std::to_string((c.initial - c.mesh_volume) / expected - 1));
  RecordProperty("integrated_relative_error", std::to_string((c.initial - c.volume) / expected - 1));
}

std::string caseName(const ::testing::TestParamInfo<std::tuple<int, Move>>& param) {
  const char* const shapes[] = {"Flat", "Ball", "Bull", "Cone", "Drill"};
  const char* const moves[] = {"Level", "Plunge", "Slanted"};
  return std::string(shapes[std::get<0>(param.param)]) + moves[static_cast<int>(std::get<1>(param.param))];
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryTool,
                         ::testing::Combine(::testing::Range(0, 5),
                                            ::testing::Values(Move::kLevel, Move::kPlunge, Move::kSlanted)),
                         caseName);

}  // namespace
}  // namespace proveout::test
