#include "removal/surface/cell/vertex_refiner.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "removal/grid/edge_root.h"

namespace proveout {

namespace {

constexpr double kProbeDepth = ExactFaces::kProbeDepth;
/// Beside a ridge of one body a face is probed from this far aside, and deeper by this share of that. The
/// tangent plane found there holds at the ridge only once the step aside has shrunk to kLeastAside of it.
constexpr double kProbeAside = 0.3, kProbeDown = 0.3, kLeastAside = 0.05;
/// A vertex is moved no farther than kMostMoved, and is at rest when a step is shorter than kRest: Newton's
/// method is then off by the step's square.
constexpr double kMostMoved = 0.35, kRest = 0.01;
/// Two faces that meet at less than 20 degrees: an error of their tangent planes at the crossings moves the
/// feature edge by three times as much or more, so it may be farther away. Only for faces that turn by less
/// than 6 degrees, which have such planes.
constexpr double kShallowCos = 0.94, kShallowSpread = 0.1, kMostMovedShallow = 0.7;
constexpr int kNewtonRounds = 8;
/// Where faces blend into each other smoothly, the point at which their tangent planes meet is off them by
/// less than this.
constexpr double kLittleMoved = 0.1;
/// A point between tangent planes that is farther off them than this is on none of their faces.
constexpr double kBetween = 4e-3;
/// A face that blends into another turns by less than 26 degrees (cosine) from its crossings to there. A
/// larger angle is a feature edge.
constexpr double kBlendCos = 0.9;
/// The rules on crossings place a vertex to 2e-3 cells on any face whose normals differ by less than this (1
/// degree).
constexpr double kFlatSpread = 0.02;
/// Crossings needed to show how a face bends; fewer lie in one line, and say nothing of how it bends across
/// that.
constexpr int kShowing = 3;
/// Where crossings do not show how a face bends, its feature edge would be put on their plane: off by an
/// eighth of this, always to the same side, which would add up in the volume.
constexpr double kMostBendUnseen = 2e-3;
/// A face that turns by less than 5.7 degrees up to a feature edge counts as a plane there.
constexpr double kLittleTurned = 0.995;
/// A vertex at rest must be found on its faces to this.
constexpr double kSeenAt = 0.03;
/// The same, when probed against the normals of the crossings.
constexpr double kSeenOver = 0.08;
constexpr int kProbes = 3;
/// A body must face the vertex as the crossings do, to 60 degrees: otherwise the probe has found another of
/// its faces.
constexpr double kSameFacing = 0.5;
/// How far (in radians) faces with many crossings, and with few, may turn up to the vertex.
constexpr double kSlackTurn = 0.1, kMostTurn = 1.0, kTurnOfFew = 0.5;
/// A face is followed from its crossings to a vertex outside the cell for this many cells.
constexpr double kFarthest = 1.5;
/// A surface is not followed along cell walls that it meets at less than 3 degrees.
constexpr double kFlatWall = 0.05;
/// A feature edge or corner must be this near to the blank, in cells; otherwise it is not one.
constexpr double kOffBlank = 0.01;
/// A vertex this near to the surface counts as on it.
constexpr double kOnSurface = 1e-3;
/// How exactly a seam is found: the error of the curvature beside it goes with the square of this.
constexpr double kSeamTolerance = 0.02;
/// How far before and behind a vertex the end of a sweep is looked for, where crossings of the cell show
/// that there is one.
constexpr double kSweepEndReach = 1.0;
/// Faces that turn by more than this (3 degrees, cosine) from one side of a seam to the other break there.
constexpr double kUnbrokenCos = 0.9986;
/// Elements whose crossings turn by more than this (radians) bend so much that smaller quads are worth more
/// than a vertex on the seam.
constexpr double kMostSeamTurn = 0.3;
/// A sharp edge is probed this far to either side; the point found moves by less than this share of what it
/// would on a smooth surface.
constexpr double kSharpProbe = 0.05, kSharpStays = 0.4;
/// Faces that meet at less than this (6 degrees, sine) do not give the direction of their feature edge.
constexpr double kLeastFeatureSine = 0.1;
/// Bodies come as near as this to what their tangent planes meet in, in cells.
constexpr double kBesideFace = 0.02;
/// Edges that run along a face, to 12 degrees (sine), have no certain point where they meet it.
constexpr double kGrazing = 0.2;

}  // namespace

/// Least cosine between the normal of a face and the one found by a probe: where crossings show how the face
/// bends it cannot turn much more than between them. Beyond that the probe found another face of the body.
double VertexRefiner::leastFacing(std::size_t face) {
  if (facing_[face] == 0.0) {
    const CellFace& f = faces_[face];
    const bool shown = f.count >= kShowing && (f.bend_seen || bend_[face] > 0.0 || !round_[face]);
    const double turn = shown ? kSlackTurn + 2.0 * f.spread : kTurnOfFew;
    facing_[face] = std::cos(std::min(kMostTurn, std::max(turn, kSlackTurn + kFarthest * bend_[face])));
  }
  return facing_[face];
}

/// Whether a point found on the face's body belongs to the face or to its smooth continuation.
bool VertexRefiner::isContinuedBy(std::size_t face, const ExactFaces::Foot& foot) {
  const CellFace& f = faces_[face];
  return foot.normal.dot(f.normal) >= leastFacing(face) &&
         (exact_.isOnFace(foot, f.id) || exact_.isOnTangentNeighbour(foot, f.id));
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
    // Crossings in one line say nothing of what is beside it.
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

bool VertexRefiner::isBeyondTrim(const Vec3& x) {
  return std::ranges::any_of(faces_, [&](const CellFace& f) {
    const ExactFaces::Source source = exact_.source(f.id);
    return source.ends_at_rims && exact_.isRounded(source.body) &&
           exact_.isFarther(source.body, x, kOnSurface);
  });
}

bool VertexRefiner::reaches(const Vec3& x) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const bool of_pass = body_[i] > ExactFaces::kNoBody && !exact_.ofBlank();
    if (of_pass && exact_.isFarther(body_[i], x, kBesideFace)) return false;
  }
  return true;
}

bool VertexRefiner::bends() const {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (bend_[i] >= kMostBendUnseen || faces_[i].spread > kFlatSpread) return true;
  }
  return false;
}

bool VertexRefiner::meetAsPlanes(const Vec3& x) {
  if (!cut_ || exact_already_) return cut_;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (body_[i] == ExactFaces::kNoBody) continue;
    const CellFace& f = faces_[i];
    const ExactFaces::Foot foot = exact_.foot(body_[i], x - kProbeDepth * f.normal);
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

/// The tangent plane of a face near `x`. `from`: the normal against which the face is probed; receives the
/// one found. `off`: receives the distance of the point found from `x`. False where the probe finds another
/// face.
bool VertexRefiner::tangentPlaneNear(int face, const Vec3& x, Vec3& from, Plane& plane, double& off) {
  off = 0.0;
  const CellFace& f = faces_[static_cast<std::size_t>(face)];
  if (body_[face] == ExactFaces::kNoBody) {
    plane = planeAt(f, x);
    return true;
  }
  const ExactFaces::Foot foot = exact_.foot(body_[face], x - kProbeDepth * from);
  if (!isContinuedBy(static_cast<std::size_t>(face), foot)) return false;
  from = foot.normal;
  plane = {foot.normal, foot.normal.dot(foot.p - x)};
  off = (foot.p - x).norm();
  return true;
}

/// As tangentPlaneNear, where the body has a ridge at `x`, as between an arc and the wall where it began:
/// beyond the ridge the other face is nearer. The probe therefore stands aside of it, by `part` of
/// kProbeAside.
bool VertexRefiner::tangentPlaneBesideRidge(int face, const Vec3& x, double part, Vec3& from, Plane& plane,
                                            double& off) {
  Vec3 others = Vec3::Zero();
  for (const CellFace& other : faces_) others += other.normal;
  const Vec3 aside = others - from.dot(others) * from;
  if (aside.squaredNorm() < kFlatWall * kFlatWall) return false;
  const double way = part * kProbeAside;
  const ExactFaces::Foot foot = exact_.foot(body_[face], x - way * (aside.normalized() + kProbeDown * from));
  if (!isContinuedBy(static_cast<std::size_t>(face), foot)) return false;
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

/// Probing a point of a face again, against the mean normal, finds one nearer to the edge.
bool VertexRefiner::snapToBodyEdge(Vec3& x) {
  const Vec3 n = meanNormal();
  for (int round = 0; round < kNewtonRounds; ++round) {
    // At a feature edge or apex the normal may be any one between those of its faces.
    const ExactFaces::Foot foot = exact_.foot(body_[0], x - kProbeDepth * n);
    if (foot.normal.dot(n) <= 0.0) return false;
    const double step2 = (foot.p - x).squaredNorm();
    x = foot.p;
    if (step2 < kRest * kRest) break;
  }
  return true;
}

/// Of three faces, two of them of one body: the first of these two. Otherwise -1.
int VertexRefiner::firstFaceOfBodyEdge() const {
  if (faces_.size() != 3) return -1;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (body_[i] != ExactFaces::kNoBody && body_[i] == body_[j] && body_[k] != body_[i]) return i;
  }
  return -1;
}

/// The corner where the edge between face `first` and the next one meets the third.
bool VertexRefiner::snapToCorner(int first, Vec3& x) {
  const CellFace &a = faces_[static_cast<std::size_t>(first)],
                 &b = faces_[static_cast<std::size_t>((first + 1) % 3)];
  const Vec3 n = (a.normal + b.normal).normalized();
  const Vec3 along = a.normal.cross(b.normal).normalized();
  const int third = (first + 2) % 3;
  Vec3 from = faces_[static_cast<std::size_t>(third)].normal;
  for (int round = 0; round < kNewtonRounds; ++round) {
    const ExactFaces::Foot foot = exact_.foot(body_[first], x - kProbeDepth * n);
    Plane other;
    double off;
    if (foot.normal.dot(n) < kSameFacing || !tangentPlaneNear(third, foot.p, from, other, off)) return false;
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
bool VertexRefiner::snapToIntersection(Vec3& x) {
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
      if (!tangentPlaneNear(face, x, from[i], planes[i], off)) {
        if (!tangentPlaneBesideRidge(face, x, part, from[i], planes[i], off)) return false;
        aside = part > kLeastAside;
      }
      farthest = std::max(farthest, off);
      again = again || (round_[i] && off >= kSeenAt);
    }
    const Vec3 step = meetPlanes({planes.data(), faces_.size()});
    if (!(step.squaredNorm() < 1.0)) return false;
    x += step;
    if (aside || step.squaredNorm() >= kRest * kRest) continue;
    if (round == 0 && again)
      continue;            // a probe against the normal of the crossings finds a point beside `x`
    double between = 0.0;  // faces that meet in no line
    for (std::size_t i = 0; i < faces_.size(); ++i)
      between = std::max(between, std::abs(planes[i].n.dot(step) - planes[i].d));
    if (between > kBetween) snapToNearestBody(meanNormal(), x);
    return farthest < kSeenAt;  // beyond a trim the probe finds another part of the body, farther off
  }
  return false;
}

/// Whether the body has a sharp edge or apex at `x`: probed from several places it stays where it is.
bool VertexRefiner::isSharp(const Vec3& n, const Vec3& across, const Vec3& x) {
  const ExactFaces::Foot left = exact_.foot(body_[0], x - kProbeDepth * n - kSharpProbe * across),
                         right = exact_.foot(body_[0], x - kProbeDepth * n + kSharpProbe * across);
  return (right.p - left.p).norm() < kSharpStays * 2.0 * kSharpProbe;
}

/// Whether two of the faces of the one body reach `x`. Between them may have been another one that a later
/// pass cut away.
bool VertexRefiner::isBetweenFaces(const Vec3& x) {
  const auto reaches = [&](const CellFace& f) {
    Vec3 n = f.normal;
    for (int look = 0; look < kProbes;
         ++look) {  // the normal of a curved face differs from that at its crossings
      const ExactFaces::Foot foot = exact_.foot(body_[0], x - kProbeDepth * n);
      if ((foot.p - x).squaredNorm() < kSeenOver * kSeenOver) return true;
      if (foot.normal.dot(f.normal) < leastFacing(static_cast<std::size_t>(&f - faces_.data())) ||
          !exact_.isOnFace(foot, f.id))
        return false;
      n = foot.normal;
    }
    return false;
  };
  return std::count_if(faces_.begin(), faces_.end(), reaches) >= 2;
}

bool VertexRefiner::isSmooth(const Vec3& x) {
  Vec3 at = x;
  if (!oneBody() || !snapToBodyEdge(at)) return false;
  const ExactFaces::Foot foot = exact_.foot(body_[0], at - kProbeDepth * meanNormal());
  const auto isOf = [&](const CellFace& f) { return exact_.isOnFace(foot, f.id); };
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

/// Whether there are just two faces, nearly flat, that meet at less than 20 degrees.
bool VertexRefiner::meetAtShallowAngle() const {
  return faces_.size() == 2 && faces_[0].normal.dot(faces_[1].normal) > kShallowCos &&
         std::max(faces_[0].spread, faces_[1].spread) < kShallowSpread;
}

bool VertexRefiner::snapToFeature(Vec3& x) {
  Vec3 at = x;
  bool rests;
  if (oneBody()) {
    // Another face of the body may lie between the two; or another body may have cut what joined them.
    rests = snapToBodyEdge(at) && (isBetweenFaces(at) || !exact_.isReachedByOthers(body_[0], x));
  } else if (const int edge = firstFaceOfBodyEdge(); edge >= 0) {
    rests = snapToCorner(edge, at);
  } else {
    rests = snapToIntersection(at);
  }
  const double most = meetAtShallowAngle() ? kMostMovedShallow : kMostMoved;
  if (!rests || (at - x).squaredNorm() >= most * most) return false;
  x = at;
  return true;
}

std::optional<Vec3> VertexRefiner::featureEdgeDirection(const Vec3& x) {
  if (faces_.size() != 2 || !cut_ || !(round_[0] || round_[1]) || oneBody()) return std::nullopt;
  std::array<Vec3, 2> n;
  for (std::size_t i = 0; i < 2; ++i) {
    n[i] = planeAt(faces_[i], x).n;
    if (body_[i] == ExactFaces::kNoBody) continue;
    const ExactFaces::Foot foot = exact_.foot(body_[i], x - kProbeDepth * n[i]);
    if (!isContinuedBy(i, foot)) return std::nullopt;
    n[i] = foot.normal;
  }
  const Vec3 along = n[0].cross(n[1]);
  const double length = along.norm();
  return length < kLeastFeatureSine ? std::nullopt : std::optional<Vec3>(along / length);
}

/// The tangent plane of the body that is nearest to the material at `x`, which is the surface of them all.
/// False where it belongs to a face that `seen` does not allow.
bool VertexRefiner::nearestTangentPlane(const Vec3& n, const Vec3& x, Seen seen, Plane& plane) {
  double least = std::numeric_limits<double>::infinity();
  const Vec3 from = x - kProbeDepth * n;
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    if (body_[i] == ExactFaces::kNoBody) {
      const Plane p = planeAt(faces_[i], x);
      if (p.d + kProbeDepth < least) {
        least = p.d + kProbeDepth;
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
    bool known = false;  // otherwise another body continues beyond the trim of this face
    for (std::size_t j = i; j < faces_.size(); ++j) {
      if (body_[j] != body_[i]) continue;
      known = known || (seen == Seen::kBlendedFaces ? foot.normal.dot(faces_[j].normal) > kBlendCos
                                                    : exact_.isOnFace(foot, faces_[j].id));
    }
    if (!known) return false;
    least = distance;
    plane = {foot.normal, foot.normal.dot(foot.p - x)};
  }
  return plane.n.dot(n) > kSameFacing;
}

void VertexRefiner::snapToNearestBody(const Vec3& n, Vec3& x) {
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    // Between other bodies there may be a step, whose sides say nothing of each other.
    if (!exact_.isRounded(body_[i])) return;
  }
  Vec3 at = x;
  Plane plane;
  for (int round = 0; round < kNewtonRounds; ++round) {
    if (!nearestTangentPlane(n, at, Seen::kBlendedFaces, plane)) return;
    at += plane.n * plane.d;
    if (std::abs(plane.d) < kOnSurface) break;
  }
  if ((at - x).squaredNorm() < kLittleMoved * kLittleMoved && std::abs(plane.d) < kOnSurface) x = at;
}

/// Bisects the way from one place to another on the body's surface for the point where the kind of what is
/// found there changes, and moves `x` to it. `kindOf(foot)`: must be 0 at the first place and 1 at the
/// second. False where the point is not in the cell or the surface breaks there.
template <typename KindOf>
bool VertexRefiner::snapToTransition(const Place& first, const Place& second, const KindOf& kindOf, Vec3& x) {
  const auto footAt = [&](double part) {
    const Vec3 n = first.n + part * (second.n - first.n), p = first.p + part * (second.p - first.p);
    return exact_.foot(body_[0], p - kProbeDepth * n.normalized());
  };
  ExactFaces::Foot before = footAt(0.0), after = footAt(1.0), at = before;
  if (kindOf(before) != 0 || kindOf(after) != 1) return false;
  double from = 0.0, to = 1.0;
  while (to - from > kSeamTolerance) {
    const double part = 0.5 * (from + to);
    at = footAt(part);
    const bool is_first = kindOf(at) == 0;
    (is_first ? from : to) = part;
    (is_first ? before : after) = at;
  }
  if (before.normal.dot(after.normal) < kUnbrokenCos || outsideBy(at.p) > -kWallGap) return false;
  x = at.p;
  return true;
}

void VertexRefiner::snapToSeam(Vec3& x) {
  if (faces_.size() != 2 || !exact_.areTangentNeighbours(faces_[0].id, faces_[1].id)) return;
  if ((faces_[1].normal - faces_[0].normal).squaredNorm() > kMostSeamTurn * kMostSeamTurn) return;
  // Not by ExactFaces::isOnFace, which counts the end of a neighbouring element as the same face.
  const auto kindOf = [&](const ExactFaces::Foot& foot) {
    const auto isOf = [&](const CellFace& f) {
      return static_cast<std::uint64_t>(foot.element) == (f.id & 0xFFFF);
    };
    return isOf(faces_[0]) ? 0 : isOf(faces_[1]) ? 1 : 2;
  };
  snapToTransition({faces_[0].point, faces_[0].normal}, {faces_[1].point, faces_[1].normal}, kindOf, x);
}

bool VertexRefiner::snapToSweepEnd(std::span<const SheetPoint> points, Vec3& x) {
  // Walls swept by cones end in apexes, around which nothing is smooth.
  if (faces_.size() != 1 || exact_.source(faces_[0].id).cone) return false;
  std::array<int, 3> count{};  // where the motion ended, where the tool passed by, where it began
  for (const SheetPoint& s : points) ++count[1 + exact_.sweepEndAt(body_[0], s.p, s.n)];
  const int end = count[0] > 0 ? 0 : 2;
  if (count[1] == 0 || count[end] == 0 || count[2 - end] > 0) return false;
  // Along the motion the seam is nearest, so the vertex comes no nearer than need be to other vertices and
  // to walls.
  const Vec3 n = meanNormal(),
             way = (end == 0 ? kSweepEndReach : -kSweepEndReach) * exact_.directionAt(body_[0], x);
  const auto kindOf = [&](const ExactFaces::Foot& foot) {
    const int seen = 1 + exact_.sweepEndAt(body_[0], foot.p, foot.normal);
    return seen == 1 ? 0 : seen == end ? 1 : 2;
  };
  return snapToTransition({x - way, n}, {x + way, n}, kindOf, x);
}

void VertexRefiner::snapToBlank(const Vec3& n, double reach, Vec3& x) const {
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

bool VertexRefiner::snapToSurface(const Vec3& n, double beyond, Vec3& x) {
  const double low = kWallGap - beyond, high = 1.0 - kWallGap + beyond;
  Vec3 at = x;
  Plane plane;
  for (int round = 0; round < kNewtonRounds; ++round) {
    if (!nearestTangentPlane(n, at, Seen::kKnownFaces, plane)) return false;
    Vec3 way = plane.n * (plane.d < 0.0 ? -1.0 : 1.0);
    for (int k = 0; k < 3; ++k) {  // not through the walls that it lies on
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
  return !held || (nearestTangentPlane(n, at, Seen::kKnownFaces, plane) && std::abs(plane.d) < kOnSurface);
}

}  // namespace proveout
