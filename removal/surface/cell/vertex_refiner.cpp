#include "removal/surface/cell/vertex_refiner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/grid/edge_root.h"

namespace proveout {

namespace {

constexpr double kLookFrom = ExactFaces::kLookFrom;
/// Beside a ridge of one body a face is looked at from so far aside, and so much deeper, of that; the tangent
/// plane seen there is good at the ridge only from this part of it.
constexpr double kLookAside = 0.3, kLookDown = 0.3, kLeastAside = 0.05;
/// A vertex is not moved farther than this, and rests when a step is shorter than that: Newton's method
/// leaves the step's square then.
constexpr double kMostMoved = 0.35, kRest = 0.01;
/// Where two faces meet at less than 20 degrees, what their tangent planes are off at the crossings moves the
/// crease by three times as much and more. Faces that turn by 6 degrees and more have no such planes.
constexpr double kMeetGently = 0.94, kTurnGently = 0.1, kMostMovedGently = 0.7;
constexpr int kNewtonRounds = 8;
/// A place at which tangent planes meet where faces go over into each other smoothly is off them by less.
constexpr double kLittleMoved = 0.1;
/// So far off tangent planes a place between them is on none of their faces.
constexpr double kBetween = 4e-3;
/// A face that goes over into another turns by less than 26 degrees from where they are crossed. An edge is
/// seen at a larger angle.
constexpr double kGoesOver = 0.9;
/// The rules on crossings are good to 2e-3 cells for any face whose normals differ by less than this (1
/// degree).
constexpr double kFlatSpread = 0.02;
/// Crossings that show how a face bends; fewer lie in one direction, across which it may bend as it likes.
constexpr int kShowing = 3;
/// Where crossings do not show how a face bends, its crease would lie on their plane: by an eighth of this
/// off, and always to the same side, which adds up in the volume.
constexpr double kMostBendUnseen = 2e-3;
/// A face that turns by less than 5.7 degrees up to a crease is as good as a plane there.
constexpr double kLittleTurned = 0.995;
/// A vertex at rest is seen on its faces within this.
constexpr double kSeenAt = 0.03;
/// The same, looked at against the normals of the crossings.
constexpr double kSeenOver = 0.08;
constexpr int kLooks = 3;
/// A body must face the vertex as the crossings do, to 60 degrees: else it shows another of its faces.
constexpr double kSameFacing = 0.5;
/// How far (in radians) faces with many crossings, and with few, may turn up to the vertex.
constexpr double kSlackTurn = 0.1, kMostTurn = 1.0, kTurnOfFew = 0.5;
/// From its crossings a face goes on to a vertex outside the cell for so many cells.
constexpr double kFarthest = 1.5;
/// A surface that meets the walls at which a vertex lies at less than 3 degrees is not followed along them.
constexpr double kFlatWall = 0.05;
/// A crease or corner this far off the blank, in cells, is none.
constexpr double kOffBlank = 0.01;
/// A vertex this near is on the surface.
constexpr double kOnSurface = 1e-3;
/// How near to the border of two elements it is found: bends differ by its square beside it.
constexpr double kAtBorder = 0.02;
/// So far before and behind a vertex an end of the way is looked for that crossings of the cell tell of.
constexpr double kAlongWay = 1.0;
/// Faces that turn by more (3 degrees) from one side of that to the other break there.
constexpr double kUnbroken = 0.9986;
/// Elements whose crossings turn by more (in radians) bend so much that smaller quads are worth more.
constexpr double kGentleTurn = 0.3;
/// How far to either side an edge is looked at, and how much less it moves than a smooth surface.
constexpr double kSideStep = 0.05, kStays = 0.4;
/// Faces that meet at less (6 degrees) do not tell which way their crease runs.
constexpr double kLeastCrease = 0.1;
/// Edges that run along a face, to 12 degrees, have no certain place where they meet it.
constexpr double kGrazing = 0.2;

}  // namespace

/// A face must be seen to turn not much more than between its crossings, if they show how it bends; else
/// another one of the body is seen.
double VertexRefiner::leastFacing(std::size_t face) {
  if (facing_[face] == 0.0) {
    const CellFace& f = faces_[face];
    const bool shown = f.count >= kShowing && (f.bend_seen || bend_[face] > 0.0 || !round_[face]);
    const double turn = shown ? kSlackTurn + 2.0 * f.spread : kTurnOfFew;
    facing_[face] = std::cos(std::min(kMostTurn, std::max(turn, kSlackTurn + kFarthest * bend_[face])));
  }
  return facing_[face];
}

/// Whether a point that is seen of the face's body is what the face goes on as.
bool VertexRefiner::continues(std::size_t face, const ExactFaces::Foot& foot) {
  const CellFace& f = faces_[face];
  return foot.normal.dot(f.normal) >= leastFacing(face) &&
         (exact_.isOf(foot, f.id) || exact_.isBeside(foot, f.id));
}

VertexRefiner::VertexRefiner(ExactFaces& exact, std::span<const CellFace> faces)
    : exact_(exact), faces_(faces) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const ExactFaces::Source source = exact.source(faces[i].id);
    const bool flat = faces[i].count >= kShowing && faces[i].spread < kFlatSpread;
    body_[i] = source.body;
    facing_[i] = 0.0;
    bend_[i] = source.bend;
    cut_ = cut_ || (source.body > ExactFaces::kNoBody && !exact.ofBlank());
    exact_already_ = exact_already_ && (source.isShown() || (!source.simple && flat));
    // Crossings in one line tell nothing of what is beside it.
    round_[i] = !source.simple || source.bend >= kMostBendUnseen;
  }
}

bool VertexRefiner::needed(bool smooth) const {
  if (!exact_already_ || !(smooth || bendsAreSeen())) return true;
  bool one_element = true, cut = false;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    cut = cut || body_[i] != ExactFaces::kNoBody;
    one_element = one_element && (faces_[i].id & 0xFFFF) == (faces_[0].id & 0xFFFF);
  }
  return cut && !one_element && (smooth || oneBody());
}

bool VertexRefiner::isPastEnd(const Vec3& x) {
  return std::ranges::any_of(faces_, [&](const CellFace& f) {
    const ExactFaces::Source source = exact_.source(f.id);
    return source.ends && exact_.isRounded(source.body) && exact_.distanceTo(source.body, x) > kOnSurface;
  });
}

bool VertexRefiner::bends() const {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (bend_[i] >= kMostBendUnseen || faces_[i].spread > kFlatSpread) return true;
  }
  return false;
}

bool VertexRefiner::meetFlat(const Vec3& x) {
  if (!cut_ || exact_already_) return cut_;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (body_[i] == ExactFaces::kNoBody) continue;
    const CellFace& f = faces_[i];
    const ExactFaces::Foot foot = exact_.foot(body_[i], x - kLookFrom * f.normal);
    if (foot.normal.dot(f.normal) < kLittleTurned || (foot.p - x).squaredNorm() > kSeenAt * kSeenAt)
      return false;
  }
  return true;
}

bool VertexRefiner::bendsAreSeen() const {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (round_[i] && !faces_[i].bend_seen) return false;
  }
  return true;
}

bool VertexRefiner::oneBody() const {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (body_[i] == ExactFaces::kNoBody || body_[i] != body_[0]) return false;
  }
  return true;
}

/// `from`: the normal against which the face is looked at; becomes the one that is seen. `off`: how far the
/// point that is seen is from `x`.
bool VertexRefiner::planeNear(int face, const Vec3& x, Vec3& from, Plane& plane, double& off) {
  off = 0.0;
  const CellFace& f = faces_[static_cast<std::size_t>(face)];
  if (body_[face] == ExactFaces::kNoBody) {
    plane = planeAt(f, x);
    return true;
  }
  const ExactFaces::Foot foot = exact_.foot(body_[face], x - kLookFrom * from);
  if (!continues(static_cast<std::size_t>(face), foot)) return false;
  from = foot.normal;
  plane = {foot.normal, foot.normal.dot(foot.p - x)};
  off = (foot.p - x).norm();
  return true;
}

/// As planeNear, where the body has a ridge at `x`, as an arc has with the wall that it set out from: beyond
/// it the other face is nearer. Looked at from farther off that, by `part` of kLookAside.
bool VertexRefiner::planeBeside(int face, const Vec3& x, double part, Vec3& from, Plane& plane, double& off) {
  Vec3 others = Vec3::Zero();
  for (const CellFace& other : faces_) others += other.normal;
  const Vec3 aside = others - from.dot(others) * from;
  if (aside.squaredNorm() < kFlatWall * kFlatWall) return false;
  const double way = part * kLookAside;
  const ExactFaces::Foot foot = exact_.foot(body_[face], x - way * (aside.normalized() + kLookDown * from));
  if (!continues(static_cast<std::size_t>(face), foot)) return false;
  from = foot.normal;
  plane = {foot.normal, foot.normal.dot(foot.p - x)};
  off = std::max(0.0, (foot.p - x).norm() - way);
  return true;
}

Vec3 VertexRefiner::meanNormal() const {
  Vec3 n = Vec3::Zero();
  for (const CellFace& f : faces_) n += f.normal * f.count;
  return n.normalized();
}

/// From a point of a face, one looked at against the mean normal is nearer to the edge.
bool VertexRefiner::ontoBody(Vec3& x) {
  const Vec3 n = meanNormal();
  for (int round = 0; round < kNewtonRounds; ++round) {
    // A point or edge may face any way between its faces.
    const ExactFaces::Foot foot = exact_.foot(body_[0], x - kLookFrom * n);
    if (foot.normal.dot(n) <= 0.0) return false;
    const double step2 = (foot.p - x).squaredNorm();
    x = foot.p;
    if (step2 < kRest * kRest) break;
  }
  return true;
}

/// The first of the faces of the one body that shows two, if there is just one other face; or -1.
int VertexRefiner::bodyWithEdge() const {
  if (faces_.size() != 3) return -1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (body_[i] != ExactFaces::kNoBody && body_[i] == body_[j] && body_[k] != body_[i]) return i;
  }
  return -1;
}

/// Where the edge between faces `first` and the next meets the one after.
bool VertexRefiner::ontoEdge(int first, Vec3& x) {
  const CellFace &a = faces_[static_cast<std::size_t>(first)],
                 &b = faces_[static_cast<std::size_t>((first + 1) % 3)];
  const Vec3 n = (a.normal + b.normal).normalized();
  const Vec3 along = a.normal.cross(b.normal).normalized();
  const int third = (first + 2) % 3;
  Vec3 from = faces_[static_cast<std::size_t>(third)].normal;
  for (int round = 0; round < kNewtonRounds; ++round) {
    const ExactFaces::Foot foot = exact_.foot(body_[first], x - kLookFrom * n);
    Plane other;
    double off;
    if (foot.normal.dot(n) < kSameFacing || !planeNear(third, foot.p, from, other, off)) return false;
    const double slope = other.n.dot(along);
    if (std::abs(slope) < kGrazing) return false;
    const Vec3 next = foot.p + along * (other.d / slope);
    const double step = (next - x).norm();
    if (!(step < 1.0)) return false;
    x = next;
    if (step < kRest) return off < kSeenAt;
  }
  return false;
}

/// Where faces of different bodies meet: Newton's method on their tangent planes.
bool VertexRefiner::ontoFaces(Vec3& x) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (body_[i] != ExactFaces::kNoBody && body_[i] == body_[j]) return false;
    }
  }
  std::array<Plane, 12> planes;
  std::array<Vec3, 12> from;
  for (std::size_t i = 0; i < faces_.size(); ++i) from[i] = faces_[i].normal;
  double part = 1.0;  // the nearer to the edge, the less aside
  for (int round = 0; round < kNewtonRounds; ++round, part = std::max(0.4 * part, kLeastAside)) {
    double farthest = 0.0;
    bool aside = false, again = false;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      double off;
      const int face = static_cast<int>(i);
      if (!planeNear(face, x, from[i], planes[i], off)) {
        if (!planeBeside(face, x, part, from[i], planes[i], off)) return false;
        aside = part > kLeastAside;
      }
      farthest = std::max(farthest, off);
      again = again || (round_[i] && off >= kSeenAt);
    }
    const Vec3 step = meetPlanes({planes.data(), faces_.size()});
    if (!(step.squaredNorm() < 1.0)) return false;
    x += step;
    if (aside || step.squaredNorm() >= kRest * kRest) continue;
    if (round == 0 && again) continue;  // against the normal of its crossings a face is seen beside `x`
    double between = 0.0;               // faces that meet in no line
    for (std::size_t i = 0; i < faces_.size(); ++i)
      between = std::max(between, std::abs(planes[i].n.dot(step) - planes[i].d));
    if (between > kBetween) ontoNearest(meanNormal(), x);
    return farthest < kSeenAt;  // where a face ends, another part of its body is seen, farther off
  }
  return false;
}

/// Whether the body has an edge or a point at `x`: seen from several places it stays where it is.
bool VertexRefiner::isSharp(const Vec3& n, const Vec3& across, const Vec3& x) {
  const ExactFaces::Foot left = exact_.foot(body_[0], x - kLookFrom * n - kSideStep * across),
                         right = exact_.foot(body_[0], x - kLookFrom * n + kSideStep * across);
  return (right.p - left.p).norm() < kStays * 2.0 * kSideStep;
}

/// Whether two of the faces of the one body come to `x`. Between them may be another that a later pass cut
/// away.
bool VertexRefiner::isBetweenFaces(const Vec3& x) {
  const auto comesTo = [&](const CellFace& f) {
    Vec3 n = f.normal;
    for (int look = 0; look < kLooks; ++look) {  // curved faces have other normals than at their crossings
      const ExactFaces::Foot foot = exact_.foot(body_[0], x - kLookFrom * n);
      if ((foot.p - x).squaredNorm() < kSeenOver * kSeenOver) return true;
      if (foot.normal.dot(f.normal) < leastFacing(static_cast<std::size_t>(&f - faces_.data())) ||
          !exact_.isOf(foot, f.id))
        return false;
      n = foot.normal;
    }
    return false;
  };
  return std::count_if(faces_.begin(), faces_.end(), comesTo) >= 2;
}

bool VertexRefiner::isSmooth(const Vec3& x) {
  Vec3 at = x;
  if (!oneBody() || !ontoBody(at)) return false;
  const ExactFaces::Foot foot = exact_.foot(body_[0], at - kLookFrom * meanNormal());
  const auto isOf = [&](const CellFace& f) { return exact_.isOf(foot, f.id); };
  if (std::none_of(faces_.begin(), faces_.end(), isOf)) return false;
  Vec3 across = Vec3::Zero();  // where the surface turns most
  for (std::size_t i = 1; i < faces_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 turn = faces_[i].normal - faces_[j].normal;
      if (turn.squaredNorm() > across.squaredNorm()) across = turn;
    }
  }
  return !isSharp(meanNormal(), across.normalized(), at);
}

/// Whether there are two faces, nearly flat, which nearly go over into each other.
bool VertexRefiner::meetGently() const {
  return faces_.size() == 2 && faces_[0].normal.dot(faces_[1].normal) > kMeetGently &&
         std::max(faces_[0].spread, faces_[1].spread) < kTurnGently;
}

bool VertexRefiner::toCrease(Vec3& x) {
  Vec3 at = x;
  bool rests;
  if (oneBody()) {
    // Between the faces may be another one of the body; or another body, where they went on once.
    rests = ontoBody(at) && (isBetweenFaces(at) || !exact_.isReachedByOthers(body_[0], x));
  } else if (const int edge = bodyWithEdge(); edge >= 0) {
    rests = ontoEdge(edge, at);
  } else {
    rests = ontoFaces(at);
  }
  const double most = meetGently() ? kMostMovedGently : kMostMoved;
  if (!rests || (at - x).squaredNorm() >= most * most) return false;
  x = at;
  return true;
}

std::optional<Vec3> VertexRefiner::alongCrease(const Vec3& x) {
  if (faces_.size() != 2 || !cut_ || !(round_[0] || round_[1]) || oneBody()) return std::nullopt;
  std::array<Vec3, 2> n;
  for (std::size_t i = 0; i < 2; ++i) {
    n[i] = planeAt(faces_[i], x).n;
    if (body_[i] == ExactFaces::kNoBody) continue;
    const ExactFaces::Foot foot = exact_.foot(body_[i], x - kLookFrom * n[i]);
    if (!continues(i, foot)) return std::nullopt;
    n[i] = foot.normal;
  }
  const Vec3 along = n[0].cross(n[1]);
  const double length = along.norm();
  return length < kLeastCrease ? std::nullopt : std::optional<Vec3>(along / length);
}

/// The tangent plane of the body that is nearest to the material at `x`: the surface of them all. False where
/// it is of a face that may not be seen.
bool VertexRefiner::nearestPlane(const Vec3& n, const Vec3& x, Seen seen, Plane& plane) {
  double least = std::numeric_limits<double>::infinity();
  const Vec3 from = x - kLookFrom * n;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (body_[i] == ExactFaces::kNoBody) {
      const Plane p = planeAt(faces_[i], x);
      if (p.d + kLookFrom < least) {
        least = p.d + kLookFrom;
        plane = p;
      }
      continue;
    }
    bool done = false;
    for (std::size_t j = 0; j < i; ++j) done = done || body_[j] == body_[i];
    if (done) continue;
    const ExactFaces::Foot foot = exact_.foot(body_[i], from);
    const double distance = (foot.p - from).dot(foot.normal);
    if (distance >= least) continue;
    bool known = false;  // else another body goes on where this face ends
    for (std::size_t j = i; j < faces_.size(); ++j) {
      if (body_[j] != body_[i]) continue;
      known = known || (seen == Seen::kSmoothFaces ? foot.normal.dot(faces_[j].normal) > kGoesOver
                                                   : exact_.isOf(foot, faces_[j].id));
    }
    if (!known) return false;
    least = distance;
    plane = {foot.normal, foot.normal.dot(foot.p - x)};
  }
  return plane.n.dot(n) > kSameFacing;
}

void VertexRefiner::ontoNearest(const Vec3& n, Vec3& x) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    // Between others may be a step, whose sides tell nothing of each other.
    if (!exact_.isRounded(body_[i])) return;
  }
  Vec3 at = x;
  Plane plane;
  for (int round = 0; round < kNewtonRounds; ++round) {
    if (!nearestPlane(n, at, Seen::kSmoothFaces, plane)) return;
    at += plane.n * plane.d;
    if (std::abs(plane.d) < kOnSurface) break;
  }
  if ((at - x).squaredNorm() < kLittleMoved * kLittleMoved && std::abs(plane.d) < kOnSurface) x = at;
}

/// Moves `x` to where, on the body's surface from one place to another, what is seen changes. `kindOf(foot)`:
/// 0 as it must be at the first place, 1 as at the second. False where that is not in the cell or the surface
/// breaks.
template <typename KindOf>
bool VertexRefiner::toChange(const Place& first, const Place& second, const KindOf& kindOf, Vec3& x) {
  const auto footAt = [&](double part) {
    const Vec3 n = first.n + part * (second.n - first.n), p = first.p + part * (second.p - first.p);
    return exact_.foot(body_[0], p - kLookFrom * n.normalized());
  };
  ExactFaces::Foot before = footAt(0.0), after = footAt(1.0), at = before;
  if (kindOf(before) != 0 || kindOf(after) != 1) return false;
  double from = 0.0, to = 1.0;
  while (to - from > kAtBorder) {
    const double part = 0.5 * (from + to);
    at = footAt(part);
    const bool is_first = kindOf(at) == 0;
    (is_first ? from : to) = part;
    (is_first ? before : after) = at;
  }
  if (before.normal.dot(after.normal) < kUnbroken || outsideBy(at.p) > -kWallGap) return false;
  x = at.p;
  return true;
}

void VertexRefiner::toBorder(Vec3& x) {
  if (faces_.size() != 2 || !exact_.goOver(faces_[0].id, faces_[1].id)) return;
  if ((faces_[1].normal - faces_[0].normal).squaredNorm() > kGentleTurn * kGentleTurn) return;
  // Not as ExactFaces::isOf, which takes the end of a neighbour for the same face.
  const auto kindOf = [&](const ExactFaces::Foot& foot) {
    const auto isOf = [&](const CellFace& f) {
      return static_cast<std::uint64_t>(foot.element) == (f.id & 0xFFFF);
    };
    return isOf(faces_[0]) ? 0 : isOf(faces_[1]) ? 1 : 2;
  };
  toChange({faces_[0].point, faces_[0].normal}, {faces_[1].point, faces_[1].normal}, kindOf, x);
}

bool VertexRefiner::toEnd(std::span<const SheetPoint> points, Vec3& x) {
  // The walls of cones end in points, around which nothing is smooth.
  if (faces_.size() != 1 || exact_.source(faces_[0].id).cone) return false;
  std::array<int, 3> count{};  // where the way ended, where the tool passed by, where it began
  for (const SheetPoint& s : points) ++count[1 + exact_.endAt(body_[0], s.p, s.n)];
  const int end = count[0] > 0 ? 0 : 2;
  if (count[1] == 0 || count[end] == 0 || count[2 - end] > 0) return false;
  // Along the way the place is nearest: neither nearer to other vertices than need be, nor to walls.
  const Vec3 n = meanNormal(), way = (end == 0 ? kAlongWay : -kAlongWay) * exact_.directionAt(body_[0], x);
  const auto kindOf = [&](const ExactFaces::Foot& foot) {
    const int seen = 1 + exact_.endAt(body_[0], foot.p, foot.normal);
    return seen == 1 ? 0 : seen == end ? 1 : 2;
  };
  return toChange({x - way, n}, {x + way, n}, kindOf, x);
}

void VertexRefiner::toBlank(const Vec3& n, double reach, Vec3& x) const {
  if (!exact_.ofBlank()) return;
  Vec3 way = n;
  for (int k = 0; k < 3; ++k) {
    if (x[k] <= kWallGap || x[k] >= 1.0 - kWallGap) way[k] = 0.0;
  }
  if (way.squaredNorm() < kFlatWall * kFlatWall) return;
  way.normalize();
  const auto point = [&](double s) { return Vec3(x + s * way); };
  const auto value = [&](double s) { return exact_.blankValue(point(s)); };
  const double inside = value(-reach), outside = value(reach);
  if (!(inside < 0.0 && outside >= 0.0)) return;
  const double at = edgeRoot(value, reach, outside, -reach, inside, 1e-6);
  x = clampToCell(point(at));
}

bool VertexRefiner::isOffBlank(const Vec3& x) const {
  return exact_.ofBlank() && std::abs(exact_.blankValue(x)) > kOffBlank;
}

bool VertexRefiner::toSurface(const Vec3& n, double beyond, Vec3& x) {
  const double low = kWallGap - beyond, high = 1.0 - kWallGap + beyond;
  Vec3 at = x;
  Plane plane;
  for (int round = 0; round < kNewtonRounds; ++round) {
    if (!nearestPlane(n, at, Seen::kKnownFaces, plane)) return false;
    Vec3 way = plane.n * (plane.d < 0.0 ? -1.0 : 1.0);
    for (int k = 0; k < 3; ++k) {  // not through the walls that it lies at
      if ((at[k] <= low && way[k] < 0.0) || (at[k] >= high && way[k] > 0.0)) way[k] = 0.0;
    }
    if (way.squaredNorm() < kFlatWall * kFlatWall) break;
    const Vec3 next = (at + way * (std::abs(plane.d) / way.squaredNorm()))
                          .cwiseMax(Vec3::Constant(low))
                          .cwiseMin(Vec3::Constant(high));
    const double step2 = (next - at).squaredNorm();
    at = next;
    if (step2 < kRest * kRest) break;
  }
  if ((at - x).squaredNorm() >= kMostMoved * kMostMoved) return false;
  x = at;
  const bool held = at.minCoeff() <= low || at.maxCoeff() >= high;
  return !held || (nearestPlane(n, at, Seen::kKnownFaces, plane) && std::abs(plane.d) < kOnSurface);
}

}  // namespace proveout
