#include "tests/reference/cutter_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/plane.h"

namespace proveout::reference {

namespace {

/// Points are cut off at this radius: what is missing goes with its square.
constexpr double kTip = 2e-4;
/// Shapes without end above end there, higher than any stock.
constexpr double kAbove = 20.0;

Section started(double r, double z) {
  Section s;
  s.start = {r, z};
  return s;
}

/// Up a cone of this half angle to the full radius, and on.
void cone(Section& s, double radius, double half_rad, double height) {
  const Vec2 from = s.pieces.empty() ? s.start : s.pieces.back().to;
  s.line(radius, from.y() + (radius - from.x()) / std::tan(half_rad)).line(radius, height);
}

std::vector<Section> threadSections(const Tool& tool) {
  const double crest = 0.5 * tool.diameter, root = 0.5 * tool.root_diameter;
  const double flank = (crest - root) * std::tan(degToRad(0.5 * tool.thread_angle_deg));
  std::vector<Section> parts;
  for (int i = 0; i < tool.teeth; ++i) {
    const double z = i * tool.pitch;
    Section tooth = started(root, z);
    tooth.line(crest, z + flank).line(crest, z + flank + tool.crest_flat);
    tooth.line(root, z + 2 * flank + tool.crest_flat);
    parts.push_back(tooth);
  }
  if (tool.teeth == 1) return parts;
  Section core = started(root, 0.5 * flank);
  core.line(root, parts.back().pieces.back().to.y() - 0.5 * flank);
  parts.push_back(core);
  return parts;
}

Section discSection(const Tool& tool) {
  const double c = tool.corner_radius, radius = 0.5 * tool.diameter, height = tool.cutter_height;
  Section s = started(radius - c, 0.0);
  if (c > 0.0) s.arc(radius - c, c, radius, c);
  s.line(radius, height - c);
  if (c > 0.0) s.arc(radius - c, height - c, radius - c, height);
  return s;
}

void addArc(const Vec2& from, const Vec2& to, const Vec2& center, double step, std::vector<Vec2>& out) {
  const Vec2 a = from - center, b = to - center;
  const TrueChords chords(std::atan2(a.y(), a.x()), std::atan2(b.y(), b.x()), step);
  for (std::size_t i = 1; i + 1 < chords.size(); ++i) {
    const double angle = chords.angle[i];
    out.push_back(center + a.norm() * chords.scale[i] * Vec2(std::cos(angle), std::sin(angle)));
  }
  out.push_back(to);
}

/// How far a point is from one piece, and whether it is beyond it.
struct Seen {
  double distance;
  bool beyond;
};

Seen seePiece(const Vec2& from, const Section::Piece& piece, const Vec2& p) {
  const bool outside = cross2(piece.to - from, p - from) < 0.0;  // right of the chord or line
  if (!piece.center) return {distanceToSegment(p, from, piece.to), outside};
  const Vec2 a = from - *piece.center, b = piece.to - *piece.center, q = p - *piece.center;
  const bool wide = cross2(a, b) < 0.0;  // more than half a turn
  const bool facing =
      wide ? cross2(a, q) >= 0.0 || cross2(q, b) >= 0.0 : cross2(a, q) >= 0.0 && cross2(q, b) >= 0.0;
  const double radius = a.norm();
  if (facing) return {std::abs(q.norm() - radius), outside && q.norm() > radius};
  return {std::min((p - from).norm(), (p - piece.to).norm()), false};
}

}  // namespace

Section& Section::line(double r, double z) {
  pieces.push_back({{r, z}, std::nullopt});
  return *this;
}

Section& Section::arc(double center_r, double center_z, double r, double z) {
  pieces.push_back({{r, z}, Vec2(center_r, center_z)});
  return *this;
}

std::vector<Section> sectionsOf(const Tool& tool) {
  const double radius = 0.5 * tool.diameter, height = kAbove;
  Section s;
  switch (tool.type) {
    case ToolType::kBall:
      s.arc(0.0, radius, radius, radius).line(radius, height);
      return {s};
    case ToolType::kBull:
      s.start.x() = radius - tool.corner_radius;
      s.arc(s.start.x(), tool.corner_radius, radius, tool.corner_radius).line(radius, height);
      return {s};
    case ToolType::kCone:
      s.start.x() = 0.5 * tool.tip_diameter;
      cone(s, radius, degToRad(0.5 * tool.cone_angle_deg), height);
      return {s};
    case ToolType::kDrill:
      cone(s, radius, degToRad(0.5 * tool.point_angle_deg), height);
      return {s};
    case ToolType::kTaperBall: {
      const double ball = 0.5 * tool.tip_diameter, half = degToRad(0.5 * tool.cone_angle_deg);
      s.arc(0.0, ball, ball * std::cos(half), ball * (1.0 - std::sin(half)));
      cone(s, radius, half, height);
      return {s};
    }
    case ToolType::kDovetail:
      s.start.x() = radius;
      s.line(radius - tool.cutter_height / std::tan(degToRad(tool.dovetail_angle_deg)), tool.cutter_height);
      return {s};
    case ToolType::kTSlot:
      return {discSection(tool)};
    case ToolType::kLollipop: {
      const double neck = 0.5 * tool.neck_diameter;
      s.arc(0.0, radius, neck, radius + std::sqrt(radius * radius - neck * neck));
      return {s};
    }
    case ToolType::kThreadMill:
      return threadSections(tool);
    default:
      s.start.x() = radius;
      s.line(radius, height);
      return {s};
  }
}

TrueChords::TrueChords(double from, double to, double step_rad) {
  const double ends = std::numbers::sqrt2 - 2.0, turn = to - from;
  const int half = std::max(1, static_cast<int>(std::ceil(0.5 * (turn / step_rad - ends))));
  const int n = 2 * half;
  const double step = n > 2 ? turn / (n + ends) : turn / 2, first = n > 2 ? step / std::numbers::sqrt2 : step;
  angle = {from};
  for (int i = 0; i + 1 < n; ++i) angle.push_back(from + first + i * step);
  angle.push_back(to);
  scale.assign(angle.size(), 1.0);
  for (int i = 1; i <= half; ++i) {
    const double chord = angle[i] - angle[i - 1];
    scale[i] = chord / std::sin(chord) / scale[i - 1];
    scale[n - i] = scale[i];
  }
}

double Section::widest() const {
  double r = start.x();
  for (const Piece& p : pieces) {
    r = std::max(r, p.to.x());
    if (p.center) r = std::max(r, p.center->x() + (p.to - *p.center).norm());
  }
  return r;
}

double Section::distance(const Vec2& p) const {
  const Piece bottom{start, std::nullopt}, top{{0.0, pieces.back().to.y()}, std::nullopt};
  Seen seen{std::numeric_limits<double>::infinity(), false};
  const auto see = [&](const Vec2& from, const Piece& piece) {
    const Seen one = seePiece(from, piece, p);
    seen = {std::min(seen.distance, one.distance), seen.beyond || one.beyond};
  };
  if (start.x() > 0.0) see({0.0, start.y()}, bottom);
  Vec2 from = start;
  for (const Piece& piece : pieces) {
    see(from, piece);
    from = piece.to;
  }
  if (from.x() > 0.0) see(from, top);
  return seen.beyond ? seen.distance : -seen.distance;
}

std::vector<Vec2> levelsOf(const Section& section, double step_rad) {
  std::vector<Vec2> points = {section.start};
  Vec2 from = section.start;
  for (const Section::Piece& piece : section.pieces) {
    if (piece.center) {
      addArc(from, piece.to, *piece.center, step_rad, points);
    } else {
      points.push_back(piece.to);
    }
    from = piece.to;
  }
  if (points.front().x() == 0.0) points.front() += kTip / points[1].x() * (points[1] - points.front());
  if (points.back().x() == 0.0)
    points.back() += kTip / points[points.size() - 2].x() * (points[points.size() - 2] - points.back());
  return points;
}

}  // namespace proveout::reference
