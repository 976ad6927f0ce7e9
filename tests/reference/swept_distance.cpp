#include "tests/reference/swept_distance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/golden_section.h"

namespace proveout::reference {

namespace {

/// Steps of numeric slopes.
constexpr double kStep = 1e-5;
/// Surfaces this near to a point may be those that meet there.
constexpr double kActive = 0.03;
/// Surfaces that meet differ in their directions by this at the least (the sine of 3 degrees).
constexpr double kMeets = 0.05;
/// From where an edge of one body is looked at.
constexpr double kLookFrom = 0.05;

Vec3 slopeOf(const std::function<double(const Vec3&)>& f, const Vec3& p) {
  Vec3 slope;
  for (int k = 0; k < 3; ++k) {
    const Vec3 step = kStep * Vec3::Unit(k);
    slope[k] = (f(p + step) - f(p - step)) / (2.0 * kStep);
  }
  return slope;
}

double toBox(const Vec3& low, const Vec3& high, const Vec3& p) {
  return (low - p).cwiseMax(p - high).cwiseMax(Vec3::Zero()).norm();
}

}  // namespace

SweptPart::SweptPart(Section section, const Toolpath& path, const Motion& motion)
    : section_(std::move(section)), motion_(motion), path_(&path) {
  const Box3 way = path.bounds(motion);
  const double r = section_.widest();
  low_ = way.min - Vec3(r, r, -section_.start.y());
  high_ = way.max + Vec3(r, r, section_.pieces.back().to.y());
}

double SweptPart::atLeast(const Vec3& p) const { return toBox(low_, high_, p); }

Vec3 SweptPart::tip(double t) const { return motion_.from + t * (motion_.to - motion_.from); }

double SweptPart::at(const Vec3& p, double t) const {
  const Vec3 d = p - tip(t);
  return section_.distance({d.head<2>().norm(), d.z()});
}

double SweptPart::distance(const Vec3& p) const {
  const double z = p.z() - motion_.from.z();
  if (motion_.arc >= 0) {
    const ArcGeometry& arc = path_->arcs[static_cast<std::size_t>(motion_.arc)];
    const Vec2 start = (motion_.from - arc.center).head<2>(), at = (p - arc.center).head<2>();
    const double sweep = arc.normal.z() * arc.sweep_rad;
    double turn = std::atan2(at.y(), at.x()) - std::atan2(start.y(), start.x());
    if (sweep < 0.0) turn = -turn;
    turn -= 2 * kPi * std::floor(turn / (2 * kPi));
    const double beside = turn <= std::abs(sweep) ? std::abs(at.norm() - start.norm())
                                                  : std::min((p - motion_.from).head<2>().norm(),
                                                             (p - motion_.to).head<2>().norm());
    return section_.distance({beside, z});
  }
  const Vec2 way = (motion_.to - motion_.from).head<2>();
  if (motion_.to.z() == motion_.from.z()) {
    const double s = std::clamp((p - motion_.from).head<2>().dot(way) / way.squaredNorm(), 0.0, 1.0);
    return at(p, s);
  }
  constexpr double kPlace = 1e-9;
  return at(p, test::leastAt([&](double t) { return at(p, t); }, 0.0, 1.0, kPlace));
}

ExactPart::ExactPart(const SmallProgram& program) : program_(program) {
  for (const Motion& motion : program_.path.motions) {
    const Tool& tool = program_.tools[static_cast<std::size_t>(motion.tool - 1)];
    for (const Section& section : sectionsOf(tool)) parts_.emplace_back(section, program_.path, motion);
  }
}

double ExactPart::distance(const Vec3& p) const {
  double swept = std::numeric_limits<double>::infinity();
  for (const SweptPart& part : parts_) {
    // Of several that hold it, the one that it is deepest in counts.
    if (part.atLeast(p) <= std::max(swept, 0.0)) swept = std::min(swept, part.distance(p));
  }
  const BoxShape& b = program_.block;
  return std::max(-swept, (b.min - p).cwiseMax(p - b.max).maxCoeff());
}

double ExactPart::off(const Vec3& p) const {
  constexpr double kNear = 2e-4;  // below what any test asks
  const double value = distance(p);
  if (std::abs(value) < kNear) return std::abs(value);
  const double slope = slopeOf([this](const Vec3& q) { return distance(q); }, p).norm();
  return std::abs(value) / std::clamp(slope, 0.5, 1.0);
}

Vec3 ExactPart::onEdge(const Vec3& p, const Vec3& normal) const {
  using Surface = std::function<double(const Vec3&)>;
  std::vector<Surface> active;
  const auto add = [&](const Surface& f) {
    if (std::abs(f(p)) < kActive) active.push_back(f);
  };
  for (const SweptPart& part : parts_) add([&part](const Vec3& q) { return part.distance(q); });
  const BoxShape& b = program_.block;
  for (int k = 0; k < 3; ++k) {
    add([&b, k](const Vec3& q) { return b.min[k] - q[k]; });
    add([&b, k](const Vec3& q) { return q[k] - b.max[k]; });
  }
  const auto isOn = [&](const Vec3& q) { return (q - p).norm() < kActive && std::abs(distance(q)) < 1e-4; };
  Vec3 at = p;
  for (int round = 0; round < 6 && active.size() >= 2; ++round) {
    Eigen::MatrixXd slopes(active.size(), 3);
    Eigen::VectorXd values(active.size());
    for (std::size_t i = 0; i < active.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      values[row] = active[i](at);
      slopes.row(row) = slopeOf(active[i], at).transpose();
    }
    Eigen::JacobiSVD<Eigen::MatrixXd> svd(slopes, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(kMeets);
    if (svd.rank() < 2) break;
    at -= svd.solve(values);
    if (round == 5 && isOn(at)) return at;
  }
  // An edge of one body, seen from the material.
  const Vec3 from = p - kLookFrom * normal;
  const SweptPart* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const SweptPart& part : parts_) {
    const double d = part.atLeast(from) < least ? part.distance(from) : least;
    if (d < least) least = d, nearest = &part;
  }
  if (nearest == nullptr || least <= 0.0) return p;
  at = from - least * slopeOf([&](const Vec3& q) { return nearest->distance(q); }, from).normalized();
  return isOn(at) ? at : p;
}

}  // namespace proveout::reference
