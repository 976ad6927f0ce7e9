// The workpiece of a wire: paths from motions to bodies, meshes and contacts.
#include "removal/process/wire_piece.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/unit/wire/wire_fixture.h"

namespace proveout {
namespace {

constexpr double kKerf = 0.11, kHeight = 20.0;

/// A plate of 40 x 40 x 20, a wire of 0.2 with a gap of 0.01.
struct Cut {
  Toolpath path;
  ToolpathBuilder builder{path};
  std::vector<Tool> tools;
  StockShape shape = BoxShape{{-20, -20, 0}, {20, 20, kHeight}};
  PieceOptions options;
  Vec2 at = Vec2::Zero();

  Cut() {
    Tool wire;
    wire.number = 1;
    wire.type = ToolType::kWire;
    wire.diameter = 0.2;
    wire.spark_gap = 0.01;
    tools.push_back(wire);
    builder.file(0, "wire.nc");
  }
  void move(const WireSweep& sweep, MotionKind kind) {
    Motion motion;
    motion.kind = kind;
    motion.from = Vec3(at.x(), at.y(), sweep.z_low);
    at = sweep.lower.to;
    motion.to = Vec3(at.x(), at.y(), sweep.z_low);
    motion.source.line = static_cast<std::uint32_t>(path.motions.size() + 1);
    motion.source.block = 10 * motion.source.line;
    builder.wireMotion(motion, sweep);
  }
  WireSweep sweepTo(const Vec2& to) const {
    WireSweep sweep;
    sweep.z_high = kHeight;
    sweep.lower.from = at;
    sweep.lower.to = to;
    sweep.upper = sweep.lower;
    return sweep;
  }
  void line(const Vec2& to, MotionKind kind = MotionKind::kFeed) { move(sweepTo(to), kind); }
  void arc(const Vec2& to, const Vec2& center, double sweep_rad) {
    WireSweep sweep = sweepTo(to);
    sweep.lower.center = center;
    sweep.lower.sweep_rad = sweep_rad;
    sweep.upper = sweep.lower;
    move(sweep, MotionKind::kFeed);
  }
  /// A square of side 10 about the origin, from a place on its left side.
  void square() {
    line({-5, 0});
    for (const Vec2& corner : {Vec2(-5, -5), Vec2(5, -5), Vec2(5, 5), Vec2(-5, 5), Vec2(-5, 0)}) line(corner);
  }
  Result<Machined> machine() {
    const Result<PrismBlank> blank = prismOf(shape);
    if (!blank) return blank.error();
    WirePiece piece{WireStock(*blank)};
    Progress progress;
    return piece.machine(path, tools, options, progress);
  }
};

TEST(WirePiece, DieWithItsSlug) {
  Cut cut;
  cut.square();
  const Result<Machined> made = cut.machine();
  ASSERT_TRUE(made.ok()) << made.error().message;
  ASSERT_EQ(made->bodies->size(), 2u);
  const StockBody &die = made->bodies->at(0), &slug = made->bodies->at(1);
  EXPECT_EQ(die.role, "part");
  EXPECT_EQ(slug.role, "slug");
  // The lead-in from the middle is cut out of the slug, and rounds nothing off the frame.
  const double slot = (5 - kKerf) * 2 * kKerf + 0.5 * kPi * kKerf * kKerf;
  EXPECT_NEAR(slug.volume_mm3, kHeight * (9.78 * 9.78 - slot), 1e-5 * slug.volume_mm3);
  const double hole = 10.22 * 10.22 - (4 - kPi) * kKerf * kKerf;
  EXPECT_NEAR(die.volume_mm3, kHeight * (1600 - hole), 1e-7 * die.volume_mm3);
  EXPECT_NEAR(slug.bounds.max.x(), 4.89, 1e-6);
  EXPECT_EQ(slug.bounds.max.z(), kHeight);
  EXPECT_DOUBLE_EQ(made->surface.volume_mm3, die.volume_mm3 + slug.volume_mm3);
  const auto& removed = made->removal.removed_mm3;
  EXPECT_NEAR(std::accumulate(removed.begin(), removed.end(), 0.0),
              made->initial_mm3 - made->surface.volume_mm3, 1e-2);
  EXPECT_NEAR(removed[2], kHeight * 10 * 2 * kKerf, 0.05 * removed[2]);
  const MeshTopology topology = analyseTopology(made->surface.mesh);
  EXPECT_TRUE(topology.closedManifold());
  EXPECT_EQ(topology.components, 2u);
  EXPECT_TRUE(made->removal.contacts.empty());
}

TEST(WirePiece, ThePunchIsThePartWhereTheNominalSaysSo) {
  Cut cut;
  cut.square();
  cut.options.part = Box3{{-4.9, -4.9, 0}, {4.9, 4.9, kHeight}};
  const Result<Machined> made = cut.machine();
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->bodies->size(), 2u);
  EXPECT_LT(made->bodies->at(0).volume_mm3, made->bodies->at(1).volume_mm3);
  EXPECT_EQ(made->bodies->at(1).role, "slug");
  EXPECT_NEAR(meshVolume(made->surface.mesh) / made->bodies->at(0).volume_mm3, 1.0, 1e-4);
}

/// A hole of 3 x 3, entered from its middle and left by the same way.
TEST(WirePiece, HoleOfThreeByThree) {
  Cut cut;
  cut.at = {1.5, 1.5};
  for (const Vec2& to : {Vec2(1.5, 1), Vec2(1.5, 0.11), Vec2(0.11, 0.11), Vec2(0.11, 2.89), Vec2(2.89, 2.89),
                         Vec2(2.89, 0.11), Vec2(1.5, 0.11), Vec2(1.5, 1)})
    cut.line(to);
  const Result<Machined> made = cut.machine();
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->bodies->size(), 2u);
  const double hole = 9.0 - (4 - kPi) * kKerf * kKerf;
  EXPECT_NEAR(made->bodies->at(0).volume_mm3, kHeight * (1600 - hole), 1e-4);
  const double slot = 1.28 * 2 * kKerf + 0.5 * kPi * kKerf * kKerf;
  EXPECT_NEAR(made->bodies->at(1).volume_mm3, kHeight * (2.56 * 2.56 - slot), 1e-4);
}

TEST(WirePiece, CylinderAndRoundHole) {
  Cut cut;
  cut.shape = CylinderShape{2, {0, 0, 0}, 15, 0, kHeight};
  cut.at = {6, 0};
  cut.arc({6, 0}, {0, 0}, -2 * kPi);
  const Result<Machined> made = cut.machine();
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->bodies->size(), 2u);
  EXPECT_NEAR(made->bodies->at(0).volume_mm3, kHeight * kPi * (225 - 6.11 * 6.11), 1e-2);
  EXPECT_NEAR(made->bodies->at(1).volume_mm3, kHeight * kPi * 5.89 * 5.89, 1e-2);
}

TEST(WirePiece, RapidThroughMaterialIsAContact) {
  Cut cut;
  cut.line({5, 0});
  cut.line({0, 0}, MotionKind::kRapid);  // in the kerf
  cut.line({0, 10}, MotionKind::kRapid);
  const Result<Machined> made = cut.machine();
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->removal.contacts.size(), 1u);
  const Contact& contact = made->removal.contacts[0];
  EXPECT_EQ(contact.kind, ContactKind::kRapid);
  EXPECT_EQ(contact.motion, 2u);
  EXPECT_NEAR(contact.depth_mm, 10.0 - kKerf, 0.2);
  EXPECT_GT(contact.volume_mm3, kHeight * 0.2 * 9.5);
  EXPECT_EQ(made->removal.removed_mm3[2], 0.0F);
}

TEST(WirePiece, RapidOverAFallenSlugIsNone) {
  Cut cut;
  cut.square();
  cut.line({3, 3}, MotionKind::kRapid);
  const Result<Machined> made = cut.machine();
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(made->removal.contacts.empty());
}

TEST(WirePiece, RefusesOtherToolsAndStocks) {
  Cut mill;
  mill.tools[0].type = ToolType::kFlat;
  mill.line({5, 0});
  EXPECT_FALSE(mill.machine().ok());
  Cut lying;
  lying.shape = CylinderShape{0, {0, 0, 0}, 15, 0, kHeight};
  EXPECT_FALSE(lying.machine().ok());
}

}  // namespace
}  // namespace proveout
