#include "removal/contact/contact_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <utility>
#include <variant>

#include "core/base/assert.h"
#include "removal/sweep/convex_cast.h"
#include "removal/sweep/motion_bodies.h"

namespace proveout {
namespace {

/// Share of the grid that the mesh is off the surface at most: more is another surface.
constexpr double kMostOff = 0.1;
/// How deep points are put into the material before the nearest point of a swept volume is asked for, share
/// of the grid: distances are exact outside of the volume only.
constexpr double kPush = 0.1;
/// Corners of a triangle lie this near to the volume that made it, share of the grid.
constexpr double kCornerOff = 0.02;
constexpr int kMaxDepth = 8;
constexpr double kFootMm = 1e-7;
/// Cosine of the angle to a face's normal of a way that goes along the face: what is touched so is only
/// slid over.
constexpr double kAlong = 1e-6;
/// A way this near to that of a motion is on it, mm.
constexpr double kSameWayMm = 1e-9;

Vec3 normalOf(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

std::unique_ptr<BlankField> roundBlank(const StockShape* blank) {
  const auto* cylinder = blank ? std::get_if<CylinderShape>(blank) : nullptr;
  if (cylinder == nullptr) return nullptr;
  Result<std::unique_ptr<BlankField>> field = makeBlankField(*cylinder);
  return field ? std::move(*field) : nullptr;
}

std::pair<std::uint32_t, std::uint32_t> edgeOf(const TriMesh& mesh, std::size_t triangle, std::size_t k) {
  const std::uint32_t a = mesh.triangles[triangle][k], b = mesh.triangles[triangle][(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

ContactQuery::ContactQuery(StockSurface surface, const Toolpath& path, const std::vector<Tool>& tools,
                           const StockShape* blank, double resolution_mm)
    : surface_(std::move(surface)), path_(path), blank_(roundBlank(blank)), h_(resolution_mm) {
  for (const Tool& tool : tools) solids_.emplace(tool.number, makeToolSolid(tool));
  const TriMesh& mesh = surface_.mesh;
  PROVEOUT_ASSERT(mesh.motion.size() == mesh.triangles.size());
  edges_.reserve(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) edges_.push_back({edgeOf(mesh, i, k), static_cast<std::uint32_t>(i)});
  }
  std::sort(edges_.begin(), edges_.end());
}

std::optional<std::size_t> ContactQuery::across(std::size_t triangle, std::size_t k) const {
  const auto edge = edgeOf(surface_.mesh, triangle, k);
  auto at = std::lower_bound(edges_.begin(), edges_.end(), std::pair(edge, std::uint32_t{0}));
  for (; at != edges_.end() && at->first == edge; ++at) {
    if (at->second != triangle) return at->second;
  }
  return std::nullopt;
}

namespace {

bool same(const ConvexProfile& a, const ConvexProfile& b) {
  const auto equal = [](const ConvexProfile::Element& p, const ConvexProfile::Element& q) {
    return p.arc == q.arc && p.ar == q.ar && p.az == q.az && p.br == q.br && p.bz == q.bz &&
           (!p.arc || (p.cr == q.cr && p.cz == q.cz));
  };
  bool all = a.elementCount() == b.elementCount();
  for (int i = 0; all && i < a.elementCount(); ++i) all = equal(a.element(i), b.element(i));
  return all;
}

}  // namespace

/// One query: a tool's parts on one line.
class ContactSearch {
 public:
  ContactSearch(const ContactQuery& query, const Vec3& from, const Vec3& to)
      : query_(query), from_(from), to_(to), slack_(kSlackMm / std::max((to - from).norm(), kSlackMm)) {}

  /// Keeps contacts that are earlier than those of the parts before.
  void add(const ConvexProfile& part);
  std::optional<double> best() const {
    if (best_ > 1.0) return std::nullopt;
    return best_;
  }

 private:
  /// The surface that a triangle of the mesh is a part of: a swept volume, the round of the blank, else its
  /// own plane.
  struct Face {
    Vec3 at = Vec3::Zero(), n = Vec3::Zero();  ///< a corner; unit, out of the material, 0 for a needle
    const SweptField* sweep = nullptr;
    bool blank = false;
  };
  /// A piece of the surface: a triangle whose edges may be creases with other faces.
  struct Piece {
    double bound = 0.0;  ///< the contact is not before it
    std::uint64_t number = 0;
    std::size_t source = 0;  ///< triangle of the mesh
    int depth = 0;
    Triangle t;
    std::array<const Face*, 3> crease{};        ///< edge k is from corner k to the next
    bool operator<(const Piece& other) const {  // for a queue with the least bound first
      return bound != other.bound ? bound > other.bound : number > other.number;
    }
  };

  /// A point of a face, and where the material ends there.
  struct Foot {
    Vec3 at = Vec3::Zero(), n = Vec3::Zero();
  };
  /// Parameters of the way between which a part is where it has cut before: nothing touches it there.
  struct Stretch {
    double begin = 0.0, end = 0.0;
  };

  void findFree(const ConvexProfile& part);
  void addFree(const Motion& motion);
  double raised(double t) const;
  Triangle triangleAt(std::size_t i) const;
  const Face& faceOf(std::size_t i);
  void findSweep(std::size_t i, const Triangle& t, Face& face);
  double cornersOff(const Triangle& t, const Face& face) const;
  /// Point of the face near `p`; nothing: there is none within kMostOff.
  std::optional<Foot> foot(const Face& face, const Vec3& p) const;
  std::optional<Foot> middleOf(const Piece& piece, const Face& face, std::size_t k) const;
  void findCreases(Piece& piece);
  void refine(const ConvexProfile& part, const Piece& piece);
  bool isAlong(const Vec3& normal) const;
  void push(const ConvexProfile& part, Piece piece, double within);

  static constexpr double kSlackMm = 1e-5;
  const ContactQuery& query_;
  Vec3 from_, to_;
  double slack_;  ///< contacts this near to each other, in t, are one
  double best_ = std::numeric_limits<double>::infinity();
  std::uint64_t pieces_ = 0;
  std::vector<Stretch> free_;  ///< of the part in hand, by their begin; they do not overlap
  std::priority_queue<Piece> queue_;
  std::map<std::size_t, Face> faces_;                                   ///< by triangle
  std::map<std::pair<std::uint32_t, std::size_t>, SweptField> sweeps_;  ///< by motion and part of its tool
};

Triangle ContactSearch::triangleAt(std::size_t i) const {
  const TriMesh& mesh = query_.surface_.mesh;
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = mesh.positions[mesh.triangles[i][k]].cast<double>();
  return t;
}

double ContactSearch::cornersOff(const Triangle& t, const Face& face) const {
  double off = 0.0;
  for (const Vec3& p : t) {
    const auto q = foot(face, p);
    off = std::max(off, q ? (q->at - p).norm() : query_.h_);
  }
  return off;
}

const ContactSearch::Face& ContactSearch::faceOf(std::size_t i) {
  const auto [found, fresh] = faces_.try_emplace(i);
  Face& face = found->second;
  if (!fresh) return face;
  const Triangle t = triangleAt(i);
  const Vec3 normal = normalOf(t);
  face.at = t[0];
  if (!(normal.norm() > 0.0)) return face;
  face.n = normal.normalized();
  const std::uint32_t motion = query_.surface_.mesh.motion[i];
  if (motion < query_.path_.motions.size()) {
    findSweep(i, t, face);
  } else if (motion == kNoMotion && query_.blank_ != nullptr) {
    face.blank = true;
    face.blank = cornersOff(t, face) <= kCornerOff * query_.h_;
  }
  return face;
}

/// The part of the motion's tool whose swept volume the corners lie on.
void ContactSearch::findSweep(std::size_t i, const Triangle& t, Face& face) {
  const std::uint32_t motion = query_.surface_.mesh.motion[i];
  const Motion& m = query_.path_.motions[motion];
  const auto solid = query_.solids_.find(m.tool);
  if (solid == query_.solids_.end()) return;
  const std::vector<ConvexProfile>& parts = solid->second.cutter;
  double least = kCornerOff * query_.h_;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Face tried = face;
    auto known = sweeps_.find({motion, k});
    if (known == sweeps_.end())
      known = sweeps_.emplace(std::pair(motion, k), motionField(parts[k], wayOf(query_.path_, m))).first;
    tried.sweep = &known->second;
    const double off = cornersOff(t, tried);
    if (off > least) continue;
    least = off;
    face.sweep = tried.sweep;
  }
}

std::optional<ContactSearch::Foot> ContactSearch::foot(const Face& face, const Vec3& p) const {
  Vec3 q = p, n = face.n;
  if (face.sweep != nullptr) {
    // Put into the material along the face's own normal there, the point comes back without a step aside.
    Vec3 inwards = -face.n;
    double start = SweptField::kAnywhere;
    for (int round = 0; round < 2; ++round) {
      const Vec3 deep = p + kPush * query_.h_ * inwards;
      const SweepSample s = face.sweep->sampleOutside(deep, kFootMm, start);
      q = deep - s.value * s.gradient;
      inwards = s.gradient;
    }
    n = -inwards;
  } else if (face.blank) {
    const BlankSample s = query_.blank_->sample(p);
    q -= s.value * s.normal;
    n = s.normal;
  } else {
    q -= face.n.dot(p - face.at) * face.n;
  }
  if (!((q - p).norm() <= kMostOff * query_.h_)) return std::nullopt;
  return Foot{q, n};
}

/// Middle of edge k on the surface; of a crease on both of its faces.
std::optional<ContactSearch::Foot> ContactSearch::middleOf(const Piece& piece, const Face& face,
                                                           std::size_t k) const {
  constexpr int kRounds = 20;
  constexpr double kStill = 1e-8;
  std::optional<Foot> p = foot(face, 0.5 * (piece.t[k] + piece.t[(k + 1) % 3]));
  for (int round = 0; p && piece.crease[k] != nullptr && round < kRounds; ++round) {
    const Vec3 before = p->at;
    p = foot(*piece.crease[k], p->at);
    if (p) p = foot(face, p->at);
    if (p && (p->at - before).norm() <= kStill) break;
  }
  return p;
}

/// Edges where the mesh turns by more than a few degrees: its chords there are those of a crease.
void ContactSearch::findCreases(Piece& piece) {
  constexpr double kTurn = 0.95;
  const Face& own = faceOf(piece.source);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto other = query_.across(piece.source, k);
    if (!other) continue;
    const Face& face = faceOf(*other);
    if (face.n.dot(own.n) < kTurn && face.n.norm() > 0.5) piece.crease[k] = &face;
  }
}

void ContactSearch::push(const ConvexProfile& part, Piece piece, double within) {
  PROVEOUT_ASSERT(piece.depth <= kMaxDepth);
  const auto cast = castAgainst(part, from_, to_, piece.t, within);
  if (!cast) return;
  piece.bound = raised(*cast);
  if (piece.bound > 1.0 || piece.bound >= best_ - slack_) return;
  piece.number = ++pieces_;
  queue_.push(piece);
}

/// Divides the piece until it is flat, then meets it. What the way goes along is not touched.
void ContactSearch::refine(const ConvexProfile& part, const Piece& piece) {
  const Face& face = faceOf(piece.source);
  const Triangle& t = piece.t;
  std::array<Vec3, 3> m;
  bool flat = piece.depth == kMaxDepth || !(face.n.norm() > 0.5), along = !flat;
  double off = 0.0;
  for (std::size_t k = 0; k < 4 && !flat; ++k) {
    const Vec3 p = k < 3 ? Vec3(0.5 * (t[k] + t[(k + 1) % 3])) : Vec3((t[0] + t[1] + t[2]) / 3.0);
    const auto q = k < 3 ? middleOf(piece, face, k) : foot(face, p);
    flat = !q;
    if (q) off = std::max(off, (q->at - p).norm());
    if (q && k < 3) m[k] = q->at;
    along = along && q && isAlong(q->n);
  }
  if (along) return;
  if (flat || off <= ContactQuery::kContactFlatMm) {
    if (const auto at = castAgainst(part, from_, to_, t)) best_ = std::min(best_, raised(*at));
    return;
  }
  const auto& c = piece.crease;
  const auto child = [&](const Triangle& corners, const std::array<const Face*, 3>& crease) {
    push(part, {0.0, 0, piece.source, piece.depth + 1, corners, crease}, off);
  };
  child({t[0], m[0], m[2]}, {c[0], nullptr, c[2]});
  child({m[0], t[1], m[1]}, {c[0], c[1], nullptr});
  child({m[2], m[1], t[2]}, {nullptr, c[1], c[2]});
  child(m, {});
}

/// Whether the way goes along a face with that normal.
bool ContactSearch::isAlong(const Vec3& normal) const {
  return std::abs(normal.dot(to_ - from_)) <= kAlong * (to_ - from_).norm();
}

/// Where the way runs on that of a motion that has cut with such a part.
void ContactSearch::addFree(const Motion& motion) {
  const Vec3 way = to_ - from_;
  const double length = way.norm();
  const Vec3 along = way / length;
  const auto aside = [&](const Vec3& p) { return (p - from_).cross(along).norm(); };
  if (!(aside(motion.from) <= kSameWayMm && aside(motion.to) <= kSameWayMm)) return;
  const double a = (motion.from - from_).dot(along) / length, b = (motion.to - from_).dot(along) / length;
  if (std::max(a, b) >= 0.0 && std::min(a, b) <= 1.0) free_.push_back({std::min(a, b), std::max(a, b)});
}

void ContactSearch::findFree(const ConvexProfile& part) {
  free_.clear();
  if (!((to_ - from_).norm() > 0.0)) return;
  std::map<int, bool> cuts;  // by tool: whether it has such a part
  for (const Motion& motion : query_.path_.motions) {
    const MotionWay cut = wayOf(query_.path_, motion);
    if (motion.arc >= 0 || motion.kind == MotionKind::kProbe || cut.leans() || cut.turns()) continue;
    const auto [known, fresh] = cuts.try_emplace(motion.tool, false);
    if (fresh) {
      const auto solid = query_.solids_.find(motion.tool);
      known->second = solid != query_.solids_.end() &&
                      std::any_of(solid->second.cutter.begin(), solid->second.cutter.end(),
                                  [&](const ConvexProfile& cutter) { return same(cutter, part); });
    }
    if (known->second) addFree(motion);
  }
  std::sort(free_.begin(), free_.end(), [](const Stretch& a, const Stretch& b) { return a.begin < b.begin; });
}

/// `t`, or where the part leaves what it has cut before.
double ContactSearch::raised(double t) const {
  // Points are within kTouchMm of the parameter that a cast gives.
  for (const Stretch& stretch : free_) {
    if (stretch.begin - slack_ > t) break;
    t = std::max(t, stretch.end);
  }
  return t;
}

void ContactSearch::add(const ConvexProfile& part) {
  findFree(part);
  const double around = kMostOff * query_.h_;
  const Box3 reach = SweptField(part, from_, to_, nullptr).bounds().inflated(around);
  for (std::size_t i = 0; i < query_.surface_.mesh.triangles.size(); ++i) {
    const Triangle t = triangleAt(i);
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    if (reach.overlaps(Box3{low, high})) push(part, {0.0, 0, i, 0, t, {}}, around);
  }
  while (!queue_.empty() && queue_.top().bound < best_ - slack_) {
    Piece piece = queue_.top();
    queue_.pop();
    if (piece.depth == 0) findCreases(piece);
    refine(part, piece);
  }
  queue_ = {};
}

std::optional<double> ContactQuery::firstContact(const Tool& tool, const Vec3& from, const Vec3& to) const {
  const ToolSolid solid = makeToolSolid(tool);
  ContactSearch search(*this, from, to);
  for (const auto* parts : {&solid.cutter, &solid.shank, &solid.holder}) {
    for (const ConvexProfile& part : *parts) search.add(part);
  }
  return search.best();
}

}  // namespace proveout
