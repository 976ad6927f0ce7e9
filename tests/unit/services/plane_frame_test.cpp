#include "core/nc/services/plane_frame.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace proveout {
namespace {

TEST(PlaneFrame, NamesTheAxesOfEachPlane) {
  EXPECT_EQ(PlaneFrame(Plane::kXY).toPlane({1, 2, 3}), Vec3(1, 2, 3));
  EXPECT_EQ(PlaneFrame(Plane::kZX).toPlane({1, 2, 3}), Vec3(3, 1, 2));
  EXPECT_EQ(PlaneFrame(Plane::kYZ).toPlane({1, 2, 3}), Vec3(2, 3, 1));
}

TEST(PlaneFrame, GoesBackAndIsRightHanded) {
  for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
    const PlaneFrame frame(plane);
    EXPECT_EQ(frame.fromPlane(frame.toPlane({1, 2, 3})), Vec3(1, 2, 3));
    EXPECT_EQ(Vec3::Unit(frame.u()).cross(Vec3::Unit(frame.v())), frame.normal());
    EXPECT_EQ(frame.fromPlane({0, 0, 1}), frame.normal());
  }
}

}  // namespace
}  // namespace proveout
