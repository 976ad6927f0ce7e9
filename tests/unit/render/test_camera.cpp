#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "render/camera.h"
#include "render_fixtures.h"

namespace proveout {
namespace {

TEST(Views, FramesAreRightHandedAndNamesUnique) {
  std::vector<std::string> names = viewNames();
  for (const std::string& name : names) {
    const Result<View> view = findView(name);
    ASSERT_TRUE(view.ok()) << name;
    EXPECT_NEAR(view->back.norm(), 1.0, 1e-12);
    EXPECT_NEAR(view->up.norm(), 1.0, 1e-12);
    EXPECT_NEAR(view->back.dot(view->up), 0.0, 1e-12);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

/// As on a drawing: the axis level, the chuck (-Z) left, +X up.
TEST(Views, TurnedPartsLieLevel) {
  for (const std::string& name : viewNames()) {
    const Result<View> view = findTurnedView(name);
    ASSERT_TRUE(view.ok()) << name;
    EXPECT_EQ(view->section, name == "section");
    EXPECT_NEAR(view->back.norm(), 1.0, 1e-12);
    EXPECT_NEAR(view->up.norm(), 1.0, 1e-12);
    EXPECT_NEAR(view->back.dot(view->up), 0.0, 1e-12);
    const Vec3 right = view->up.cross(view->back);
    if (name == "left" || name == "right") {  // along the axis
      EXPECT_NEAR(view->back.z(), name == "right" ? 1.0 : -1.0, 1e-12);
      EXPECT_NEAR(view->up.x(), 1.0, 1e-12);
      continue;
    }
    EXPECT_NEAR(view->up.z(), 0.0, 1e-12) << name;
    const bool behind = name == "back" || name == "iso-back";
    EXPECT_GT((behind ? -1.0 : 1.0) * right.z(), 0.5) << name;
    if (name != "top" && name != "bottom") {
      EXPECT_GT(view->up.x(), 0.5) << name;
    }
  }
  const Result<View> front = findTurnedView("front");
  EXPECT_NEAR((front->back - Vec3::UnitY()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((front->up - Vec3::UnitX()).norm(), 0.0, 1e-12);
  EXPECT_FALSE(findTurnedView("Iso").ok());
}

TEST(Views, UnknownNameListsTheKnownOnes) {
  const Result<View> view = findView("Iso");
  ASSERT_FALSE(view.ok());
  EXPECT_EQ(view.error().kind, ErrorKind::kInput);
  for (const std::string& name : viewNames()) EXPECT_NE(view.error().message.find(name), std::string::npos);
}

TEST(ImageSize, ParsesAndRefuses) {
  const Result<ImageSize> good = parseImageSize("640x480");
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good->width, 640);
  EXPECT_EQ(good->height, 480);
  EXPECT_TRUE(parseImageSize("16x8192").ok());
  for (const char* bad : {"", "x", "640", "640x", "x480", "640X480", "640x480x3", "15x16", "16x8193",
                          "-16x16", "1e3x100", " 640x480", "640x480 ", "99999999999x16"}) {
    EXPECT_FALSE(parseImageSize(bad).ok()) << bad;
  }
}

TEST(Camera, FitsTheBoundsCentred) {
  const TriMesh box = test::boxMesh({10, 20, 30}, {50, 40, 35});
  const Camera top = fitCamera(box, *findView("top"), {100, 50, 500, 350});
  EXPECT_NEAR(top.mm_per_pixel, 0.1, 1e-6);  // 40 mm on 400 pixels
  const Vec2 corner = top.project({10, 40, 35});
  EXPECT_NEAR(corner.x(), 100, 1e-4);
  EXPECT_NEAR(corner.y(), 100, 1e-4);  // 200 pixels high, centred in 300
  const Vec2 opposite = top.project({50, 20, 30});
  EXPECT_NEAR(opposite.x(), 500, 1e-4);
  EXPECT_NEAR(opposite.y(), 300, 1e-4);
}

TEST(Camera, ViewsLookFromTheirSide) {
  const TriMesh box = test::boxMesh({0, 0, 0}, {10, 20, 30});
  const PixelRect rect{0, 0, 300, 300};
  const Vec2 right_of_front = fitCamera(box, *findView("front"), rect).project({10, 0, 30});
  EXPECT_GT(right_of_front.x(), 150);  // +x to the right
  EXPECT_LT(right_of_front.y(), 150);  // +z up
  EXPECT_LT(fitCamera(box, *findView("back"), rect).project({10, 0, 30}).x(), 150);
  EXPECT_LT(fitCamera(box, *findView("bottom"), rect).project({10, 0, 0}).x(), 150);
  EXPECT_GT(fitCamera(box, *findView("right"), rect).project({10, 20, 0}).x(), 150);
}

TEST(Camera, UnprojectInvertsProject) {
  const TriMesh box = test::boxMesh({0, 0, 0}, {10, 20, 30});
  const Camera camera = fitCamera(box, *findView("iso-back"), {0, 0, 640, 480});
  const Vec2 pixel(123.25, 45.5);
  EXPECT_LT((camera.project(camera.unproject(pixel)) - pixel).norm(), 1e-9);
}

TEST(Camera, KeepsAScaleForAPoint) {
  TriMesh point;
  point.positions.assign(3, Eigen::Vector3f(1, 2, 3));
  point.triangles.push_back({0, 1, 2});
  const Camera camera = fitCamera(point, *findView("iso"), {0, 0, 100, 100});
  EXPECT_GT(camera.mm_per_pixel, 0);
}

}  // namespace
}  // namespace proveout
