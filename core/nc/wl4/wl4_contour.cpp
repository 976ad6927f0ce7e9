#include "core/nc/wl4/wl4_contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/nc/services/cutter_comp.h"
#include "core/nc/services/plane_curves.h"

namespace proveout::nc {

namespace {

constexpr double kSame = 1e-6;  ///< mm; levels nearer to each other are one

double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

Vec2 pointAt(const ContourElement& e, double t) {
  if (t <= 0.0) return e.from;
  if (t >= 1.0) return e.to;
  if (!e.arc) return e.from + t * (e.to - e.from);
  const Vec2 arm = e.from - e.center;
  const double angle = angleOf(arm) + t * e.sweep;
  return e.center + arm.norm() * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 directionAt(const ContourElement& e, bool end) {
  if (!e.arc) return (e.to - e.from).normalized();
  const Vec2 arm = ((end ? e.to : e.from) - e.center).normalized();
  return e.sweep > 0.0 ? leftOf(arm) : Vec2(-leftOf(arm));
}

ContourElement part(const ContourElement& e, double t0, double t1) {
  ContourElement out = e;
  out.from = pointAt(e, t0);
  out.to = pointAt(e, t1);
  out.sweep = e.sweep * (t1 - t0);
  return out;
}

ContourElement line(const Vec2& from, const Vec2& to) {
  ContourElement e;
  e.from = from;
  e.to = to;
  return e;
}

CompBlock blockOf(const ContourElement& e, double offset, std::uint64_t tag) {
  CompBlock block;
  block.shape = e.arc ? CompBlock::Shape::kArc : CompBlock::Shape::kLine;
  block.to = Vec3(e.to.x(), e.to.y(), 0.0);
  block.center = e.center;
  block.sweep_rad = e.sweep;
  block.active = true;
  block.offset = offset;
  block.tag = tag;
  return block;
}

/// Of a point from an element, mm.
double distanceTo(const ContourElement& e, const Vec2& p) {
  const double ends = std::min((p - e.from).norm(), (p - e.to).norm());
  if (!e.arc) {
    const Vec2 way = e.to - e.from;
    const double t = std::clamp((p - e.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (p - e.from - t * way).norm();
  }
  const double inside = sweepUntil(e, p);
  return inside <= std::abs(e.sweep)
             ? std::min(ends, std::abs((p - e.center).norm() - (e.from - e.center).norm()))
             : ends;
}

/// Whether the path keeps its distance from the contour, at points of it.
bool keepsDistance(const Wl4Contour& path, const Wl4Contour& contour, double distance) {
  constexpr int kPoints = 16;
  for (const ContourElement& e : path) {
    for (int k = 0; k <= kPoints; ++k) {
      const Vec2 p = pointAt(e, static_cast<double>(k) / kPoints);
      for (const ContourElement& c : contour) {
        if (distanceTo(c, p) < distance - 1e-4) return false;
      }
    }
  }
  return true;
}

bool tooTight(const ContourElement& e, double offset) {
  return e.arc && (e.sweep > 0.0 ? offset : -offset) >= (e.to - e.center).norm();
}

}  // namespace

Result<Wl4Contour> offsetContour(const Wl4Contour& contour, double offset, bool& fits) {
  if (offset == 0.0 || contour.empty()) return contour;
  if (std::any_of(contour.begin(), contour.end(), [&](auto& e) { return tooTight(e, offset); })) {
    return inputError(
        "negative radius under compensation: an arc of the contour is smaller than tool and allowance");
  }
  // Straight ways in and out, tangent to the contour: its first and last corners are none.
  const double lead = 2.0 * std::abs(offset) + 1.0;
  const Vec2 in = directionAt(contour.front(), false), out = directionAt(contour.back(), true);
  const Vec2 start = contour.front().from, end = contour.back().to;
  CutterCompPolicy policy;
  policy.start_ramp = policy.cancel_ramp = CompRamp::kA;
  policy.outer_corner = CompOuterCorner::kArc;
  policy.extra_look_ahead = 8;
  policy.min_step = 0.0;
  CutterComp filter(policy);
  const Vec2 first = start - 2.0 * lead * in;
  filter.reset(Vec3(first.x(), first.y(), 0.0));
  std::vector<CompBlock> blocks = {blockOf(line(first, start - lead * in), offset, 0),
                                   blockOf(line(start - lead * in, start), offset, 0)};
  for (std::size_t k = 0; k < contour.size(); ++k) blocks.push_back(blockOf(contour[k], offset, k + 1));
  const std::uint64_t behind = contour.size() + 1;
  blocks.push_back(blockOf(line(end, end + lead * out), offset, behind));
  blocks.push_back(blockOf(line(end + lead * out, end + 2.0 * lead * out), offset, behind));
  CompOutput pieces;
  CompStatus status;
  for (const CompBlock& block : blocks) {
    if (status = filter.push(block, pieces); !status.ok()) break;
  }
  if (status.ok()) status = filter.flush(pieces);
  if (!status.ok()) return inputError("tool and allowance do not fit into the contour");
  Wl4Contour result;
  for (const CompPiece& piece : pieces.pieces) {
    if (piece.tag == 0 || piece.tag == behind || piece.role == CompPiece::Role::kPassThrough) continue;
    ContourElement e = line(piece.from.head<2>(), piece.to.head<2>());
    e.arc = piece.is_arc;
    e.center = piece.center;
    e.sweep = piece.sweep_rad;
    e.source = contour[piece.tag - 1].source;
    if ((e.to - e.from).norm() > kSame || e.arc) result.push_back(e);
  }
  if (result.empty()) return inputError("tool and allowance leave nothing of the contour");
  fits = fits && pieces.notes.empty() && keepsDistance(result, contour, std::abs(offset));
  return result;
}

void shiftContour(Wl4Contour& contour, const Vec2& by) {
  for (ContourElement& e : contour) {
    e.from += by;
    e.to += by;
    e.center += by;
  }
}

namespace {

/// A stretch of an element on which both coordinates go one way.
struct Monotone {
  std::size_t element;
  double t0, t1;
};

/// The contour by one parameter: k + t in the k-th stretch.
class Roughing {
 public:
  Roughing(const Wl4Contour& contour, const Wl4RoughingRules& rules) : contour_(contour), rules_(rules) {
    for (std::size_t k = 0; k < contour.size(); ++k) split(k);
    side_ = rules.from[rules.depth_axis] >= contour.front().from[rules.depth_axis] ? 1.0 : -1.0;
    at_ = rules.from;
  }

  std::vector<Wl4Pass> run() {
    const double top = level(rules_.from);
    for (const Zone& zone : zonesBelow({0.0, length()}, top)) process(zone, top, top);
    moveAlong(rules_.depth_axis, rules_.from, Wl4Pass::Speed::kRapid);
    moveAlong(1 - rules_.depth_axis, rules_.from, Wl4Pass::Speed::kRapid);
    return std::move(moves_);
  }

 private:
  struct Zone {
    double a, b;
  };

  double length() const { return static_cast<double>(stretches_.size()); }
  double level(const Vec2& p) const { return side_ * p[rules_.depth_axis]; }
  Vec2 at(double t) const {
    const auto k = std::min(static_cast<std::size_t>(t), stretches_.size() - 1);
    const Monotone& m = stretches_[k];
    return pointAt(contour_[m.element], m.t0 + (t - static_cast<double>(k)) * (m.t1 - m.t0));
  }

  void split(std::size_t k) {
    const ContourElement& e = contour_[k];
    std::vector<double> cuts = {0.0};
    if (e.arc) {
      const double from = angleOf(e.from - e.center);
      for (int quarter = -12; quarter <= 12; ++quarter) {
        const double t = (quarter * kPi / 2.0 - from) / e.sweep;
        if (t > 1e-9 && t < 1.0 - 1e-9) cuts.push_back(t);
      }
      std::sort(cuts.begin(), cuts.end());
    }
    cuts.push_back(1.0);
    for (std::size_t i = 1; i < cuts.size(); ++i) stretches_.push_back({k, cuts[i - 1], cuts[i]});
  }

  /// Where the contour crosses the level within stretch k between a and b.
  double crossing(double a, double b, double height) const {
    const bool falls = level(at(a)) > level(at(b));
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (a + b);
      ((level(at(middle)) > height) == falls ? a : b) = middle;
    }
    return 0.5 * (a + b);
  }

  /// The longest stretches of the zone below a level, in order.
  std::vector<Zone> zonesBelow(const Zone& zone, double height) const {
    std::vector<Zone> found;
    const auto add = [&](double a, double b) {
      if (!found.empty() && a - found.back().b < 1e-9) {
        found.back().b = b;
      } else {
        found.push_back({a, b});
      }
    };
    for (double a = zone.a; a < zone.b - 1e-12;) {
      const double b = std::min(zone.b, std::floor(a + 1e-12) + 1.0);
      const double ha = level(at(a)), hb = level(at(b));
      const bool below_a = ha < height - kSame, below_b = hb < height - kSame;
      if (below_a && below_b) add(a, b);
      if (below_a != below_b) {
        const double c = crossing(a, b, height);
        below_a ? add(a, c) : add(c, b);
      }
      a = b;
    }
    return found;
  }

  double lowest(const Zone& zone) const {
    double least = std::min(level(at(zone.a)), level(at(zone.b)));
    for (double t = std::ceil(zone.a); t <= zone.b; t += 1.0) least = std::min(least, level(at(t)));
    return least;
  }

  void process(const Zone& zone, double before, double travel) {
    const double bottom = lowest(zone);
    if (bottom >= before - kSame) return;
    const double height = std::max(before - rules_.depth, bottom);
    const Vec2 start = at(zone.a), end = at(zone.b);
    toLevel(travel, Wl4Pass::Speed::kRapid);
    moveAlong(1 - rules_.depth_axis, start, Wl4Pass::Speed::kRapid);
    toLevel(before, Wl4Pass::Speed::kRapid);
    if (zone.a == 0.0 && level(start) < before - kSame) {
      toLevel(std::max(height, level(start)), Wl4Pass::Speed::kInfeed);
    }
    const std::vector<Zone> deeper = zonesBelow(zone, height);
    double t = zone.a;
    for (const Zone& sub : deeper) {
      follow(t, sub.a);
      Vec2 across = at(sub.b);
      across[rules_.depth_axis] = side_ * height;
      moveTo(across, Wl4Pass::Speed::kFeed, sourceAt(sub.b));
      t = sub.b;
    }
    follow(t, zone.b);
    if (zone.b == length() && level(end) < before - kSame) toLevel(before, Wl4Pass::Speed::kRapid);
    for (const Zone& sub : deeper) process(sub, height, before);
  }

  /// Along the contour at feed.
  void follow(double a, double b) {
    while (a < b - 1e-12) {
      const auto k = std::min(static_cast<std::size_t>(a + 1e-12), stretches_.size() - 1);
      const std::size_t element = stretches_[k].element;
      const auto inElement = [&](double t, std::size_t stretch) {
        const Monotone& m = stretches_[stretch];
        return m.t0 + (t - static_cast<double>(stretch)) * (m.t1 - m.t0);
      };
      std::size_t last = k;
      while (last + 1 < stretches_.size() && stretches_[last + 1].element == element &&
             static_cast<double>(last + 1) < b - 1e-12) {
        ++last;
      }
      const double until = std::min(b, static_cast<double>(last + 1));
      ContourElement e = part(contour_[element], inElement(a, k), inElement(until, last));
      if ((e.to - e.from).norm() > 1e-9) {
        if (e.arc) {
          e.from = at_;
          moves_.push_back({Wl4Pass::Speed::kFeed, e});
          at_ = e.to;
        } else {
          moveTo(e.to, Wl4Pass::Speed::kFeed, e.source);
        }
      }
      a = until;
    }
  }

  void toLevel(double height, Wl4Pass::Speed speed) {
    Vec2 to = at_;
    to[rules_.depth_axis] = side_ * height;
    moveTo(to, speed);
  }
  void moveAlong(int axis, const Vec2& to, Wl4Pass::Speed speed) {
    Vec2 point = at_;
    point[axis] = to[axis];
    moveTo(point, speed);
  }
  int sourceAt(double t) const {
    const auto k = std::min(static_cast<std::size_t>(t), stretches_.size() - 1);
    return contour_[stretches_[k].element].source;
  }
  void moveTo(const Vec2& to, Wl4Pass::Speed speed, int source = -1) {
    const Vec2 way = to - at_;
    if (way.norm() > 1e-9) {
      Wl4Pass* last = moves_.empty() ? nullptr : &moves_.back();
      const bool goes_on = last != nullptr && speed == Wl4Pass::Speed::kFeed && last->speed == speed &&
                           !last->element.arc &&
                           std::abs(cross2((at_ - last->element.from).normalized(), way)) < 1e-9 &&
                           (at_ - last->element.from).dot(way) > 0.0;
      if (goes_on) {
        last->element.to = to;
      } else {
        moves_.push_back({speed, line(at_, to)});
      }
      moves_.back().element.source = source;
    }
    at_ = to;
  }

  const Wl4Contour& contour_;
  const Wl4RoughingRules rules_;
  std::vector<Monotone> stretches_;
  double side_ = 1.0;
  Vec2 at_;
  std::vector<Wl4Pass> moves_;
};

}  // namespace

std::vector<Wl4Pass> roughingPasses(const Wl4Contour& contour, const Wl4RoughingRules& rules) {
  return Roughing(contour, rules).run();
}

namespace {

/// A move from `at`, which goes along; none where it is there already.
void addMove(const Vec2& to, Wl4Pass::Speed speed, Vec2& at, std::vector<Wl4Pass>& moves) {
  if ((to - at).norm() > 1e-9) moves.push_back({speed, line(at, to)});
  at = to;
}

Vec2 withAxis(Vec2 point, int axis, double value) {
  point[axis] = value;
  return point;
}

/// All of the contour at feed.
void addContour(const Wl4Contour& contour, Vec2& at, std::vector<Wl4Pass>& moves) {
  for (const ContourElement& e : contour) moves.push_back({Wl4Pass::Speed::kFeed, e});
  at = contour.back().to;
}

}  // namespace

std::vector<Wl4Pass> finishingPass(const Wl4Contour& contour, int depth_axis, const Vec2& from) {
  std::vector<Wl4Pass> moves;
  const int along = 1 - depth_axis;
  const Vec2 start = contour.front().from;
  Vec2 at = from;
  addMove(withAxis(at, along, start[along]), Wl4Pass::Speed::kRapid, at, moves);
  addMove(start, Wl4Pass::Speed::kInfeed, at, moves);
  addContour(contour, at, moves);
  addMove(withAxis(at, depth_axis, from[depth_axis]), Wl4Pass::Speed::kRapid, at, moves);
  addMove(from, Wl4Pass::Speed::kRapid, at, moves);
  return moves;
}

void addApproachPass(const Wl4Contour& contour, const Vec2& from, std::vector<Wl4Pass>& moves) {
  const Vec2 start = contour.front().from, back = from - start;
  Vec2 at = from;
  addMove(start, Wl4Pass::Speed::kInfeed, at, moves);
  addContour(contour, at, moves);
  const int first = std::abs(back.y()) >= std::abs(back.x()) ? 1 : 0;
  addMove(withAxis(at, first, from[first]), Wl4Pass::Speed::kRapid, at, moves);
  addMove(from, Wl4Pass::Speed::kRapid, at, moves);
}

bool isMonotone(const Wl4Contour& contour, int depth_axis) {
  const int along = 1 - depth_axis;
  const double way = contour.back().to[along] - contour.front().from[along];
  for (const ContourElement& e : contour) {
    Vec2 last = e.from;
    for (int k = 1; k <= 16; ++k) {
      const Vec2 next = pointAt(e, k / 16.0);
      if ((next[along] - last[along]) * way < -kSame * std::abs(way)) return false;
      last = next;
    }
  }
  return true;
}

}  // namespace proveout::nc
