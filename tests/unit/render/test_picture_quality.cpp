// Pictures against slow ones of many rays.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <ostream>
#include <vector>

#include "core/mesh/shells.h"
#include "render/render.h"
#include "render_fixtures.h"
#include "slow_picture.h"

namespace proveout {
namespace {

constexpr ImageSize kSize{800, 600};
constexpr int kStepX = 19, kStepY = 17;  ///< one pixel of 323 is looked at
constexpr int kReferenceRays = 144;

struct PictureCase {
  const char *name, *view;
  TriMesh mesh;
};
void PrintTo(const PictureCase& c, std::ostream* out) { *out << c.name << " " << c.view; }

TriMesh joined(TriMesh mesh, const TriMesh& more) {
  append(mesh, more);
  return mesh;
}

/// A thin wall and a pin on a plate, from which shadows fall over edges.
TriMesh plateWithWall() {
  const TriMesh plate = test::boxMesh({-20, -15, 0}, {20, 15, 4});
  return joined(joined(plate, test::boxMesh({-12, -8, 4}, {-11.2, 9, 13})), test::cylinderMesh(4, 12, 24));
}

/// A bush with grooves in its bore, whose flanks are two or three pixels wide and turn.
TriMesh groovedBush() {
  constexpr int kGrooves = 8;
  constexpr std::uint32_t kFacets = 48;
  constexpr double kHeight = 6.0, kInside = 7.0, kOutside = 10.0, kDepth = 0.3;
  std::vector<Vec2> outline{{kOutside, 0}, {kOutside, kHeight}};  // radius and height, counter-clockwise
  for (int i = 2 * kGrooves; i >= 0; --i)
    outline.emplace_back(kInside + (i % 2) * kDepth, kHeight * i / (2 * kGrooves));
  const auto n = static_cast<std::uint32_t>(outline.size());
  TriMesh mesh;
  for (std::uint32_t a = 0; a < kFacets; ++a) {
    for (const Vec2& p : outline)
      mesh.positions.push_back(
          (Eigen::AngleAxisd(2 * kPi * a / kFacets, Vec3::UnitZ()) * Vec3(p.x(), 0, p.y())).cast<float>());
  }
  for (std::uint32_t a = 0; a < kFacets; ++a) {
    const std::uint32_t from = n * a, to = n * ((a + 1) % kFacets);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      mesh.triangles.push_back({from + i, to + i, to + j});
      mesh.triangles.push_back({from + i, to + j, from + j});
    }
  }
  return mesh;
}

/// A box without its lid: its inside is seen.
TriMesh openBox() {
  TriMesh mesh = test::boxMesh({0, 0, 0}, {20, 14, 8});
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](auto v) { return mesh.positions[v].z() > 7.0F; });
  });
  return mesh;
}

TriMesh oneTriangle() {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 1}, {2, 8, 3}};
  mesh.triangles = {{0, 1, 2}};
  return mesh;
}

TriMesh scaled(TriMesh mesh, float factor, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& p : mesh.positions) p = p * factor + by;
  return mesh;
}

std::vector<PictureCase> cases() {
  const TriMesh stairs = test::stairMesh(25);
  return {{"Stairs", "iso", stairs},
          {"Stairs", "top", stairs},
          {"Plate", "iso", plateWithWall()},
          {"Plate", "iso-left", plateWithWall()},
          {"Cylinder", "iso", test::cylinderMesh(10, 25, 48)},
          {"OpenBox", "iso", openBox()},
          {"OpenBox", "iso-below", openBox()},
          {"Triangle", "iso", oneTriangle()},
          {"HugeStairs", "iso", scaled(stairs, 1e3F, {5e3F, 0.0F, -7e3F})}};
}

struct Differences {
  double mean = 0.0;
  int of_100 = 0, worst = 0;  ///< one of 100 pixels is off by more
};

Differences differencesOf(const Image& image, const std::vector<test::SlowPixel>& reference) {
  std::vector<int> each;
  Differences out;
  for (const test::SlowPixel& p : reference) {
    each.push_back(test::colorDistance(test::pixel(image, p.x, p.y), p.color));
    out.mean += each.back();
  }
  std::sort(each.begin(), each.end());
  out.mean /= static_cast<double>(each.size());
  out.of_100 = each[each.size() * 99 / 100];
  out.worst = each.back();
  return out;
}

class PictureQuality : public testing::TestWithParam<PictureCase> {};

TEST_P(PictureQuality, LooksLikeManyRays) {
  const PictureCase& c = GetParam();
  const RenderScene scene(c.mesh);
  const View view = *findView(c.view);
  Progress progress;
  const Result<Image> image = renderMesh(scene, view, kSize, {}, progress);
  ASSERT_TRUE(image.ok()) << image.error().message;
  const Differences off =
      differencesOf(*image, test::slowPixels(scene, view, kSize, kStepX, kStepY, kReferenceRays));
  std::printf("%-10s %-9s mean %.2f, one of 100 %d, worst %d of 255\n", c.name, c.view, off.mean, off.of_100,
              off.worst);
  EXPECT_LE(off.mean, 1.5);
  EXPECT_LE(off.of_100, 10);
  EXPECT_LE(off.worst, 40);
}

INSTANTIATE_TEST_SUITE_P(Meshes, PictureQuality, testing::ValuesIn(cases()), [](const auto& test) {
  std::string name = std::string(test.param.name) + "_" + test.param.view;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

/// Green of the darkest pixel within `reach` pixels of (x, y).
int darkestAround(const Image& image, int x, int y, int reach) {
  int darkest = 255;
  for (int v = std::max(0, y - reach); v <= std::min(image.height - 1, y + reach); ++v) {
    for (int u = std::max(0, x - reach); u <= std::min(image.width - 1, x + reach); ++u)
      darkest = std::min(darkest, test::pixel(image, u, v)[1]);
  }
  return darkest;
}

TEST(PictureQualityOf, NarrowFacesIsWithoutBlackDashes) {
  // Their points of the light's grid have few neighbours of their kind. In a picture of five times the size
  // they have enough: nothing is to be darker than all that is there around it.
  constexpr int kFactor = 5, kReach = 2, kTones = 8;
  constexpr ImageSize kOwn{640, 480}, kLarge{kFactor * kOwn.width, kFactor * kOwn.height};
  const TriMesh mesh = groovedBush();
  const RenderScene scene(mesh);
  Progress progress;
  const Result<Image> image = renderMesh(scene, *findView("iso"), kOwn, {}, progress);
  const Result<Image> large = renderMesh(scene, *findView("iso"), kLarge, {}, progress);
  ASSERT_TRUE(image.ok() && large.ok());
  int dashes = 0;
  for (int y = 0; y < kOwn.height; ++y) {
    for (int x = 0; x < kOwn.width; ++x) {
      const int darkest =
          darkestAround(*large, kFactor * x + kFactor / 2, kFactor * y + kFactor / 2, kReach * kFactor);
      dashes += test::pixel(*image, x, y)[1] + kTones < darkest ? 1 : 0;
    }
  }
  EXPECT_EQ(dashes, 0);
}

}  // namespace
}  // namespace proveout
