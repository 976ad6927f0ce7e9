#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "render/render.h"
#include "render/shading_normals.h"
#include "render_fixtures.h"

namespace proveout {
namespace {

using test::boxMesh;
using test::colorDistance;
using test::pixel;

constexpr ImageSize kSmall{160, 120};

Image render(const RenderScene& scene, const char* view, ImageSize size = kSmall,
             RenderOptions options = {}) {
  Progress progress;
  Result<Image> image = renderMesh(scene, *findView(view), size, options, progress);
  EXPECT_TRUE(image.ok()) << (image.ok() ? "" : image.error().message);
  return image.ok() ? std::move(image.value()) : Image{};
}

std::string failure(const RenderScene& scene, ImageSize size = kSmall, RenderOptions options = {}) {
  Progress progress;
  const Result<Image> image = renderMesh(scene, *findView("iso"), size, options, progress);
  return image.ok() ? "" : image.error().message;
}

std::array<int, 3> backgroundBytes() {
  const Rgb color = RenderOptions{}.background;
  return {static_cast<int>(std::lround(color[0] * 255)), static_cast<int>(std::lround(color[1] * 255)),
          static_cast<int>(std::lround(color[2] * 255))};
}

TEST(Render, BoxFromTopFillsItsRectangle) {
  const TriMesh box = boxMesh({-3, 7, 0}, {37, 27, 5});
  const RenderScene scene(box);
  RenderOptions options;
  options.ground = false;
  const Image image = render(scene, "top", kSmall, options);
  const Camera camera = sceneCamera(scene, *findView("top"), kSmall);
  const Vec2 a = camera.project({-3, 27, 5}), b = camera.project({37, 7, 5});
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const bool inside = x >= a.x() && x + 1 <= b.x() && y >= a.y() && y + 1 <= b.y();
      const bool outside = x + 1 <= a.x() || x >= b.x() || y + 1 <= a.y() || y >= b.y();
      const bool is_background = colorDistance(pixel(image, x, y), backgroundBytes()) <= 1;
      if (inside) {
        ASSERT_FALSE(is_background) << x << "," << y;
      }
      if (outside) {
        ASSERT_TRUE(is_background) << x << "," << y;
      }
    }
  }
}

TEST(Render, FacesAreEvenAndTellApart) {
  const TriMesh box = boxMesh({0, 0, 0}, {10, 10, 10});
  const RenderScene scene(box);
  const Image image = render(scene, "iso", {320, 240});
  const Camera camera = sceneCamera(scene, *findView("iso"), {320, 240});
  const auto at = [&](const Vec3& p) {
    const Vec2 q = camera.project(p);
    return pixel(image, static_cast<int>(q.x()), static_cast<int>(q.y()));
  };
  EXPECT_LE(colorDistance(at({3, 3, 10}), at({7, 7, 10})), 2);  // one face, one tone
  EXPECT_GE(colorDistance(at({5, 5, 10}), at({5, 0, 5})), 15);
  EXPECT_GE(colorDistance(at({5, 0, 5}), at({10, 5, 5})), 15);
}

TEST(Render, PictureDoesNotDependOnPlaceOrScale) {
  const TriMesh here = boxMesh({0, 0, 0}, {40, 20, 5});
  const TriMesh far = boxMesh({4000, -9000, 100}, {4040, -8980, 105});
  const TriMesh large = boxMesh({0, 0, 0}, {40000, 20000, 5000});
  const Image base = render(RenderScene(here), "iso");
  for (const TriMesh* other : {&far, &large}) {
    const Image image = render(RenderScene(*other), "iso");
    std::size_t different = 0;
    for (int y = 0; y < base.height; ++y) {
      for (int x = 0; x < base.width; ++x)
        different += colorDistance(pixel(base, x, y), pixel(image, x, y)) > 12;
    }
    EXPECT_LT(different, 40u);
  }
}

TEST(Render, MirroredPartGivesMirroredOutline) {
  TriMesh mesh = boxMesh({-20, -10, 0}, {20, 10, 5});
  const TriMesh tower = boxMesh({-18, -8, 5}, {-8, 2, 15});
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), tower.positions.begin(), tower.positions.end());
  for (auto t : tower.triangles) mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  TriMesh mirrored = mesh;
  for (auto& p : mirrored.positions) p.x() = -p.x();
  for (auto& t : mirrored.triangles) std::swap(t[1], t[2]);
  RenderOptions options;
  options.ground = false;
  const Image a = render(RenderScene(mesh), "front", kSmall, options);
  const Image b = render(RenderScene(mirrored), "front", kSmall, options);
  std::size_t different = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const bool in_a = colorDistance(pixel(a, x, y), backgroundBytes()) > 1;
      const bool in_b = colorDistance(pixel(b, a.width - 1 - x, y), backgroundBytes()) > 1;
      different += in_a != in_b;
    }
  }
  EXPECT_LE(different, 60u);  // pixels that an edge crosses
}

TEST(Render, SameBytesForAnyThreadCount) {
  TriMesh mesh = test::cylinderMesh(20, 15, 90);
  RenderScene scene(mesh);
  scene.field.values.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    scene.field.values[i] = 0.01F * mesh.positions[i].x();
  scene.field.scale = {0.02, 0.05, 0.2};
  scene.show_legend = true;
  scene.legend.title = "deviation";
  scene.markers.push_back({{20, 0, 8}, "1", Severity::kError});
  scene.caption = "cylinder";
  RenderOptions options;
  options.threads = 1;
  const Image one = render(scene, "iso", {320, 240}, options);
  for (const int threads : {2, 4}) {
    options.threads = threads;
    EXPECT_EQ(render(scene, "iso", {320, 240}, options).rgb, one.rgb) << threads;
  }
}

TEST(Render, GroundShadowDarkensBesideThePartOnly) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 20});
  const Image image = render(RenderScene(box), "top", {400, 120});
  const auto darkest = [&](int x) {
    int least = 255;
    for (int y = 0; y < image.height; ++y) least = std::min(least, pixel(image, x, y)[0]);
    return least;
  };
  const Camera camera = sceneCamera(RenderScene(box), *findView("top"), {400, 120});
  const int beside = static_cast<int>(camera.project({20, 10, 0}).x()) + 3;
  EXPECT_LT(darkest(beside), backgroundBytes()[0] - 15);
  EXPECT_GE(darkest(1), backgroundBytes()[0] - 3);
}

TEST(Render, InnerEdgesAreNoDarkerThanWhatIsBesideThem) {
  const TriMesh stairs = test::stairMesh(25);
  ASSERT_TRUE(analyseTopology(stairs).closedManifold());
  const Image image = render(RenderScene(stairs), "iso", {640, 480});
  for (int y = 2; y + 2 < image.height; ++y) {
    for (int x = 2; x + 2 < image.width; ++x) {
      // Between the lightest and the darkest of its neighbourhood, as far as noise goes.
      int least = 255;
      for (int v = -2; v <= 2; ++v) {
        for (int u = -2; u <= 2; ++u) {
          if (std::max(std::abs(u), std::abs(v)) == 2) least = std::min(least, pixel(image, x + u, y + v)[1]);
        }
      }
      ASSERT_GE(pixel(image, x, y)[1], least - 12) << x << "," << y;
    }
  }
}

/// Whether tones change as steps at an edge do, near (x, y) in its row.
bool nearEdge(const Image& image, int x, int y) {
  for (int u = x - 3; u < x + 3; ++u) {
    if (std::abs(pixel(image, u + 1, y)[1] - pixel(image, u, y)[1]) > 14) return true;
  }
  return false;
}

TEST(Render, FlatFacesAreWithoutNoise) {
  // In the half shadow of the stairs tones change, but not to and fro.
  const Image image = render(RenderScene(test::stairMesh(25)), "top", {640, 480});
  int rough = 0, part = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 3; x + 3 < image.width; ++x) {
      const auto bend = [&](int at) {
        return pixel(image, at - 1, y)[1] + pixel(image, at + 1, y)[1] - 2 * pixel(image, at, y)[1];
      };
      part += pixel(image, x, y)[1] < 235;
      rough += std::abs(bend(x)) > 4 && bend(x) * bend(x + 1) < 0 && !nearEdge(image, x, y);
    }
  }
  EXPECT_GT(part, 20000);
  EXPECT_LT(rough, part / 200);
}

TEST(Render, PicturesOfOneMeshShareWhatIsKnownOfIt) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 5});
  RenderScene alone(box), shared(box);
  const auto drawn = prepareDrawing(box, 1);
  ASSERT_TRUE(drawn.ok());
  shared.drawn = *drawn;
  for (const char* view : {"iso", "section", "top"})
    EXPECT_EQ(render(shared, view).rgb, render(alone, view).rgb) << view;
  EXPECT_FALSE(prepareDrawing(TriMesh{}, 1).ok());
}

TEST(Render, HeatMapShowsTheScale) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 5});
  RenderScene scene(box);
  scene.field.per = ScalarField::Per::kTriangle;
  scene.field.scale = {0.02, 0.05, 0.2};
  scene.field.values.assign(box.triangles.size(), -0.1F);
  const auto middle = [&] {
    const Image image = render(scene, "top");
    return pixel(image, image.width / 2 - 8, image.height / 2);
  };
  const auto gouge = middle();
  EXPECT_GT(gouge[2], gouge[0] + 50);
  scene.field.values.assign(box.triangles.size(), 0.1F);
  const auto excess = middle();
  EXPECT_GT(excess[0], excess[2] + 50);
  scene.field.values.assign(box.triangles.size(), 0.0F);
  const auto good = middle();
  EXPECT_LT(good[0] - good[2], 12);
  EXPECT_GT(good[0], 180);
  scene.field.values.assign(box.triangles.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_LT(middle()[0], good[0] - 60);
}

TEST(Render, HeatMapColoursThePointThatIsSeen) {
  // One corner of the top is off: between the vertices of its two triangles colours are not smeared.
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 5});
  RenderScene scene(box);
  scene.field.scale = {0.02, 0.05, 0.2};
  scene.field.values.assign(box.positions.size(), 0.0F);
  const auto off = [](const Vec3& p) { return p.x() > 15 && p.y() > 15 && p.z() > 4.9; };
  for (std::size_t i = 0; i < box.positions.size(); ++i) {
    if (off(box.positions[i].cast<double>())) scene.field.values[i] = 0.1F;
  }
  // Of the left half of the picture and its middle: the legend stands on the right.
  const auto reds = [&] {
    const Image image = render(scene, "top");
    int count = 0;
    for (int x = 0; x < image.width * 3 / 4; ++x) {
      for (int y = 0; y < image.height; ++y) count += pixel(image, x, y)[0] - pixel(image, x, y)[2] > 20;
    }
    return count;
  };
  const int smeared = reds();
  scene.field.at = [&](const Vec3& p) { return off(p) ? 0.1F : 0.0F; };
  scene.field.largest_mm = 1.0;
  const int seen = reds();
  EXPECT_GT(seen, 0);
  EXPECT_GT(smeared, 3 * seen);  // a sixteenth of the top, and what linear colours make of it
}

TEST(Render, LegendShowsTheFullColours) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 5});
  RenderScene scene(box);
  scene.field.scale = {0.02, 0.05, 0.2};
  scene.field.values.assign(box.positions.size(), 0.0F);
  scene.show_legend = true;
  const Image image = render(scene, "top", {480, 360});
  const Rgb deepest = deviationColor(scene.field.scale, -0.199);
  const std::array<int, 3> wanted = {static_cast<int>(255 * deepest[0]), static_cast<int>(255 * deepest[1]),
                                     static_cast<int>(255 * deepest[2])};
  int found = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = image.width / 2; x < image.width; ++x)
      found += colorDistance(pixel(image, x, y), wanted) <= 4;
  }
  EXPECT_GE(found, 5);
}

TEST(Render, MarkerAppearsWhereItsPointProjects) {
  const TriMesh box = boxMesh({0, 0, 0}, {40, 30, 5});
  RenderScene scene(box);
  const Vec3 place(10, 20, 5);
  const Image plain = render(scene, "top", {480, 360});
  scene.markers.push_back({place, "7", Severity::kError});
  const Image marked = render(scene, "top", {480, 360});
  const Vec2 q = sceneCamera(scene, *findView("top"), {480, 360}).project(place);
  const auto dot = pixel(marked, static_cast<int>(q.x()), static_cast<int>(q.y()));
  EXPECT_GT(dot[0], dot[1] + 80);
  int changed = 0, far_off = 0;
  for (int y = 0; y < plain.height; ++y) {
    for (int x = 0; x < plain.width; ++x) {
      if (pixel(plain, x, y) == pixel(marked, x, y)) continue;
      ++changed;
      far_off += (Vec2(x, y) - q).norm() > 60;
    }
  }
  EXPECT_GT(changed, 80);
  EXPECT_EQ(far_off, 0);
}

TEST(Render, AnnotationsOverAPartAreThoseOfTheWholePicture) {
  constexpr ImageSize kDrawn{480, 360};
  const TriMesh box = boxMesh({0, 0, 0}, {40, 30, 25});
  for (const char* name : {"iso", "section"}) {
    RenderScene bare(box);
    bare.caption_room = true;
    Progress progress;
    Result<Image> image = renderPart(bare, *findView(name), kDrawn, {}, progress);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->rgb, render(bare, name, kDrawn).rgb) << "nothing to draw over it";
    RenderScene scene(box);
    scene.markers = {{{10, 20, 25}, "1", Severity::kError}, {{20, 15, 0}, "2", Severity::kNote}};
    scene.caption = "two findings";
    ASSERT_TRUE(annotate(scene, *findView(name), *image).ok());
    EXPECT_EQ(image->rgb, render(scene, name, kDrawn).rgb) << name;
    EXPECT_NE(image->rgb, render(RenderScene(box), name, kDrawn).rgb);
  }
}

TEST(Render, HiddenMarkerIsHollow) {
  const TriMesh box = boxMesh({0, 0, 0}, {40, 30, 5});
  RenderScene scene(box);
  scene.markers.push_back({{10, 20, 0}, "1", Severity::kError});
  const Image image = render(scene, "top", {960, 720});
  const Vec2 q = sceneCamera(scene, *findView("top"), {960, 720}).project({10, 20, 0});
  EXPECT_GT(pixel(image, static_cast<int>(q.x()), static_cast<int>(q.y()))[1], 200);
}

TEST(Render, CreaseNormalsSmoothCurvesAndKeepEdges) {
  const TriMesh mesh = test::cylinderMesh(10, 10, 36);
  const auto faces = render_detail::faceNormals(mesh);
  const auto corners = render_detail::cornerNormals(mesh, faces);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3f& p = mesh.positions[mesh.triangles[t][c]];
      const bool wall = std::abs(faces[t].z()) < 0.5F;
      const Eigen::Vector3f radial = Eigen::Vector3f(p.x(), p.y(), 0).normalized();
      const Eigen::Vector3f expected = wall ? radial : faces[t];
      // The two triangles of a facet weigh differently at its ends: a fifth of the facets' 10 degrees.
      EXPECT_GT(corners[t][c].dot(expected), std::cos(degToRad(2.0))) << t << " " << c;
    }
  }
}

TEST(Render, TintColoursItsTriangles) {
  const TriMesh box = boxMesh({0, 0, 0}, {20, 20, 5});
  RenderScene scene(box);
  scene.triangle_colors.assign(box.triangles.size(), Rgb{0.9F, 0.2F, 0.2F});
  const Image image = render(scene, "top");
  const auto middle = pixel(image, image.width / 2, image.height / 2);
  EXPECT_GT(middle[0], middle[1] + 60);
}

TEST(Render, RefusesWhatItCannotDraw) {
  const TriMesh empty;
  EXPECT_NE(failure(RenderScene(empty)).find("no triangles"), std::string::npos);
  TriMesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  EXPECT_NE(failure(RenderScene(box), {15, 100}).find("out of range"), std::string::npos);
  EXPECT_NE(failure(RenderScene(box), {100, 9000}).find("out of range"), std::string::npos);
  RenderOptions options;
  options.samples = 0;
  EXPECT_NE(failure(RenderScene(box), kSmall, options).find("samples"), std::string::npos);

  RenderScene scene(box);
  scene.show_legend = true;
  EXPECT_NE(failure(scene).find("legend needs"), std::string::npos);
  scene.field.values.assign(5, 0.0F);
  EXPECT_NE(failure(scene).find("5 values for 8 vertices"), std::string::npos);
  scene.field.values.assign(8, 0.0F);
  EXPECT_NE(failure(scene, {100, 100}).find("160x120"), std::string::npos);
  scene.field.scale.limit = 0.01;
  EXPECT_NE(failure(scene).find("limit above"), std::string::npos);
  scene.field = {};
  scene.show_legend = false;
  scene.triangle_colors.resize(3);
  EXPECT_NE(failure(scene).find("3 colours for 12"), std::string::npos);
  scene.triangle_colors.clear();
  scene.markers.push_back({Vec3(0, std::nan(""), 0), "1", Severity::kError});
  EXPECT_NE(failure(scene).find("not a finite"), std::string::npos);

  box.triangles[3][1] = 8;
  EXPECT_NE(failure(RenderScene(box)).find("index out of range"), std::string::npos);
  box.triangles[3][1] = 0;
  box.positions[2].y() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(failure(RenderScene(box)).find("not a finite"), std::string::npos);
}

TEST(Render, DegenerateTrianglesDoNoHarm) {
  TriMesh flat;
  flat.positions.assign(3, Eigen::Vector3f(1, 2, 3));
  flat.triangles.push_back({0, 1, 2});
  const Image image = render(RenderScene(flat), "iso");
  EXPECT_EQ(image.rgb.size(), 160u * 120u * 3u);
}

TEST(Render, StopsWhenCancelled) {
  const TriMesh box = boxMesh({0, 0, 0}, {1, 1, 1});
  Progress progress;
  progress.cancel();
  const Result<Image> image = renderMesh(RenderScene(box), *findView("iso"), kSmall, {}, progress);
  ASSERT_FALSE(image.ok());
  EXPECT_EQ(image.error().kind, ErrorKind::kInterrupted);
}

TEST(CloseUp, ShowsThePlaceInTheMiddle) {
  TriMesh box;
  box.positions = {{0, 0, 0}, {100, 0, 0}, {100, 80, 0}, {0, 80, 0}};
  box.triangles = {{0, 1, 2}, {0, 2, 3}};
  RenderScene scene(box);
  scene.focus = RenderScene::Focus{Vec3(70, 20, 0), 10.0};
  const ImageSize size{480, 320};
  const Camera near = sceneCamera(scene, *findView("top"), size);
  const Vec2 a = near.project(Vec3(70, 20, 0)), b = near.project(Vec3(75, 20, 0));
  EXPECT_NEAR(a.x(), 240.0, 20.0);
  EXPECT_NEAR(a.y(), 160.0, 20.0);
  EXPECT_GT(b.x() - a.x(), 180.0);  // 10 mm fill the width
  scene.focus->width_mm = 1e9;      // never smaller than the whole part
  EXPECT_EQ(sceneCamera(scene, *findView("top"), size).mm_per_pixel,
            sceneCamera(RenderScene(box), *findView("top"), size).mm_per_pixel);
}

}  // namespace
}  // namespace proveout
