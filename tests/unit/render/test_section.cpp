#include <gtest/gtest.h>

#include "render/render.h"
#include "render_fixtures.h"

namespace proveout {
namespace {

using test::boxMesh;
using test::colorDistance;
using test::pixel;

constexpr ImageSize kSize{320, 240};

Image render(const RenderScene& scene, const char* view, RenderOptions options = {}) {
  Progress progress;
  Result<Image> image = renderMesh(scene, *findView(view), kSize, options, progress);
  EXPECT_TRUE(image.ok()) << (image.ok() ? "" : image.error().message);
  return image.ok() ? std::move(image.value()) : Image{};
}

/// Colour of the picture where the point of the part lies in it.
std::array<int, 3> at(const Image& image, const RenderScene& scene, const char* view, const Vec3& p) {
  const Vec2 q = sceneCamera(scene, *findView(view), kSize).project(p);
  return pixel(image, static_cast<int>(q.x()), static_cast<int>(q.y()));
}

/// Cut faces are of the colour of sand, everything else in a picture without colours is grey.
bool isCutFace(const std::array<int, 3>& color) { return color[0] > color[2] + 30; }
bool isBackground(const std::array<int, 3>& color) {
  const Rgb sky = RenderOptions{}.background;
  return colorDistance(
             color, {static_cast<int>(std::lround(255 * sky[0])), static_cast<int>(std::lround(255 * sky[1])),
                     static_cast<int>(std::lround(255 * sky[2]))}) <= 1;
}

void append(TriMesh& mesh, const TriMesh& other, bool inward) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
  for (auto t : other.triangles) {
    if (inward) std::swap(t[1], t[2]);
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
}

TriMesh boxWithCavity() {
  TriMesh mesh = boxMesh({0, 0, 0}, {20, 20, 20});
  append(mesh, boxMesh({5, 5, 5}, {15, 15, 15}), true);
  return mesh;
}

/// Closed tube along z with `sides` facets.
TriMesh tubeMesh(double outer, double inner, double height, std::uint32_t sides) {
  TriMesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double a = 2 * kPi * i / sides;
    for (const Vec2& p : {Vec2(outer, 0), Vec2(outer, height), Vec2(inner, height), Vec2(inner, 0)}) {
      mesh.positions.push_back(Vec3(p.x() * std::cos(a), p.x() * std::sin(a), p.y()).cast<float>());
    }
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t a = 4 * i + k, b = 4 * j + k, c = 4 * j + (k + 1) % 4, d = 4 * i + (k + 1) % 4;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

TEST(Section, ShowsTheCavityAndTheCutFaces) {
  const TriMesh mesh = boxWithCavity();
  const RenderScene scene(mesh);
  const Image image = render(scene, "section");
  const Image whole = render(scene, "iso");
  for (const Vec3& p : {Vec3(17.5, 10, 10), Vec3(10, 2.5, 10), Vec3(12, 10, 2.5), Vec3(10, 8, 17.5)}) {
    EXPECT_TRUE(isCutFace(at(image, scene, "section", p))) << p.transpose();
    EXPECT_FALSE(isCutFace(at(whole, scene, "iso", p))) << p.transpose();
  }
  const auto floor = at(image, scene, "section", {12, 12, 5});  // of the cavity
  EXPECT_FALSE(isCutFace(floor));
  EXPECT_FALSE(isBackground(floor));
  for (const Vec3& p : {Vec3(5, 0, 10), Vec3(20, 17, 10), Vec3(4, 16, 20)}) {  // outside stays as it was
    EXPECT_LE(colorDistance(at(image, scene, "section", p), at(whole, scene, "iso", p)), 12) << p.transpose();
  }
}

/// The same part with the quarter really cut off, as a mesh: outline, walls and shadows must agree.
TEST(Section, AgreesWithAMeshThatIsCut) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 12});
  TriMesh cut;
  cut.positions = box.positions;  // the same bounds, so that both pictures have the same camera
  const Vec2 outline[] = {{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, 20}, {0, 20}};
  const auto first = static_cast<std::uint32_t>(cut.positions.size());
  for (const Vec2& p : outline) {
    cut.positions.push_back(Vec3(p.x(), p.y(), 0).cast<float>());
    cut.positions.push_back(Vec3(p.x(), p.y(), 12).cast<float>());
  }
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % 6);
    cut.triangles.push_back({a, b, b + 1});
    cut.triangles.push_back({a, b + 1, a + 1});
  }
  // Triangles from the inner corner (the third) see the whole outline.
  for (const auto& [i, j] : {std::pair(3u, 4u), {4u, 5u}, {5u, 0u}, {0u, 1u}}) {
    cut.triangles.push_back({first + 5, first + 2 * i + 1, first + 2 * j + 1});
    cut.triangles.push_back({first + 4, first + 2 * j, first + 2 * i});
  }
  const Image by_ray = render(RenderScene(box), "section"), by_mesh = render(RenderScene(cut), "iso");
  int compared = 0, different = 0, cut_faces = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const auto a = pixel(by_ray, x, y), b = pixel(by_mesh, x, y);
      cut_faces += isCutFace(a);
      if (a[0] > a[2] + 4) continue;  // on a cut face or at its edge
      ++compared;
      different += colorDistance(a, b) > 6;
    }
  }
  EXPECT_GT(compared, 40000);
  EXPECT_LT(different, 120);
  // Both cut faces are 10 x 12 mm, seen at an angle.
  const Camera camera = sceneCamera(RenderScene(box), *findView("section"), kSize);
  const double seen = 120 * (camera.back.x() - camera.back.y()) / (camera.mm_per_pixel * camera.mm_per_pixel);
  EXPECT_NEAR(cut_faces, seen, 0.04 * seen);
}

TEST(Section, TubeLosesAQuarterOfItsRing) {
  const TriMesh mesh = tubeMesh(10, 6, 30, 180);
  RenderScene scene(mesh);
  RenderOptions options;
  options.ground = false;
  scene.section = SectionCut{};
  const Image image = render(scene, "top", options);
  const Camera camera = sceneCamera(scene, *findView("top"), kSize);
  std::array<int, 4> covered{};  // by quarter
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      const Vec3 p = camera.unproject({x + 0.5, y + 0.5});
      const std::size_t quarter = (p.x() > 0 ? 1 : 0) + (p.y() > 0 ? 2 : 0);
      covered[quarter] += !isBackground(pixel(image, x, y));
    }
  }
  const double quarter = kPi * (100 - 36) / 4 / (camera.mm_per_pixel * camera.mm_per_pixel);
  for (const std::size_t kept : {0u, 2u, 3u}) EXPECT_NEAR(covered[kept], quarter, 0.03 * quarter) << kept;
  EXPECT_LT(covered[1], 0.03 * quarter);
}

TEST(Section, TubeShowsItsBoreBehindTheCutWall) {
  const TriMesh mesh = tubeMesh(10, 6, 30, 180);
  const RenderScene scene(mesh);
  const Image image = render(scene, "section");
  EXPECT_TRUE(isCutFace(at(image, scene, "section", {8, 0, 15})));
  EXPECT_TRUE(isCutFace(at(image, scene, "section", {0, -8, 15})));
  const auto bore = at(image, scene, "section", {-3.94, 4.52, 15});
  EXPECT_FALSE(isCutFace(bore));
  EXPECT_FALSE(isBackground(bore));
}

TEST(Section, DeviationsShowInIt) {
  const TriMesh mesh = tubeMesh(10, 6, 30, 90);
  RenderScene scene(mesh);
  scene.field.scale = {0.02, 0.05, 0.2};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    scene.field.values.push_back(i % 4 >= 2 ? -0.15F : 0.0F);  // the bore is too large
  const Image image = render(scene, "section");
  const auto bore = at(image, scene, "section", {-3.94, 4.52, 15});
  EXPECT_GT(bore[2], bore[0] + 50);
  const auto cut = at(image, scene, "section", {8, 0, 15});  // neutral: no colour of the scale
  EXPECT_LT(std::abs(cut[0] - cut[2]), 30);
}

TEST(Section, SameBytesForAnyThreadCount) {
  const TriMesh mesh = boxWithCavity();
  const RenderScene scene(mesh);
  RenderOptions options;
  options.threads = 1;
  const Image one = render(scene, "section", options);
  options.threads = 3;
  EXPECT_EQ(render(scene, "section", options).rgb, one.rgb);
}

/// A cut through vertices and along faces of the mesh: what ends in the cut is not drawn as if it went on.
TEST(Section, FacesInTheCutDoNoHarm) {
  TriMesh mesh = boxMesh({0, 0, 0}, {10, 10, 10});
  append(mesh, boxMesh({10, -10, 0}, {20, 0, 10}), false);  // fills the quarter exactly
  RenderScene scene(mesh);
  scene.section = SectionCut{Vec2(10, 0), 1, -1};
  const Image image = render(scene, "iso");
  int cut_faces = 0;
  for (int y = 0; y < kSize.height; ++y)
    for (int x = 0; x < kSize.width; ++x) cut_faces += isCutFace(pixel(image, x, y));
  EXPECT_EQ(cut_faces, 0);
  RenderScene whole(mesh);
  EXPECT_NE(image.rgb, render(whole, "iso").rgb);
}

TEST(Section, MarkerInWhatIsCutAwayIsHollow) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 20});
  RenderScene scene(box);
  const Vec3 place(16, 4, 20);
  scene.markers.push_back({place, "1", Severity::kError});
  EXPECT_GT(at(render(scene, "iso"), scene, "iso", place)[0],
            at(render(scene, "iso"), scene, "iso", place)[1] + 80);
  EXPECT_GT(at(render(scene, "section"), scene, "section", place)[1], 150);
}

TEST(Section, RefusesWhatIsNoQuarter) {
  const TriMesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  RenderScene scene(box);
  Progress progress;
  for (const SectionCut& cut :
       {SectionCut{Vec2(std::nan(""), 0)}, SectionCut{Vec2::Zero(), 0, 1}, SectionCut{Vec2::Zero(), 1, 2}}) {
    scene.section = cut;
    const Result<Image> image = renderMesh(scene, *findView("iso"), kSize, {}, progress);
    ASSERT_FALSE(image.ok());
    EXPECT_NE(image.error().message.find("section"), std::string::npos);
  }
}

}  // namespace
}  // namespace proveout
