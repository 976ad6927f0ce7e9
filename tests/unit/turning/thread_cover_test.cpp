// Which passes of a thread a deeper one leaves nothing of, and how threads come out of a path.
#include "removal/turning/threads/thread_cover.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "removal/turning/turned_field.h"
#include "tests/unit/turning/turning_fixture.h"

namespace proveout {
namespace {

Insert threadInsert(double edge_length) {
  Insert insert;
  insert.shape = InsertShape::kThread;
  insert.orientation = 8;
  insert.insert_angle_deg = 60.0;
  insert.tip_flat = 0.3;
  insert.edge_length = edge_length;
  return insert;
}

TurnedShape threaded(const TurningPath& path, double edge_length, RemovalSummary* summary = nullptr) {
  Progress progress;
  Result<TurnedStock> stock = TurnedStock::create(bar(10, 60));
  EXPECT_TRUE(stock);
  Result<RemovalSummary> cut = stock->remove(path.path, {insertTool(1, threadInsert(edge_length))}, progress);
  EXPECT_TRUE(cut);
  if (summary != nullptr) *summary = std::move(*cut);
  return stock->shape();
}

TEST(ThreadCover, DeeperPassesHoldTheShallowOnes) {
  TurningPath path({15, 5});
  for (const double r : {9.6, 9.2, 8.8, 8.8}) path.rapid(r, 5).thread(r, -30, 14).rapid(15, -30).rapid(15, 5);
  const TurnedShape shape = threaded(path, 3.0);
  ASSERT_EQ(shape.threads.size(), 1u);
  EXPECT_EQ(shape.threads[0].from.x(), 8.8);
  EXPECT_EQ(shape.threads[0].motion, 9u);  // the third pass; the spring pass finds nothing
}

TEST(ThreadCover, PassesThatLeaveSomethingStay) {
  // The deep pass ends in the material: its flanks reach 1 mm, the shallow one takes what is above.
  TurningPath shallow_insert({15, 5});
  for (const double r : {9.4, 8.5}) shallow_insert.rapid(r, 5).thread(r, -30, 14).rapid(15, -30).rapid(15, 5);
  EXPECT_EQ(threaded(shallow_insert, 1.0).threads.size(), 2u);
  // Another start, another lead, another end.
  TurningPath starts({15, 5});
  starts.rapid(9, 5).thread(9, -30, 7, 0.0).rapid(15, -30).rapid(15, 5).rapid(9, 5).thread(9, -30, 7, 180.0);
  EXPECT_EQ(threaded(starts, 3.0).threads.size(), 2u);
  TurningPath leads({15, 5});
  leads.rapid(9, 5).thread(9, -30, 7).rapid(15, -30).rapid(15, 5).rapid(9, 5).thread(9, -30, 8);
  EXPECT_EQ(threaded(leads, 3.0).threads.size(), 2u);
}

/// Infeed along the flank towards the chuck: each pass starts nearer to it by its depth times tan(30
/// degrees).
TurningPath flankInfeed(int passes) {
  TurningPath path({15, 5});
  for (int i = 1; i <= passes; ++i) {
    const double depth = 1.2 * i / passes, z = 5 - depth * std::tan(kPi / 6);
    path.rapid(10 - depth, z).thread(10 - depth, -30, (z + 30) / 2.5).rapid(15, -30).rapid(15, z);
  }
  return path;
}

TEST(ThreadCover, OfPassesWithInfeedAlongAFlankTheEndsStay) {
  const TurnedShape shape = threaded(flankInfeed(20), 3.0);
  ASSERT_EQ(shape.threads.size(), 20u);
  double all = 0.0;
  for (const ThreadSweep& thread : shape.threads) all += std::abs(thread.turns);
  // The last pass is whole; of each other one what it turns on after the next one's end, and a little
  // overlap.
  const double ends = 19 * (0.06 * std::tan(kPi / 6) / 2.5 + 0.05);
  EXPECT_NEAR(all, (35 - 1.2 * std::tan(kPi / 6)) / 2.5 + ends, 1e-6);
}

TEST(ThreadCover, WhatIsLeftOutMakesNoDifference) {
  const TurningPath path = flankInfeed(6);
  auto reduced = std::make_shared<TurnedShape>(threaded(path, 3.0));
  auto whole = std::make_shared<TurnedShape>(*reduced);
  whole->threads.clear();
  for (const Motion& motion : path.path.motions) {
    if (motion.kind != MotionKind::kThread) continue;
    ThreadSweep sweep = reduced->threads.front();
    sweep.from = {motion.from.x(), motion.from.z()};
    sweep.to = {motion.to.x(), motion.to.z()};
    sweep.start_rad = 0.0;
    sweep.turns = -threadTurns(path.path, motion);
    whole->threads.push_back(sweep);
  }
  const auto a = makeTurnedField(reduced), b = makeTurnedField(whole);
  ASSERT_TRUE(a && b);
  for (int i = 0; i < 4000; ++i) {
    const double angle = 0.7 * i, r = 8.5 + 1.6 * std::fmod(0.618 * i, 1.0), z = -34 + 36.0 * i / 4000;
    const Vec3 p(r * std::cos(angle), r * std::sin(angle), z);
    const double value = (*b)->sample(p).value;
    EXPECT_EQ((*a)->sample(p).value < 0.0, value < 0.0) << p.transpose() << " is off by " << value;
    EXPECT_DOUBLE_EQ((*a)->value(p), (*a)->sample(p).value);
  }
}

TEST(ThreadCover, RightHandedWithM3TowardsTheChuck) {
  TurningPath path({15, 5});
  path.rapid(9, 5).thread(9, -30, 14, 90.0);
  const TurnedShape shape = threaded(path, 3.0);
  ASSERT_EQ(shape.threads.size(), 1u);
  EXPECT_NEAR(shape.threads[0].turns, -14.0, 1e-9);
  EXPECT_NEAR(shape.threads[0].start_rad, -0.5 * kPi, 1e-6);
  // Seen from the part both the angle and z fall.
  EXPECT_LT(shape.threads[0].to.y(), shape.threads[0].from.y());
}

TEST(ThreadCover, RetractingFromTheGrooveIsNoContact) {
  // No run-out: the tool leaves at rapid where the thread ends.
  TurningPath path({15, 5});
  path.rapid(9, 5).thread(9, -30, 14).rapid(15, -30).rapid(15, 5);
  RemovalSummary summary;
  const TurnedShape shape = threaded(path, 3.0, &summary);
  EXPECT_TRUE(summary.contacts.empty());
  ASSERT_EQ(shape.bodies.size(), 1u);
  // The section keeps the crest: the groove is a thread, no ring.
  EXPECT_NEAR(shape.bodies[0].volume_mm3, kPi * 100 * 60, 1e-3);
  // About 14 grooves less what hangs out in front: tip 0.3, flanks of 30 degrees, 1 mm deep.
  const double area = 0.3 + std::tan(kPi / 6);
  const double estimate = area * 2 * kPi * 9.5 * 12;
  EXPECT_NEAR(static_cast<double>(summary.removed_mm3[1]) / estimate, 1.0, 0.1);
}

}  // namespace
}  // namespace proveout
