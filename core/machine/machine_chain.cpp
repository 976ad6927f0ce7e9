#include "core/machine/machine_chain.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/rigid_transform.h"

namespace proveout {

namespace {

/// Angles closer than this are one: far below any increment (1e-6 deg), above rounding noise.
constexpr double kSameAngleDeg = 1e-9;

/// The axes from the bed to the end of a side that `last` stands on, outermost first.
std::vector<int> fromEnd(const MachineModel& model, int last) {
  std::vector<int> out;
  for (int k = last; k != kOnBed && out.size() < model.axes.size();
       k = model.axes[static_cast<std::size_t>(k)].on)
    out.push_back(k);
  return out;
}

/// The axis at the end of the part's side: the one from which most others are passed on the way to the bed.
int partEnd(const MachineModel& model) {
  int end = kOnBed;
  std::size_t most = 0;
  for (std::size_t k = 0; k < model.axes.size(); ++k) {
    if (model.axes[k].side != AxisSide::kPart) continue;
    const std::size_t length = fromEnd(model, static_cast<int>(k)).size();
    if (length > most) {
      most = length;
      end = static_cast<int>(k);
    }
  }
  return end;
}

}  // namespace

MachineChain::MachineChain(const MachineModel& model, const Vec3& origin)
    : gauge_(model.spindle.gauge - origin), tool_(model.spindle.direction) {
  const auto add = [&](int k) {
    const MachineAxis& axis = model.axes[static_cast<std::size_t>(k)];
    const double sign = (axis.side == AxisSide::kPart) == axis.left ? 1.0 : -1.0;
    links_.push_back({k, axis.kind == AxisKind::kRotary, sign, axis.direction, axis.point - origin});
    if (links_.back().rotary) rotary_.push_back(links_.back());
  };
  for (const int k : fromEnd(model, model.spindle.on)) add(k);
  std::vector<int> part = fromEnd(model, partEnd(model));
  std::ranges::reverse(part);
  for (const int k : part) add(k);
  for (int k = 0; k < 3; ++k)
    level_ = level_ && model.axes[static_cast<std::size_t>(k)].direction == Vec3::Unit(k);
}

bool MachineChain::turns(const AxisPoint& a, const AxisPoint& b) const {
  return std::ranges::any_of(rotary_,
                             [&](const Link& l) { return std::abs(a[l.axis] - b[l.axis]) > kSameAngleDeg; });
}

bool MachineChain::atZero(const AxisPoint& machine) const {
  return std::ranges::all_of(rotary_, [&](const Link& l) {
    return std::abs(std::remainder(machine[l.axis], 360.0)) <= kSameAngleDeg;
  });
}

double MachineChain::turned(const AxisPoint& a, const AxisPoint& b) const {
  double sum = 0.0;
  for (const Link& l : rotary_) sum += std::abs(b[l.axis] - a[l.axis]);
  return degToRad(sum);
}

bool MachineChain::carries(int axis) const {
  return std::ranges::any_of(rotary_, [&](const Link& l) { return l.axis == axis; });
}

Vec3 MachineChain::through(const Link& link, const AxisPoint& machine, const Vec3& p) const {
  const double at = machine[link.axis];
  if (at == 0.0) return p;
  if (!link.rotary) return p + at * link.direction;
  return link.point + turnAbout(link.direction, link.sign * at) * (p - link.point);
}

Vec3 MachineChain::point(const AxisPoint& machine, const Vec3& at_zero) const {
  Vec3 p = at_zero;
  for (const Link& link : links_) p = through(link, machine, p);
  return p;
}

Vec3 MachineChain::direction(const AxisPoint& machine, const Vec3& at_zero) const {
  Vec3 d = at_zero;
  for (const Link& link : rotary_) {
    const double at = machine[link.axis];
    if (at != 0.0) d = turnAbout(link.direction, link.sign * at) * d;
  }
  // Upright is upright, whatever the last digit says: much depends on it.
  if ((d - Vec3::UnitZ()).norm() < 1e-12) return Vec3::UnitZ();
  return d;
}

MachineChain::PointMotion MachineChain::follow(const AxisPoint& from, const AxisPoint& to, double share,
                                               const Vec3& at_zero) const {
  PointMotion p{at_zero, Vec3::Zero()};
  for (const Link& link : links_) {
    const double way = to[link.axis] - from[link.axis],
                 at = share >= 1.0 ? to[link.axis] : from[link.axis] + share * way;
    if (!link.rotary) {
      p.at += at * link.direction;
      p.velocity += way * link.direction;
      continue;
    }
    if (at == 0.0 && way == 0.0) continue;
    const Eigen::Matrix3d turn = turnAbout(link.direction, link.sign * at);
    const Vec3 arm = turn * (p.at - link.point);
    p.at = link.point + arm;
    p.velocity = turn * p.velocity + degToRad(link.sign * way) * link.direction.cross(arm);
  }
  return p;
}

MachineChain::PointMotion MachineChain::followDirection(const AxisPoint& from, const AxisPoint& to,
                                                        double share, const Vec3& at_zero) const {
  PointMotion d{at_zero, Vec3::Zero()};
  for (const Link& link : rotary_) {
    const double way = to[link.axis] - from[link.axis],
                 at = share >= 1.0 ? to[link.axis] : from[link.axis] + share * way;
    if (at == 0.0 && way == 0.0) continue;
    const Eigen::Matrix3d turn = turnAbout(link.direction, link.sign * at);
    d.at = turn * d.at;
    d.velocity = turn * d.velocity + degToRad(link.sign * way) * link.direction.cross(d.at);
  }
  return d;
}

MachineChain::MotionBounds MachineChain::pointBounds(const AxisPoint& from, const AxisPoint& to, double low,
                                                     double high, const Vec3& at_zero) const {
  const double middle = 0.5 * (low + high), reach = 0.5 * (high - low);
  Vec3 at = at_zero;  // in the middle
  MotionBounds b;
  for (const Link& link : links_) {
    const double way = to[link.axis] - from[link.axis], there = from[link.axis] + middle * way;
    if (!link.rotary) {
      at += there * link.direction;
      b.velocity += std::abs(way);
      continue;
    }
    const Vec3 arm = turnAbout(link.direction, link.sign * there) * (at - link.point);
    at = link.point + arm;
    const double rate = std::abs(degToRad(way));
    // The point is no farther from the axis than it may have come from where it is in the middle.
    const double radius = link.direction.cross(arm).norm() + reach * b.velocity;
    b.acceleration += 2.0 * rate * b.velocity + rate * rate * radius;
    b.velocity += rate * radius;
  }
  return b;
}

MachineChain MachineChain::moved(const RigidTransform& move) const {
  MachineChain out = *this;
  for (std::vector<Link>* links : {&out.links_, &out.rotary_}) {
    for (Link& link : *links) {
      link.point = move(link.point);
      link.direction = move.rotation * link.direction;
    }
  }
  out.gauge_ = move(gauge_);
  out.tool_ = move.rotation * tool_;
  out.level_ = false;
  return out;
}

MachineChain::Turn MachineChain::onlyTurn(const AxisPoint& a, const AxisPoint& b) const {
  Turn out{-1, 1.0, Vec3::Zero(), Vec3::UnitZ()};
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    if (!link.rotary || std::abs(a[link.axis] - b[link.axis]) <= kSameAngleDeg) continue;
    if (out.axis >= 0) return {-1, 1.0, Vec3::Zero(), Vec3::UnitZ()};
    out = {link.axis, link.sign, link.point, link.direction};
    // What is nearer to the part moves the axes of what is farther.
    for (std::size_t k = i + 1; k < links_.size(); ++k) {
      out.point = through(links_[k], a, out.point);
      if (links_[k].rotary)
        out.direction = turnAbout(links_[k].direction, links_[k].sign * a[links_[k].axis]) * out.direction;
    }
  }
  return out;
}

std::vector<MachineChain::Turn> MachineChain::rotaryAxes() const {
  std::vector<Turn> out;
  for (const Link& link : rotary_) out.push_back({link.axis, link.sign, link.point, link.direction});
  return out;
}

}  // namespace proveout
