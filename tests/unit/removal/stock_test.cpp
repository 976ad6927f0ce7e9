// Contacts, provenance, determinism, saved stocks, meshes as blanks and refusals.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/unit/removal/cut_fixture.h"

namespace proveout::test {
namespace {

const BoxShape kBlank{{0, 0, -20}, {40, 30, 0}};

Toolpath slotWithRapids() {
  PathMaker p;
  p.line({5, 15, 5}, {5, 15, 1}, MotionKind::kRapid);
  p.line({5, 15, 1}, {5, 15, -4});
  p.line({5, 15, -4}, {35, 15, -4});
  p.line({35, 15, -4}, {35, 15, 5}, MotionKind::kRapid);
  return p.path();
}

TEST(Contacts, RapidsThatLeaveTheirOwnSlotAreClean) {
  const Cut c = cut(kBlank, slotWithRapids(), {tool("1=flat:6")}, 0.25);
  EXPECT_TRUE(c.summary.contacts.empty());
  EXPECT_GT(c.summary.removed_mm3[1], 0);
  EXPECT_GT(c.summary.removed_mm3[2], c.summary.removed_mm3[1]);
  EXPECT_EQ(c.summary.removed_mm3[0], 0);
  EXPECT_EQ(c.summary.removed_mm3[3], 0);
}

TEST(Contacts, RapidThroughStockIsFoundWithItsDepth) {
  for (const double depth : {0.005, 0.3, 2.5}) {  // also far less than a voxel; below the radius
    PathMaker p;
    p.line({-10, 15, -depth}, {50, 15, -depth}, MotionKind::kRapid);
    const Cut c = cut(kBlank, p.path(), {tool("1=flat:6")}, 0.25);
    ASSERT_EQ(c.summary.contacts.size(), 1u) << depth;
    const Contact& contact = c.summary.contacts[0];
    EXPECT_EQ(contact.kind, ContactKind::kRapid);
    EXPECT_EQ(contact.motion, 0u);
    EXPECT_NEAR(contact.depth_mm, depth, 1e-4);
    if (depth > 0.25) {  // counted in cells: a film thinner than one may count nothing
      EXPECT_NEAR(contact.volume_mm3, 40 * 6 * depth, 0.1 * 40 * 6 * depth);
    }
  }
}

TEST(Contacts, RapidAtTheSurfaceIsClean) {
  PathMaker p;
  p.line({-10, 15, 0}, {50, 15, 0}, MotionKind::kRapid);
  EXPECT_TRUE(cut(kBlank, p.path(), {tool("1=flat:6")}, 0.25).summary.contacts.empty());
}

TEST(Contacts, SpindleOffIsFound) {
  PathMaker p;
  p.line({-10, 15, -1}, {50, 15, -1});
  p.path().motions[0].spindle = 0;
  const Cut c = cut(kBlank, p.path(), {tool("1=flat:6")}, 0.25);
  ASSERT_EQ(c.summary.contacts.size(), 1u);
  EXPECT_EQ(c.summary.contacts[0].kind, ContactKind::kSpindleOff);
}

TEST(Contacts, ShankAndHolderInADeepSlot) {
  Tool t = tool("1=flat:6");
  t.flute_length = 4;
  t.shank_diameter = 8;  // thicker than the flutes: rubs once the slot is deeper than they are long
  t.overall_length = 12;
  t.holder = {{0, 10}, {20, 10}};
  PathMaker shallow;
  shallow.line({-10, 15, -3.9}, {50, 15, -3.9});
  EXPECT_TRUE(cut(kBlank, shallow.path(), {t}, 0.25).summary.contacts.empty());
  PathMaker shank;
  shank.line({-10, 15, -3.5}, {50, 15, -3.5}).line({50, 15, -7}, {-10, 15, -7});
  Cut c = cut(kBlank, shank.path(), {t}, 0.25);
  ASSERT_EQ(c.summary.contacts.size(), 1u);
  EXPECT_EQ(c.summary.contacts[0].kind, ContactKind::kShank);
  EXPECT_EQ(c.summary.contacts[0].motion, 1u);
  // Radius 4 in a slot of half width 3: 1 mm; walls are asked at grid points, up to one step behind them.
  EXPECT_LE(c.summary.contacts[0].depth_mm, 1.0);
  EXPECT_GE(c.summary.contacts[0].depth_mm, 0.75);
  PathMaker holder;
  for (double z = -3.5; z > -15; z -= 3.5) holder.line({-10, 15, z}, {50, 15, z});
  c = cut(kBlank, holder.path(), {t}, 0.25);
  bool found = false;
  for (const Contact& contact : c.summary.contacts) found = found || contact.kind == ContactKind::kHolder;
  EXPECT_TRUE(found);  // at z = -14 the holder's face is at -2, 10 mm around the axis
}

TEST(ThinPasses, AreFollowedAlongTheEdge) {
  // Slots 0.3 mm high, one above the other, from below to above and back: on a grid of 1 mm several share an
  // edge.
  Tool disc = tool("1=flat:6");
  disc.flute_length = 0.3;
  for (const bool upwards : {false, true}) {
    PathMaker p;
    for (int i = 0; i < 30; ++i) {
      const double z = -(upwards ? 30 - i : i + 1) * 0.2;
      p.line({-10, 15, z}, {50, 15, z}).line({50, 15, z}, {50, 60, z}, MotionKind::kRapid);
    }
    const Cut c = cut(kBlank, p.path(), {disc}, 1.0);
    EXPECT_NEAR(c.initial - c.volume, 40 * 6 * 6, 0.05) << upwards;
  }
}

TEST(LostFilm, FloorThinnerThanACellIsReported) {
  PathMaker p;
  p.line({-10, 15, -19.7}, {50, 15, -19.7});
  const Cut c = cut(kBlank, p.path(), {tool("1=flat:6")}, 1.0);  // 0.3 mm are left on a grid of 1 mm
  EXPECT_NEAR(c.summary.lost_film_mm2, 40 * 6, 0.2 * 40 * 6);
  EXPECT_NEAR(c.summary.lost_film_at.z(), -20.0, 0.05);
  const double more = c.initial - c.volume - 40 * 6 * 19.7;  // is removed than was: the floor
  EXPECT_NEAR(more, 40 * 6 * 0.3, 1.0);
  EXPECT_GT(c.summary.lost_mm3, more);
  EXPECT_LT(c.summary.lost_mm3, 2.0 * more);
}

TEST(LostFilm, NothingIsLostWhereTheGridHoldsEverything) {
  PathMaker p;
  p.line({-10, 15, -19.7}, {50, 15, -19.7})
      .line({50, 15, -19.7}, {50, 15, -21})
      .line({50, 15, -21}, {-10, 15, -21});
  EXPECT_EQ(cut(kBlank, p.path(), {tool("1=flat:6")}, 1.0).summary.lost_film_mm2, 0.0);
  PathMaker shallow;
  shallow.line({-10, 15, -5}, {50, 15, -5});
  EXPECT_EQ(cut(kBlank, shallow.path(), {tool("1=ball:6")}, 0.5).summary.lost_film_mm2, 0.0);
}

TEST(Provenance, EveryTriangleKnowsItsMotion) {
  const Cut c = cut(kBlank, slotWithRapids(), {tool("1=flat:6")}, 0.25);
  for (std::size_t i = 0; i < c.mesh.triangles.size(); ++i) {
    const auto& t = c.mesh.triangles[i];
    const Vec3 middle =
        (c.mesh.positions[t[0]] + c.mesh.positions[t[1]] + c.mesh.positions[t[2]]).cast<double>() / 3;
    const bool floor = std::abs(middle.z() + 4) < 1e-3 && middle.x() > 9 && middle.x() < 34;
    const bool bottom = std::abs(middle.z() + 20) < 1e-3;
    if (floor) {
      ASSERT_EQ(c.mesh.motion[i], 2u);
    }
    if (bottom) {
      ASSERT_EQ(c.mesh.motion[i], kNoMotion);
    }
  }
}

TEST(Accuracy, FlatFacesAndSharpEdgesToMicrons) {
  const Cut c = cut(kBlank, slotWithRapids(), {tool("1=flat:6")}, 0.2);
  double worst_floor = 0, worst_edge = 0;
  int edges = 0;
  for (const auto& p : c.mesh.positions) {
    if (p.x() < 9 || p.x() > 31) continue;
    const double y = std::abs(p.y() - 15.0);
    if (y < 2.7 && p.z() > -5 && p.z() < -3) worst_floor = std::max(worst_floor, std::abs(p.z() + 4.0));
    if (y > 2.85 && y < 3.15 && p.z() < -3.85 &&
        p.z() > -4.15) {  // in the cells of the lower edge or right beside it
      const double off_wall = std::abs(y - 3.0), off_floor = std::abs(p.z() + 4.0);
      worst_edge = std::max(worst_edge, std::min(off_wall, off_floor));
      edges += off_wall < 1e-3 && off_floor < 1e-3;
    }
  }
  EXPECT_LT(worst_floor, 2e-5);
  EXPECT_LT(worst_edge, 2e-5);
  EXPECT_GT(edges, 200);  // the edge itself: two sides, 22 mm at 0.2
}

TEST(Determinism, SameBytesForAnyThreadCount) {
  PathMaker p;
  for (int i = 0; i < 5; ++i) {
    p.line({3.0 + i, 4, -2 - 0.1 * i}, {20, 25, -1});
    p.arc({20, 25, -1}, {20, 15, -1}, {0, 0, 1}, 200, -0.5);
  }
  p.line({0, 0, -0.5}, {40, 30, -0.5}, MotionKind::kRapid);
  const Cut one = cut(kBlank, p.path(), {tool("1=bull:5:1")}, 0.3, 1);
  for (const int threads : {2, 4}) {
    const Cut other = cut(kBlank, p.path(), {tool("1=bull:5:1")}, 0.3, threads);
    ASSERT_EQ(one.mesh.positions.size(), other.mesh.positions.size());
    EXPECT_EQ(0, std::memcmp(one.mesh.positions.data(), other.mesh.positions.data(),
                             one.mesh.positions.size() * sizeof(Eigen::Vector3f)));
    EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
    EXPECT_EQ(one.mesh.motion, other.mesh.motion);
    EXPECT_EQ(one.volume, other.volume);
    EXPECT_EQ(one.summary.removed_mm3, other.summary.removed_mm3);
    ASSERT_EQ(one.summary.contacts.size(), other.summary.contacts.size());
    for (std::size_t i = 0; i < one.summary.contacts.size(); ++i) {
      EXPECT_EQ(one.summary.contacts[i].depth_mm, other.summary.contacts[i].depth_mm);
      EXPECT_EQ(one.summary.contacts[i].where, other.summary.contacts[i].where);
    }
  }
}

TEST(Order, CuttingTwiceIsCuttingOnceAndOrderIsIrrelevant) {
  PathMaker a, b, twice;
  a.line({5, 15, -4}, {35, 15, -4}).line({20, 2, -6}, {22, 28, -3});
  b.line({20, 2, -6}, {22, 28, -3}).line({5, 15, -4}, {35, 15, -4});
  twice.line({5, 15, -4}, {35, 15, -4}).line({20, 2, -6}, {22, 28, -3}).line({5, 15, -4}, {35, 15, -4});
  const std::vector<Tool> tools{tool("1=ball:6")};
  const double va = cut(kBlank, a.path(), tools, 0.25).volume;
  EXPECT_NEAR(va, cut(kBlank, b.path(), tools, 0.25).volume, 1e-6 * va);
  EXPECT_NEAR(va, cut(kBlank, twice.path(), tools, 0.25).volume, 1e-6 * va);
}

class SavedStockTest : public ::testing::Test {
 protected:
  // Tests run side by side, each in a process of its own.
  std::string path_ = ::testing::TempDir() + "proveout_stock_test-" + std::to_string(getpid()) + ".vdb";
  void TearDown() override { std::filesystem::remove(path_); }
};

TEST_F(SavedStockTest, GoesOnWithoutLoss) {
  RemovalOptions options;
  options.resolution_mm = 0.3;
  Progress progress;
  const std::vector<Tool> tools{tool("1=ball:6")};
  PathMaker first, second, both;
  first.line({5, 15, -4}, {35, 15, -4});
  second.line({20, 2, -6}, {22, 28, -3});
  both.line({5, 15, -4}, {35, 15, -4}).line({20, 2, -6}, {22, 28, -3});
  auto stock = Stock::create(kBlank, options, progress);
  ASSERT_TRUE(stock->remove(first.path(), tools, options, progress).ok());
  const Status saved = stock->save(path_);
  ASSERT_TRUE(saved.ok()) << saved.error().message;
  auto loaded = Stock::create(SavedStock{path_}, options, progress);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  EXPECT_EQ(loaded->initialVolume(), stock->initialVolume());
  ASSERT_TRUE(loaded->remove(second.path(), tools, options, progress).ok());
  auto once = Stock::create(kBlank, options, progress);
  ASSERT_TRUE(once->remove(both.path(), tools, options, progress).ok());
  EXPECT_NEAR(loaded->surface(2, progress)->volume_mm3, once->surface(2, progress)->volume_mm3, 0.01);
  // The same grid and crossings, to the bit.
  const auto reloaded = [&](const Stock& s) {
    EXPECT_TRUE(s.save(path_).ok());
    return Stock::create(SavedStock{path_}, options, progress)->surface(2, progress);
  };
  const auto surface = reloaded(*loaded), expected = reloaded(*once);
  EXPECT_EQ(surface->mesh.positions, expected->mesh.positions);
  EXPECT_EQ(surface->mesh.triangles, expected->mesh.triangles);
}

TEST_F(SavedStockTest, KeepsGridAndCrossingsBitForBit) {
  RemovalOptions options;
  options.resolution_mm = 0.3;
  Progress progress;
  const std::vector<Tool> tools{tool("1=flat:6")};
  PathMaker p;  // faces of equal elements by several motions meet in creases
  p.line({5, 15, -4}, {35, 15, -4}).line({20, 2, -6}, {22, 28, -3}).line({10, 5, -5}, {30, 25, -5});
  auto stock = Stock::create(kBlank, options, progress);
  ASSERT_TRUE(stock->remove(p.path(), tools, options, progress).ok());
  ASSERT_TRUE(stock->save(path_).ok());
  auto loaded = Stock::create(SavedStock{path_}, options, progress);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  ASSERT_TRUE(loaded->save(path_).ok());
  const auto twice = Stock::create(SavedStock{path_}, options, progress);
  const auto before = loaded->surface(2, progress), after = twice->surface(2, progress);
  EXPECT_EQ(before->mesh.positions, after->mesh.positions);
  EXPECT_EQ(before->mesh.triangles, after->mesh.triangles);
  EXPECT_EQ(before->volume_mm3, after->volume_mm3);
  // The sweeps that place vertices exactly are not saved: what is left is the rule on the crossings.
  const double initial = stock->initialVolume(), exact = stock->surface(2, progress)->volume_mm3;
  EXPECT_NEAR((initial - before->volume_mm3) / (initial - exact), 1.0, 5e-5);
}

TEST_F(SavedStockTest, NoticesDamageAnywhere) {
  RemovalOptions options;
  options.resolution_mm = 1;
  Progress progress;
  auto stock = Stock::create(kBlank, options, progress);
  ASSERT_TRUE(stock->save(path_).ok());
  std::ifstream in(path_, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), {});
  for (std::size_t at = 0; at < good.size(); at += 1 + good.size() / 40) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 16);
    std::ofstream(path_, std::ios::binary) << bad;
    EXPECT_FALSE(Stock::create(SavedStock{path_}, options, progress).ok()) << at;
  }
  std::ofstream(path_, std::ios::binary) << good;
  EXPECT_TRUE(Stock::create(SavedStock{path_}, options, progress).ok());
}

TEST_F(SavedStockTest, RefusesWhatIsNotAStock) {
  RemovalOptions options;
  Progress progress;
  EXPECT_FALSE(Stock::create(SavedStock{"/nonexistent/a.vdb"}, options, progress).ok());
  std::ofstream(path_) << "not a vdb file at all";
  EXPECT_FALSE(Stock::create(SavedStock{path_}, options, progress).ok());
  {
    auto stock = Stock::create(kBlank, options, progress);
    ASSERT_TRUE(stock->save(path_).ok());
  }
  const auto size = std::filesystem::file_size(path_);
  for (const double part : {0.1, 0.5, 0.9}) {  // truncated
    std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(size * part));
    EXPECT_FALSE(Stock::create(SavedStock{path_}, options, progress).ok()) << part;
    auto stock = Stock::create(kBlank, options, progress);
    ASSERT_TRUE(stock->save(path_).ok());
  }
}

TEST_F(SavedStockTest, SaveToAnImpossiblePlaceIsAnErrorAndLeavesNothing) {
  RemovalOptions options;
  options.resolution_mm = 1;
  Progress progress;
  auto stock = Stock::create(kBlank, options, progress);
  EXPECT_FALSE(stock->save("/proc/no/such/folder/x.vdb").ok());
}

TriMesh boxMesh(const Vec3& a, const Vec3& b) {
  TriMesh m;
  for (int c = 0; c < 8; ++c) {
    m.positions.push_back(
        Vec3(c & 1 ? b.x() : a.x(), c & 2 ? b.y() : a.y(), c & 4 ? b.z() : a.z()).cast<float>());
  }
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

TEST(MeshBlank, SameAsTheBoxItDraws) {
  MeshShape shape{boxMesh(kBlank.min, kBlank.max), "box.stl"};
  const Cut from_mesh = cut(shape, slotWithRapids(), {tool("1=flat:6")}, 0.25);
  const Cut from_box = cut(kBlank, slotWithRapids(), {tool("1=flat:6")}, 0.25);
  EXPECT_NEAR(from_mesh.initial, 24000, 1e-6);
  EXPECT_NEAR(from_mesh.volume, from_box.volume, 1e-6 * from_box.volume);
}

TEST(MeshBlank, OpenOrInsideOutMeshIsRefused) {
  Progress progress;
  MeshShape shape{boxMesh(kBlank.min, kBlank.max), "box.stl"};
  shape.mesh.triangles.pop_back();
  auto open = Stock::create(shape, {}, progress);
  ASSERT_FALSE(open.ok());
  EXPECT_NE(open.error().message.find("box.stl"), std::string::npos);
  shape.mesh = boxMesh(kBlank.min, kBlank.max);
  for (auto& t : shape.mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_FALSE(Stock::create(shape, {}, progress).ok());
  shape.mesh = TriMesh{};
  EXPECT_FALSE(Stock::create(shape, {}, progress).ok());
}

TEST(Refusals, BadShapesAndOptions) {
  Progress progress;
  const double nan = std::nan("");
  EXPECT_FALSE(Stock::create(BoxShape{{0, 0, 0}, {1, 1, 0}}, {}, progress).ok());
  EXPECT_FALSE(Stock::create(BoxShape{{0, 0, 0}, {1, nan, 1}}, {}, progress).ok());
  CylinderShape round;
  EXPECT_FALSE(Stock::create(round, {}, progress).ok());
  round.radius = 5, round.length = 5, round.inner_radius = 5;
  EXPECT_FALSE(Stock::create(round, {}, progress).ok());
  RemovalOptions options;
  for (const double bad : {0.0, -1.0, nan}) {
    options.resolution_mm = bad;
    EXPECT_FALSE(Stock::create(kBlank, options, progress).ok()) << bad;
  }
}

TEST(Refusals, TooLargeForTheMemoryNamesTheGridThatFits) {
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.05;
  options.max_memory_gb = 0.01;
  const auto stock = Stock::create(kBlank, options, progress);
  ASSERT_FALSE(stock.ok());
  EXPECT_EQ(stock.error().kind, ErrorKind::kResourceLimit);
  EXPECT_NE(stock.error().message.find("--resolution"), std::string::npos);
  options.resolution_mm = 1e-9;
  EXPECT_EQ(Stock::create(kBlank, options, progress).error().kind, ErrorKind::kResourceLimit);
}

TEST(Refusals, UndescribedToolAndCancelledRun) {
  Progress progress;
  RemovalOptions options;
  options.resolution_mm = 0.5;
  auto stock = Stock::create(kBlank, options, progress);
  const auto unknown = stock->remove(slotWithRapids(), {tool("2=flat:6")}, options, progress);
  ASSERT_FALSE(unknown.ok());
  EXPECT_NE(unknown.error().message.find("tool 1"), std::string::npos);
  Toolpath bad = slotWithRapids();
  bad.motions[1].to.x() = std::nan("");
  EXPECT_FALSE(stock->remove(bad, {tool("1=flat:6")}, options, progress).ok());
  progress.cancel();
  const auto cancelled = stock->remove(slotWithRapids(), {tool("1=flat:6")}, options, progress);
  ASSERT_FALSE(cancelled.ok());
  EXPECT_EQ(cancelled.error().kind, ErrorKind::kInterrupted);
}

TEST(FitRemoved, SumsToTheExactVolume) {
  RemovalSummary summary;
  summary.removed_mm3 = {1, 3, 0};
  fitRemovedVolume(summary, 8);
  EXPECT_FLOAT_EQ(summary.removed_mm3[0], 2);
  EXPECT_FLOAT_EQ(summary.removed_mm3[1], 6);
}

}  // namespace
}  // namespace proveout::test
