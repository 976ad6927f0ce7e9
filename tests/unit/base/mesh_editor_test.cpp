// Random changes of closed meshes: they stay closed, and what is taken back was never done.
#include "core/mesh/mesh_editor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace proveout {
namespace {

using Order = MeshEditor::FanOrder;

/// Two cones over rings of `n` vertices, with a belt of `belts` rows of squares between them.
TriMesh barrel(std::uint32_t n, std::uint32_t belts) {
  TriMesh mesh;
  const auto last = static_cast<float>(belts);
  mesh.positions = {{0.0f, 0.0f, last + 1.0f}, {0.0f, 0.0f, -1.0f}};
  for (std::uint32_t row = 0; row <= belts; ++row) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const float turn = 6.2831853f * static_cast<float>(i) / static_cast<float>(n);
      mesh.positions.emplace_back(std::cos(turn), std::sin(turn), static_cast<float>(row));
    }
  }
  const auto at = [&](std::uint32_t row, std::uint32_t i) { return 2 + row * n + i % n; };
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({0, at(belts, i), at(belts, i + 1)});
    mesh.triangles.push_back({1, at(0, i + 1), at(0, i)});
    for (std::uint32_t row = 0; row < belts; ++row) {
      mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
      mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
    }
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) mesh.motion.push_back(t);
  return mesh;
}

/// The mesh without what is gone, and without vertices that have no triangles.
TriMesh compacted(const TriMesh& mesh) {
  LostParts lost;
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangles[t][0] == MeshEditor::kGone) {
      lost.triangles.push_back(t);
    } else {
      for (const std::uint32_t v : mesh.triangles[t]) used[v] = 1;
    }
  }
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) lost.vertices.push_back(v);
  }
  TriMesh out = mesh;
  takeOut(out, lost);
  return out;
}

void expectSame(const TriMesh& a, const TriMesh& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.motion, b.motion);
}

std::vector<std::vector<std::uint32_t>> fansOf(const MeshEditor& edit) {
  std::vector<std::vector<std::uint32_t>> fans;
  for (std::uint32_t v = 0; v < edit.mesh().positions.size(); ++v) {
    const auto fan = edit.fan(v);
    fans.emplace_back(fan.begin(), fan.end());
  }
  return fans;
}

/// One random change. False where the edge that was drawn does not allow it.
bool change(MeshEditor& edit, std::mt19937& random) {
  const TriMesh& mesh = edit.mesh();
  const auto t = static_cast<std::uint32_t>(random() % mesh.triangles.size());
  if (edit.gone(t)) return false;
  const std::uint32_t a = mesh.triangles[t][random() % 3], b = edit.following(t, a, 1);
  const auto wing = edit.wing(a, b);
  EXPECT_TRUE(wing.has_value());
  if (!wing) return false;
  switch (random() % 6) {
    case 0:
      edit.move(a, mesh.positions[a] + Eigen::Vector3f(0.01f, -0.02f, 0.01f));
      return true;
    case 1:
      edit.split(*wing, 0.5f * (mesh.positions[a] + mesh.positions[b]));
      return true;
    case 2:
      edit.rotate(t, 1 + static_cast<int>(random() % 2));
      return true;
    case 3:
      edit.setMotion(t, static_cast<std::uint32_t>(random() % 9));
      return true;
    case 4:
      if (!edit.canFlip(*wing)) return false;
      edit.flip(*wing);
      return true;
    default:
      if (!edit.canCollapse(*wing)) return false;
      edit.collapse(*wing);
      return true;
  }
}

class MeshEditorLaws : public testing::TestWithParam<Order> {};

TEST_P(MeshEditorLaws, RandomChangesKeepTheMeshClosed) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    TriMesh mesh = barrel(3 + seed % 7, 1 + seed % 4);
    MeshEditor edit(mesh, GetParam());
    int done = 0;
    for (int i = 0; i < 400; ++i) {
      done += change(edit, random);
      if (i % 20 != 0) continue;
      ASSERT_TRUE(edit.isConsistent()) << "seed " << seed << ", change " << i;
      ASSERT_TRUE(analyseTopology(compacted(mesh)).closedManifold()) << "seed " << seed << ", change " << i;
    }
    EXPECT_GT(done, 50);
    EXPECT_EQ(analyseTopology(compacted(mesh)).components, 1u);
  }
}

TEST_P(MeshEditorLaws, WhatIsTakenBackLeavesNoTrace) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(1000 + seed);
    TriMesh mesh = barrel(4 + seed % 5, 2);
    MeshEditor edit(mesh, GetParam());
    for (int i = 0; i < 50; ++i) change(edit, random);
    edit.keep();
    const TriMesh before = mesh;
    const auto fans = fansOf(edit);
    const MeshEditor::Mark start = edit.mark();
    for (int i = 0; i < 100; ++i) change(edit, random);
    const MeshEditor::Mark half = edit.mark();
    const TriMesh between = mesh;
    const auto fans_between = fansOf(edit);
    for (int i = 0; i < 100; ++i) change(edit, random);
    edit.takeBack(half);
    expectSame(mesh, between);
    EXPECT_EQ(fansOf(edit), fans_between);
    edit.takeBack(start);
    expectSame(mesh, before);
    EXPECT_EQ(fansOf(edit), fans);
    EXPECT_EQ(edit.touched(), std::vector<std::uint8_t>(mesh.positions.size(), 0));
  }
}

TEST_P(MeshEditorLaws, KnowingSomeTrianglesIsEnoughForThem) {
  TriMesh whole = barrel(6, 8), part = whole;
  std::vector<std::uint32_t> some;  // the lower half
  for (std::uint32_t t = 0; t < whole.triangles.size(); ++t) {
    const auto& v = whole.triangles[t];
    if (std::all_of(v.begin(), v.end(), [&](std::uint32_t i) { return whole.positions[i].z() < 4.5f; }))
      some.push_back(t);
  }
  MeshEditor all(whole, GetParam()), few(part, GetParam(), some);
  for (std::uint32_t v = 2; v < 2 + 6 * 3; ++v) {  // those with all of their triangles among them
    const auto fan = few.fan(v), same = all.fan(v);
    EXPECT_TRUE(std::equal(fan.begin(), fan.end(), same.begin(), same.end())) << v;
  }
  for (const auto& [a, b] : {std::pair{8u, 9u}, {9u, 15u}, {14u, 8u}}) {
    const auto wing = all.wing(a, b);
    ASSERT_TRUE(wing && few.wing(a, b));
    EXPECT_EQ(all.canFlip(*wing), few.canFlip(*wing));
    if (!all.canFlip(*wing)) continue;
    all.flip(*wing);
    few.flip(*wing);
  }
  expectSame(whole, part);
  EXPECT_TRUE(few.fan(0).empty());
}

INSTANTIATE_TEST_SUITE_P(Orders, MeshEditorLaws, testing::Values(Order::kKept, Order::kRenewed));

TEST(MeshEditor, AFlipJoinsTheOtherCorners) {
  TriMesh mesh = barrel(6, 1);
  MeshEditor edit(mesh, Order::kKept);
  const MeshWing w = *edit.wing(2, 9);
  ASSERT_TRUE(edit.canFlip(w));
  EXPECT_FALSE(edit.wing(w.c, w.d));
  edit.flip(w);
  EXPECT_FALSE(edit.wing(w.a, w.b));
  EXPECT_TRUE(edit.wing(w.c, w.d));
  EXPECT_EQ(mesh.triangles[w.abc], (std::array{w.a, w.d, w.c}));
  EXPECT_EQ(mesh.triangles[w.bad], (std::array{w.d, w.b, w.c}));
}

TEST(MeshEditor, ATetrahedronAllowsNothing) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  MeshEditor edit(mesh, Order::kKept);
  for (std::uint32_t a = 0; a < 4; ++a) {
    for (std::uint32_t b = 0; b < 4; ++b) {
      if (a == b) continue;
      const auto wing = edit.wing(a, b);
      ASSERT_TRUE(wing);
      EXPECT_FALSE(edit.canFlip(*wing));
      EXPECT_FALSE(edit.canCollapse(*wing));
    }
  }
}

TEST(MeshEditor, AWaistIsNotPinched) {
  // A belt of three: its edges along the ring have the far vertex of the ring as a common neighbour.
  TriMesh mesh = barrel(3, 3);
  MeshEditor edit(mesh, Order::kKept);
  const auto wing = edit.wing(5, 6);
  ASSERT_TRUE(wing);
  EXPECT_FALSE(edit.canCollapse(*wing));
}

TEST(MeshEditor, TouchedAreWhatMovedAndCornersOfWhatChanged) {
  TriMesh mesh = barrel(6, 2);
  MeshEditor edit(mesh, Order::kKept);
  edit.move(0, mesh.positions[0]);
  const MeshWing w = *edit.wing(8, 9);
  const std::uint32_t x = edit.split(w, mesh.positions[8]);
  const std::vector<std::uint8_t> touched = edit.touched();
  std::vector<std::uint8_t> expected(mesh.positions.size(), 0);
  for (const std::uint32_t v : {0u, w.a, w.b, w.c, w.d, x}) expected[v] = 1;
  EXPECT_EQ(touched, expected);
}

TEST(TakeOut, NumbersTheRestAnew) {
  TriMesh mesh = barrel(5, 3);
  MeshEditor edit(mesh, Order::kKept);
  const MeshWing w = *edit.wing(7, 8);
  ASSERT_TRUE(edit.canCollapse(w));
  edit.collapse(w);
  const std::size_t vertices = mesh.positions.size(), triangles = mesh.triangles.size();
  takeOut(mesh, {{w.bad, w.abc}, {w.a}});
  EXPECT_EQ(mesh.positions.size(), vertices - 1);
  EXPECT_EQ(mesh.triangles.size(), triangles - 2);
  EXPECT_EQ(mesh.motion.size(), triangles - 2);
  EXPECT_TRUE(analyseTopology(mesh).closedManifold());
}

}  // namespace
}  // namespace proveout
