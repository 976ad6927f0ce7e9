// Chains of axes: the manual's poses (chapter 25), and random chains against products of matrices.
//
// Rows: nct-25.1-HH nct-25.1-TT nct-25.1-HT nct-25.1-INCL
#include "core/machine/machine_chain.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "core/geometry/rigid_transform.h"
#include "core/machine/rotary_pair.h"
#include "tests/support/test_machines.h"

namespace proveout {
namespace {

AxisPoint at(const Vec3& xyz, double first, double second) {
  AxisPoint p(xyz);
  p.more[0] = first;
  p.more[1] = second;
  return p;
}

void expectNear(const Vec3& a, const Vec3& b, double most = 5e-5) {
  EXPECT_LT((a - b).norm(), most) << a.transpose() << " for " << b.transpose();
}

TEST(MachineChain, HeadsCarryTheTip) {
  const MachineChain cb(test::machineCB(), Vec3::Zero());
  const ToolPose pose = cb.pose(at({60, 236.7767, 16.7767}, 90, 45), 100);
  expectNear(pose.tip, {60, 60, -10}, 1e-4);
  expectNear(pose.axis, {0, std::sqrt(0.5), std::sqrt(0.5)});
  // Head-head with both vectors; V is where the control point is with the tip at 0.
  const MachineChain offset(test::headHead('B', {10, 0, 150}, {0, 25, 60}), Vec3::Zero());
  expectNear(offset.pose(at({40.1795, 111.9134, 78.8269}, 60, 30), 120).tip, Vec3::Zero(), 1e-4);
  const MachineChain ca(test::machineCA(), Vec3::Zero());
  expectNear(ca.pose(at({0, -70.7107, 170.7107}, 0, 45), 100).tip, {0, 0, 100}, 1e-4);
  expectNear(ca.pose(at({61.2372, -35.3553, 170.7107}, 60, 45), 100).tip, {0, 0, 100}, 1e-4);
}

TEST(MachineChain, TablesCarryThePart) {
  const Vec3 zero(450, 300, -420);
  const MachineChain ac(test::trunnion('A'), zero);
  const struct {
    double a, c;
    Vec3 machine;
  } rows[] = {{0, 0, {450, 300, -420}},
              {0, 90, {400, 250, -420}},
              {30, 0, {450, 340, -430.7180}},
              {30, 90, {400, 296.6987, -405.7180}}};
  for (const auto& row : rows) {
    const ToolPose pose = ac.pose(at(row.machine, row.a, row.c), 0);
    expectNear(pose.tip, Vec3::Zero(), 1e-4);
  }
  expectNear(ac.toolAxis(at(Vec3::Zero(), 30, 0)), {0, -0.5, std::sqrt(0.75)});
}

TEST(MachineChain, OneHeadAndOneTable) {
  const MachineChain ht(test::headTable(), {400, 300, -420});
  // 25.11: B-45 C90.
  expectNear(ht.pose(at({223.2233, 300, -393.2233}, -45, 90), 100).tip, Vec3::Zero(), 1e-4);
  MachineModel head = test::plainMachine();
  test::addHead(head, "B", Vec3::UnitY(), {10, 0, 150});
  expectNear(MachineChain(head, Vec3::Zero()).pose(at({-175.8922, 0, 63.2599}, -40, 0), 120).tip,
             Vec3::Zero(), 1e-4);
}

TEST(MachineChain, UprightIsUprightAndQuartersAreExact) {
  const MachineChain ac(test::trunnion('A'), Vec3::Zero());
  EXPECT_EQ(ac.toolAxis(at(Vec3::Zero(), 360, 77)), Vec3::UnitZ());
  EXPECT_EQ(ac.toolAxis(at(Vec3::Zero(), 90, 0)), -Vec3::UnitY());
}

struct Random {
  std::mt19937_64 engine{20261128};
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  int count(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }
  Vec3 direction() {
    Vec3 d;
    do d = {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)};
    while (d.norm() < 0.1 || d.norm() > 1.0);
    return d.normalized();
  }
  Vec3 point() { return {(*this)(-500, 500), (*this)(-500, 500), (*this)(-500, 500)}; }
};

/// X, Y, Z of any direction and side, further axes between and behind them.
MachineModel randomMachine(Random& random) {
  MachineModel model;
  std::vector<int> ends{kOnBed, kOnBed};  // of the tool's and the part's side
  const int count = random.count(3, 9);
  for (int k = 0; k < count; ++k) {
    MachineAxis axis;
    axis.name = k < 3 ? std::string(1, static_cast<char>('X' + k)) : "A" + std::to_string(k);
    axis.kind = k < 3 || random.count(0, 2) == 0 ? AxisKind::kLinear : AxisKind::kRotary;
    axis.side = random.count(0, 1) == 0 ? AxisSide::kTool : AxisSide::kPart;
    axis.on = std::exchange(ends[axis.side == AxisSide::kPart ? 1 : 0], k);
    axis.direction = random.direction();
    axis.point = random.point();
    axis.left = random.count(0, 1) == 0;
    model.axes.push_back(axis);
  }
  model.spindle = {ends[0], random.point(), random.direction()};
  return model;
}

/// From the bed to the end of a side: how what stands there has moved.
RigidTransform sideAt(const MachineModel& model, AxisSide side, const AxisPoint& q) {
  RigidTransform out;
  for (std::size_t k = 0; k < model.axes.size(); ++k) {  // each stands on an earlier one
    const MachineAxis& axis = model.axes[k];
    if (axis.side != side) continue;
    RigidTransform own;
    const double value = q[static_cast<int>(k)];
    if (axis.kind == AxisKind::kLinear) {
      own.translation = (side == AxisSide::kPart ? -value : value) * axis.direction;
    } else {
      own.rotation =
          Eigen::AngleAxisd(degToRad(axis.left ? -value : value), axis.direction).toRotationMatrix();
      own.translation = axis.point - own.rotation * axis.point;
    }
    out = out * own;
  }
  return out;
}

TEST(MachineChain, RandomChainsAreProductsOfMatrices) {
  Random random;
  for (int i = 0; i < 10000; ++i) {
    const MachineModel model = randomMachine(random);
    ASSERT_TRUE(machineFaults(model).empty()) << i;
    const Vec3 origin = random.point();
    AxisPoint q(random.point());
    for (double& more : q.more) more = random(-400, 400);
    const double length = random(0, 200);
    const ToolPose pose = MachineChain(model, origin).pose(q, length);
    const RigidTransform tool = sideAt(model, AxisSide::kTool, q),
                         part = sideAt(model, AxisSide::kPart, q).inverse();
    const Vec3 tip = part(tool(model.spindle.gauge - length * model.spindle.direction)) - origin;
    const Vec3 axis = part.rotation * (tool.rotation * model.spindle.direction);
    ASSERT_LT((pose.tip - tip).norm(), 1e-9) << i;
    ASSERT_LT((pose.axis - axis).norm(), 1e-12) << i;
  }
}

TEST(MachineChain, OnlyTurnIsALineOfTheTip) {
  Random random;
  int turned = 0;
  for (int i = 0; i < 1000; ++i) {
    const MachineModel model = randomMachine(random);
    const MachineChain chain(model, random.point());
    AxisPoint a(random.point());
    for (double& more : a.more) more = random(-200, 200);
    const int axis = random.count(3, 8);
    if (!chain.carries(axis)) continue;
    AxisPoint b = a;
    b[axis] += random(-170, 170);
    const MachineChain::Turn turn = chain.onlyTurn(a, b);
    ASSERT_EQ(turn.axis, axis);
    const auto rotation =
        Eigen::AngleAxisd(degToRad(turn.sign * (b[axis] - a[axis])), turn.direction).toRotationMatrix();
    const Vec3 from = chain.pose(a, 80).tip, to = chain.pose(b, 80).tip;
    ASSERT_LT((turn.point + rotation * (from - turn.point) - to).norm(), 1e-9) << i;
    ++turned;
  }
  EXPECT_GT(turned, 200);
}

TEST(RotaryPair, TurnsOneDirectionIntoAnother) {
  Random random;
  int unreachable = 0;
  for (int i = 0; i < 10000; ++i) {
    const Vec3 first = random.direction(), second = random.direction(), from = random.direction();
    const double a = random(-180, 180), b = random(-180, 180);
    const auto turn = [](const Vec3& axis, double deg) {
      return Eigen::AngleAxisd(degToRad(deg), axis).toRotationMatrix();
    };
    const Vec3 to = turn(first, a) * turn(second, b) * from;
    const AnglePairs pairs = solveAngles(first, second, from, to);
    ASSERT_GE(pairs.count, 1) << i;
    bool found = false;
    for (int k = 0; k < pairs.count; ++k) {
      const AnglePair& pair = pairs.pair[static_cast<std::size_t>(k)];
      const double off = (turn(first, pair.first) * turn(second, pair.second) * from - to).norm();
      ASSERT_LT(off, 1e-7) << i;  // where both solutions are one, angles lose half of their digits
      found = found ||
              std::hypot(std::remainder(pair.first - a, 360), std::remainder(pair.second - b, 360)) < 1e-3;
    }
    ASSERT_TRUE(found) << i;
    unreachable += solveAngles(first, second, from, random.direction()).count == 0 ? 1 : 0;
  }
  EXPECT_GT(unreachable, 1000);
}

TEST(RotaryPair, InclinedHeadsAsTheManualHasThem) {
  const double half = std::sqrt(0.5);
  const Vec3 first = Vec3::UnitY(), second(0, half, half);
  const Vec3 t(0.5, 0.5, half);
  const AnglePairs pairs = solveAngles(first, second, Vec3::UnitZ(), t);
  ASSERT_EQ(pairs.count, 2);
  const bool swapped = pairs.pair[0].first > 0;
  const AnglePair &low = pairs.pair[swapped ? 1 : 0], &high = pairs.pair[swapped ? 0 : 1];
  EXPECT_NEAR(low.first, -19.4712, 5e-5);
  EXPECT_NEAR(low.second, 90, 5e-5);
  EXPECT_NEAR(high.first, 90, 5e-5);
  EXPECT_NEAR(high.second, -90, 5e-5);
  EXPECT_EQ(solveAngles(first, second, Vec3::UnitZ(), Vec3(0, -0.9, -0.43).normalized()).count, 0);
  EXPECT_EQ(solveAngles(first, first, Vec3::UnitZ(), t).count, 0);
}

TEST(RotaryPair, AnAxisAlongTheToolIsFree) {
  const AnglePairs up = solveAngles(Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitZ());
  ASSERT_EQ(up.count, 1);
  EXPECT_TRUE(up.pair[0].first_free);
  EXPECT_NEAR(up.pair[0].second, 0.0, 1e-9);
}

TEST(MachineFaults, AreFound) {
  const auto keyOf = [](const MachineModel& model) {
    const std::vector<MachineFault> faults = machineFaults(model);
    return faults.empty() ? std::string() : std::string(faults.front().key);
  };
  EXPECT_EQ(keyOf(test::machineCB()), "");
  MachineModel m = test::machineCB();
  m.axes[3].on = 4;
  m.axes[4].on = 3;
  EXPECT_EQ(keyOf(m), "on");
  m = test::machineCB();
  m.axes[3].on = 17;
  EXPECT_EQ(keyOf(m), "on");
  m = test::machineCB();
  m.axes[4].side = AxisSide::kPart;
  EXPECT_EQ(keyOf(m), "on");
  m = test::machineCB();
  m.axes[4].direction = Vec3::Zero();
  EXPECT_EQ(keyOf(m), "direction");
  m = test::machineCB();
  m.axes[4].travel = AxisLimit{10, -10};
  EXPECT_EQ(keyOf(m), "travel");
  m = test::machineCB();
  m.axes[4].travel = AxisLimit{-90, 90};
  m.axes[4].step = 7;
  EXPECT_EQ(keyOf(m), "step");
  m = test::machineCB();
  m.axes[4].name = "C";
  EXPECT_EQ(keyOf(m), "name");
  m = test::machineCB();
  m.axes.erase(m.axes.begin());
  EXPECT_EQ(keyOf(m), "axis");
}

}  // namespace
}  // namespace proveout
