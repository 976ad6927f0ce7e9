#include "core/nc/frames.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

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

Mat3 basicRotation(const Vec3& angles_deg) {
  if (angles_deg == Vec3::Zero()) return Mat3::Identity();
  const auto turn = [&](int axis) { return Eigen::AngleAxisd(degToRad(angles_deg[axis]), Vec3::Unit(axis)); };
  return (turn(2) * turn(1) * turn(0)).toRotationMatrix();
}

WorkSystem& WorkFrames::system(WorkSystemId id) {
  if (id == 0) return common;
  if (id >= kFirstExtended) return extended[id - kFirstExtended + 1];
  return basic[static_cast<std::size_t>(id - 1)];
}

WorkSystem WorkFrames::system(WorkSystemId id) const {
  if (id == 0) return common;
  if (id < kFirstExtended) return basic[static_cast<std::size_t>(id - 1)];
  const auto it = extended.find(id - kFirstExtended + 1);
  return it == extended.end() ? WorkSystem{} : it->second;
}

CoordinateChain WorkFrames::chain(WorkSystemId active, const Vec3& length) const {
  const WorkSystem work = system(active);
  const FrameStep local{Mat3::Identity(), shift52 + shift92};
  const FrameStep rotate{basicRotation(work.angles_deg), common.offset + work.offset + length};
  return CoordinateChain({local}, {rotate});
}

}  // namespace proveout::nc
