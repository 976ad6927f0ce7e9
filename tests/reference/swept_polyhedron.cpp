#include "tests/reference/swept_polyhedron.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

namespace proveout::reference {

namespace {

using Contour = std::vector<Vec2>;

Vec2 direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Part of a circle, counter-clockwise.
void addTurn(const Vec2& center, double radius, double from, double to, double step, Contour& out) {
  const TrueChords chords(from, to, step);
  for (std::size_t i = 0; i < chords.size(); ++i)
    out.push_back(center + radius * chords.scale[i] * direction(chords.angle[i]));
}

/// All points within `radius` of a level segment; where it goes on from another, less what is behind its
/// start.
Contour aroundSegment(const Vec2& from, const Vec2& to, double radius, double step, bool goes_on) {
  const Vec2 way = to - from;
  const double ahead = std::atan2(way.y(), way.x());
  Contour out;
  addTurn(to, radius, ahead - kPi / 2, ahead + kPi / 2, step, out);
  if (goes_on) {
    out.push_back(from + radius * direction(ahead + kPi / 2));
    out.push_back(from + radius * direction(ahead - kPi / 2));
  } else {
    addTurn(from, radius, ahead + kPi / 2, ahead + 1.5 * kPi, step, out);
  }
  return out;
}

/// A level arc, counter-clockwise from `first` to `last`; without what is behind either end where it goes on
/// there.
struct Arc {
  Vec2 center;
  double radius, first, last;
  bool goes_on_first = false, goes_on_last = false;
};

/// The round end at an angle of an arc, counter-clockwise from `from` by half a turn; without its two ends,
/// which the arc's sides have. Found anew they differ in their last digit, and slivers are left beside a part
/// that goes on from them: they looked like edges.
void addEnd(const Arc& arc, double at, double radius, double from, double step, Contour& out) {
  Contour end;
  addTurn(arc.center + arc.radius * direction(at), radius, from, from + kPi, step, end);
  out.insert(out.end(), end.begin() + 1, end.end() - 1);
}

Contour aroundArc(const Arc& arc, double radius, double step) {
  Contour out, back;
  addTurn(arc.center, arc.radius + radius, arc.first, arc.last, step, out);
  if (!arc.goes_on_last) addEnd(arc, arc.last, radius, arc.last, step, out);
  addTurn(arc.center, arc.radius - radius, arc.first, arc.last, step, back);
  out.insert(out.end(), back.rbegin(), back.rend());
  if (!arc.goes_on_first) addEnd(arc, arc.first, radius, arc.first + kPi, step, out);
  return out;
}

/// Joints between pieces are there twice.
void dropRepeated(std::vector<Contour>& contours) {
  constexpr double kSame = 1e-9;
  const std::size_t n = contours.front().size();
  std::vector<bool> drop(n);
  for (std::size_t i = 0; i < n; ++i) {
    drop[i] = std::all_of(contours.begin(), contours.end(),
                          [&](const Contour& c) { return (c[i] - c[(i + 1) % n]).norm() < kSame; });
  }
  for (Contour& c : contours) {
    Contour kept;
    for (std::size_t i = 0; i < n; ++i) {
      if (!drop[i]) kept.push_back(c[i]);
    }
    c = std::move(kept);
  }
}

/// Walls between contours with as many points each, and lids.
Polyhedron loft(std::vector<Contour> contours, const std::vector<double>& heights) {
  dropRepeated(contours);
  const std::size_t n = contours.front().size();
  Polyhedron out;
  for (std::size_t k = 0; k < contours.size(); ++k) {
    for (const Vec2& p : contours[k]) out.points.emplace_back(p.x(), p.y(), heights[k]);
  }
  for (std::size_t k = 0; k + 1 < contours.size(); ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n, low = k * n, high = low + n;
      out.faces.push_back({low + i, low + j, high + j, high + i});
    }
  }
  std::vector<std::size_t> bottom(n), top(n);
  for (std::size_t i = 0; i < n; ++i) {
    bottom[i] = n - 1 - i;
    top[i] = (contours.size() - 1) * n + i;
  }
  out.faces.push_back(bottom);
  out.faces.push_back(top);
  return out;
}

Polyhedron loftOf(const std::vector<Vec2>& levels, double tip,
                  const std::function<Contour(double)>& contour) {
  std::vector<Contour> contours;
  std::vector<double> heights;
  for (const Vec2& level : levels) {
    contours.push_back(contour(level.x()));
    heights.push_back(tip + level.y());
  }
  return loft(std::move(contours), heights);
}

/// Angles, seen from the way ahead, at which straight pieces of the section leave the surface of a slope:
/// there are vertices, so that its silhouette is no chord. Symmetrical, growing, and all around.
std::vector<double> silhouettes(const Section& section, double slope) {
  constexpr double kApart = 1e-6;
  std::vector<double> half = {kPi / 2};
  Vec2 from = section.start;
  for (const Section::Piece& piece : section.pieces) {
    const Vec2 way = piece.to - from;
    from = piece.to;
    if (piece.center || way.y() == 0.0) continue;
    const double cosine = way.x() / way.y() * slope;
    if (std::abs(cosine) < 1.0) half.push_back(std::acos(cosine));
  }
  std::vector<double> all;
  for (const double angle : half) {
    all.push_back(angle);
    all.push_back(2 * kPi - angle);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < kApart; }),
            all.end());
  all.push_back(all.front() + 2 * kPi);
  return all;
}

/// Whether a body that goes this way faces ahead at a level, in a direction from the axis, or nearly.
bool facesAhead(const std::vector<Vec2>& levels, std::size_t k, double cosine, const Vec2& way,
                double margin) {
  const bool bottom = k == 0 && way.y() < 0.0, top = k + 1 == levels.size() && way.y() > 0.0;
  const auto ahead = [&](std::size_t i) {  // from this level to the next
    const Vec2 along = (levels[i + 1] - levels[i]).normalized();
    return along.y() * cosine * way.x() - along.x() * way.y() > (way.x() > 0.0 ? -margin : 1e-9);
  };
  return bottom || top || (k > 0 && ahead(k - 1)) || (k + 1 < levels.size() && ahead(k));
}

/// The part at both ends of the way; a convex part on a line sweeps what their hull is. `ahead`: the angle of
/// its way.
Polyhedron hullOf(const Section& section, const Motion& motion, double ahead, double step, bool goes_on) {
  const Vec3 way = motion.to - motion.from;
  const double flat = way.head<2>().norm();
  const Vec2 slope = Vec2(flat, way.z()).normalized();
  const std::vector<double> breaks = silhouettes(section, flat > 0.0 ? way.z() / flat : 0.0);
  const std::vector<Vec2> levels = levelsOf(section, step);
  Polyhedron out;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    Contour ring;
    for (std::size_t i = 1; i < breaks.size(); ++i)
      addTurn(Vec2::Zero(), levels[k].x(), ahead + breaks[i - 1], ahead + breaks[i], step, ring);
    for (const Vec2& p : ring) {
      const Vec3 from_tip(p.x(), p.y(), levels[k].y());
      const double cosine = p.normalized().dot(direction(ahead));
      if (!goes_on || facesAhead(levels, k, cosine, slope, 2.0 * step))
        out.points.push_back(motion.from + from_tip);
      out.points.push_back(motion.to + from_tip);
    }
  }
  return out;
}

/// What a ball sweeps from one point to another, with rings across the way, which is its silhouette.
Polyhedron capsule(const Vec3& from, const Vec3& to, double radius, double step, bool goes_on) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), to - from);
  Section ball;
  ball.arc(0.0, radius, radius, radius);
  std::vector<Vec2> levels = levelsOf(ball, step);
  const std::size_t half = levels.size();
  const double length = (to - from).norm();
  for (std::size_t i = half; i-- > 0;) levels.push_back({levels[i].x(), 2 * radius + length - levels[i].y()});
  if (goes_on) levels.erase(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(half) - 1);
  Polyhedron out = loftOf(
      levels, -radius, [&](double r) { return aroundSegment(Vec2::Zero(), Vec2::Zero(), r, step, false); });
  for (Vec3& p : out.points) p = from + turn * p;
  return out;
}

/// Without what is higher than `height` above its tip.
Section below(const Section& section, double height) {
  Section out;
  out.start = section.start;
  Vec2 from = section.start;
  for (const Section::Piece& piece : section.pieces) {
    if (piece.to.y() > height && !piece.center) {
      const double part = (height - from.y()) / (piece.to.y() - from.y());
      out.pieces.push_back({from + part * (piece.to - from), std::nullopt});
      return out;
    }
    out.pieces.push_back(piece);
    from = piece.to;
    if (from.y() >= height) return out;
  }
  return out;
}

std::vector<Polyhedron> sweepSlope(const Section& section, const Motion& motion, double ahead, double step,
                                   bool goes_on) {
  constexpr double kAboveTop = 0.5;
  const Section used = below(section, kAboveTop - std::min(motion.from.z(), motion.to.z()));
  const bool vertical = (motion.to - motion.from).head<2>().isZero();
  const Section::Piece& nose = used.pieces.front();
  if (vertical || used.start.x() > 0.0 || !nose.center || nose.to.y() > nose.center->y()) {
    const bool round = std::any_of(used.pieces.begin(), used.pieces.end(), [](auto& p) { return p.center; });
    return {hullOf(used, motion, ahead, !vertical && round ? step / 2.0 : step, goes_on)};
  }
  const Vec3 up(0.0, 0.0, nose.center->y());
  std::vector<Polyhedron> out = {capsule(motion.from + up, motion.to + up, up.z(), step, goes_on)};
  if (used.pieces.size() == 1) return out;
  Section rest;
  rest.start = nose.to;
  rest.pieces.assign(used.pieces.begin() + 1, used.pieces.end());
  out.push_back(hullOf(rest, motion, ahead, step, goes_on));
  return out;
}

/// In the order in which they are gone along.
std::vector<Arc> partsOf(const Vec3& from, const ArcGeometry& arc, bool goes_on) {
  constexpr double kMost = 0.6 * kPi;  // of one part
  const Vec2 out = (from - arc.center).head<2>();
  const double at = std::atan2(out.y(), out.x()), sweep = arc.normal.z() * arc.sweep_rad;
  const int n = static_cast<int>(std::ceil(std::abs(sweep) / kMost));
  std::vector<Arc> parts;
  for (int i = 0; i < n; ++i) {
    const double a = at + sweep * i / n, b = at + sweep * (i + 1) / n;
    const bool on = i > 0 || goes_on;
    parts.push_back({arc.center.head<2>(), out.norm(), std::min(a, b), std::max(a, b), on && sweep > 0.0,
                     on && sweep < 0.0});
  }
  return parts;
}

/// Angle of the way at the end of a motion; 0 on verticals.
double endsAhead(const Toolpath& path, const Motion& motion) {
  Vec2 way = (motion.to - motion.from).head<2>();
  if (motion.arc >= 0) {
    const ArcGeometry& arc = path.arcs[static_cast<std::size_t>(motion.arc)];
    const Vec2 out = (motion.to - arc.center).head<2>();
    way = Vec2(-out.y(), out.x()) * arc.normal.z() * arc.sweep_rad;
  }
  return way.isZero() ? 0.0 : std::atan2(way.y(), way.x());
}

}  // namespace

std::vector<Polyhedron> sweep(const Section& section, const Toolpath& path, std::size_t number, double step) {
  const Motion& motion = path.motions[number];
  const Motion* const before =
      number > 0 && path.motions[number - 1].tool == motion.tool && path.motions[number - 1].to == motion.from
          ? &path.motions[number - 1]
          : nullptr;
  const bool goes_on = before != nullptr;
  const double tip = motion.from.z();
  if (motion.arc < 0) {
    const Vec3 way = motion.to - motion.from;
    const bool vertical = way.head<2>().isZero();
    if (way.z() != 0.0 || vertical) {
      // A vertical has the facets of what it goes on from, whose walls are its own.
      const double ahead = endsAhead(path, vertical && goes_on ? *before : motion);
      return sweepSlope(section, motion, ahead, step, goes_on);
    }
    return {loftOf(levelsOf(section, step), tip, [&](double r) {
      return aroundSegment(motion.from.head<2>(), motion.to.head<2>(), r, step, goes_on);
    })};
  }
  std::vector<Polyhedron> parts;
  for (const Arc& arc : partsOf(motion.from, path.arcs[static_cast<std::size_t>(motion.arc)], goes_on))
    parts.push_back(loftOf(levelsOf(section, step), tip, [&](double r) { return aroundArc(arc, r, step); }));
  return parts;
}

}  // namespace proveout::reference
