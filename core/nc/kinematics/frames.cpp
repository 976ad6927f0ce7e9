#include "core/nc/kinematics/frames.h"

#include <Eigen/LU>

#include "core/base/assert.h"
#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

FrameStep compose(const std::vector<FrameStep>& steps) {
  FrameStep all;
  for (const FrameStep& s : steps) {
    all.linear = s.linear * all.linear;
    all.offset = s.linear * all.offset + s.offset;
  }
  return all;
}

bool movesOnly(const FrameStep& step) { return step.linear == Mat3::Identity(); }

}  // namespace

CoordinateChain::CoordinateChain(const std::vector<FrameStep>& program_to_work,
                                 const std::vector<FrameStep>& work_to_machine)
    : work_(compose(program_to_work)),
      machine_(compose(work_to_machine)),
      work_moves_only_(movesOnly(work_)),
      machine_moves_only_(movesOnly(machine_)) {}

Vec3 CoordinateChain::toProgram(const Vec3& machine) const {
  Vec3 q = machine - machine_.offset;
  if (!machine_moves_only_) q = machine_.linear.inverse() * q;
  q -= work_.offset;
  if (!work_moves_only_) q = work_.linear.inverse() * q;
  return q;
}

void CoordinateChain::moveFurtherAxes(int count, const AxisPoint& program_to_work,
                                      const AxisPoint& work_to_machine) {
  PROVEOUT_ASSERT(count >= 0 && count <= kMaxAxes - kMainAxes);
  more_count_ = count;
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    work_more_[k] = program_to_work.more[k];
    machine_more_[k] = work_to_machine.more[k];
    work_factor_[k] = 1.0;
  }
}

void CoordinateChain::scaleFurtherAxes(const ProgramMap& map, const AxisPoint& shift) {
  pair_ = map.pair;
  if (pair_.u >= 0) pair_.offset += pair_.of(shift);
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_count_); ++k) {
    work_factor_[k] = map.factor[k];
    work_more_[k] += map.shift[k];
  }
}

void CoordinateChain::turnFurtherAxes(const AxisMap& map) {
  for (int name = 0; name < kMainAxes + more_count_; ++name)
    against_.set(static_cast<std::size_t>(name), map.signOf(name) < 0.0);
}

bool CoordinateChain::turnsArcs(int u, int v) const {
  if (against_.none()) return false;
  if (u < kMainAxes && v < kMainAxes) return machine_.linear.determinant() < 0.0;
  return against_.test(static_cast<std::size_t>(u)) != against_.test(static_cast<std::size_t>(v));
}

AxisPoint CoordinateChain::workOf(const AxisPoint& p) const {
  AxisPoint q = p;
  moveToWork(q);
  return q;
}

void CoordinateChain::moveToWork(AxisPoint& p) const {
  const bool paired = pair_.u >= 0;
  const Vec2 uv = paired ? Vec2(pair_.linear * pair_.of(p) + pair_.offset) : Vec2();
  p.xyz = toWork(p.xyz);
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_count_); ++k)
    p.more[k] = p.more[k] * work_factor_[k] + work_more_[k];
  if (!paired) return;
  p[pair_.u] = uv.x();
  p[pair_.v] = uv.y();
}

void CoordinateChain::moveToMachine(AxisPoint& p) const {
  p.xyz = workToMachine(p.xyz);
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_count_); ++k)
    p.more[k] = senseOf(k) * p.more[k] + machine_more_[k];
}

AxisPoint CoordinateChain::machineOf(const AxisPoint& p) const {
  if (pair_.u >= 0) {
    AxisPoint q = p;
    moveToWork(q);
    moveToMachine(q);
    return q;
  }
  AxisPoint q(toMachine(p.xyz));
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_count_); ++k) {
    q.more[k] = senseOf(k) * (p.more[k] * work_factor_[k] + work_more_[k]) + machine_more_[k];
  }
  return q;
}

AxisPoint CoordinateChain::programOf(const AxisPoint& machine) const {
  AxisPoint p(toProgram(machine.xyz));
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_count_); ++k) {
    p.more[k] = (senseOf(k) * (machine.more[k] - machine_more_[k]) - work_more_[k]) / work_factor_[k];
  }
  if (pair_.u < 0) return p;
  AxisPoint work(machine.xyz - machine_.offset);
  if (!machine_moves_only_) work.xyz = machine_.linear.inverse() * work.xyz;
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_count_); ++k)
    work.more[k] = senseOf(k) * (machine.more[k] - machine_more_[k]);
  const Vec2 uv = pair_.linear.inverse() * (pair_.of(work) - pair_.offset);
  p[pair_.u] = uv.x();
  p[pair_.v] = uv.y();
  return p;
}

Mat3 basicRotation(const Vec3& angles_deg) {
  if (angles_deg == Vec3::Zero()) return Mat3::Identity();
  const auto turn = [&](int axis) {
    const auto [s, c] = sinCosDegrees(angles_deg[axis]);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Mat3 m = Mat3::Identity();
    m(u, u) = m(v, v) = c;
    m(u, v) = -s;
    m(v, u) = s;
    return m;
  };
  return turn(2) * turn(1) * turn(0);
}

WorkSystem& WorkFrames::system(WorkSystemId id) {
  if (id == 0) return common;
  if (id >= kFirstExtended) return extended[id - kFirstExtended + 1];
  PROVEOUT_ASSERT(id > 0 && static_cast<std::size_t>(id) <= basic.size());
  return basic[static_cast<std::size_t>(id - 1)];
}

WorkSystem WorkFrames::system(WorkSystemId id) const {
  if (id == 0) return common;
  if (id < kFirstExtended) {
    PROVEOUT_ASSERT(id > 0 && static_cast<std::size_t>(id) <= basic.size());
    return basic[static_cast<std::size_t>(id - 1)];
  }
  const auto it = extended.find(id - kFirstExtended + 1);
  return it == extended.end() ? WorkSystem{} : it->second;
}

namespace {

/// Points by axis as points by name.
AxisPoint zeroByName(const AxisMap& axes, const AxisPoint& common, const AxisPoint& work) {
  AxisPoint zero(common.xyz + work.xyz);
  for (std::size_t k = 0; k < zero.more.size(); ++k) zero.more[k] = common.more[k] + work.more[k];
  return axes.namesAt(zero);
}

/// From work to machine where axes are exchanged or reversed: the length lies along the programmed
/// directions, the zero is a place of the machine.
FrameStep turnedStep(const AxisMap& axes, const Mat3& basic_turn, const AxisPoint& zero,
                     const AxisPoint& length) {
  const Vec3 signs(axes.signOf(0), axes.signOf(1), axes.signOf(2));
  return {signs.asDiagonal() * basic_turn, zero.xyz + signs.cwiseProduct(length.xyz)};
}

}  // namespace

CoordinateChain WorkFrames::chain(const ProgramMap& map, WorkSystemId active, const AxisPoint& length,
                                  const SpatialFrames* spatial) const {
  const WorkSystem work = system(active);
  const AxisPoint zero = axes.named() ? AxisPoint() : zeroByName(axes, common.offset, work.offset);
  const FrameStep transform{map.linear, map.offset};
  const FrameStep local{Mat3::Identity(), shift52.xyz + shift92.xyz};
  const Mat3 basic_turn = basicRotation(work.angles_deg);
  std::vector<FrameStep> to_machine;
  if (spatial != nullptr) {
    to_machine = {
        spatial->tilt, {basic_turn, Vec3::Zero()}, spatial->zero, {Mat3::Identity(), spatial->length}};
  } else if (!axes.named()) {
    to_machine = {turnedStep(axes, basic_turn, zero, length)};
  } else {
    to_machine = {{basic_turn, common.offset.xyz + work.offset.xyz + length.xyz}};
  }
  CoordinateChain chain({transform, local}, to_machine);
  AxisPoint shift, offset;
  for (std::size_t k = 0; k < static_cast<std::size_t>(more_axes); ++k) {
    shift.more[k] = shift52.more[k] + shift92.more[k];
    offset.more[k] =
        (spatial != nullptr ? spatial->rotary_offset.more[k] : common.offset.more[k] + work.offset.more[k]) +
        length.more[k];
  }
  if (!axes.named()) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(more_axes); ++k)
      offset.more[k] = zero.more[k] + axes.signOf(kMainAxes + static_cast<int>(k)) * length.more[k];
  }
  chain.moveFurtherAxes(more_axes, shift, offset);
  if (!axes.named()) chain.turnFurtherAxes(axes);
  if (!map.identity) {
    shift.xyz = shift52.xyz + shift92.xyz;
    chain.scaleFurtherAxes(map, shift);
  }
  return chain;
}

}  // namespace proveout::nc
