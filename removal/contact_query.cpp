#include "removal/contact_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <variant>

#include "removal/convex_cast.h"

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

Vec3 normalOf(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

std::unique_ptr<BlankField> roundBlank(const StockShape* blank) {
  const auto* cylinder = blank ? std::get_if<CylinderShape>(blank) : nullptr;
  if (cylinder == nullptr) return nullptr;
  Result<std::unique_ptr<BlankField>> field = makeBlankField(*cylinder);
  return field ? std::move(*field) : nullptr;
}

}  // namespace

ContactQuery::ContactQuery(StockSurface surface, const Toolpath& path, const std::vector<Tool>& tools,
                           const StockShape* blank, double resolution_mm)
    : surface_(std::move(surface)), path_(path), blank_(roundBlank(blank)), h_(resolution_mm) {
  for (const Tool& tool : tools) solids_.emplace(tool.number, makeToolSolid(tool));
}

/// One query: a tool's parts on one line.
class ContactSearch {
 public:
  ContactSearch(const ContactQuery& query, const Vec3& from, const Vec3& to)
      : query_(query), from_(from), to_(to) {}

  void add(const ConvexProfile& part);
  std::optional<double> best() const {
    if (best_ > 1.0) return std::nullopt;
    return best_;
  }

 private:
  /// The surface that a triangle is a part of.
  struct Face {
    const Sweep* sweep = nullptr;
    bool blank = false;
    bool known() const { return sweep != nullptr || blank; }
  };
  struct Candidate {
    double bound;  ///< the contact is not before it
    std::size_t triangle;
  };

  Triangle triangleAt(std::size_t i) const;
  Face faceOf(std::size_t i);
  /// Point of the face near `p`; `n`: unit, out of the material. Nothing: there is none within kMostOff.
  std::optional<Vec3> foot(const Face& face, const Vec3& p, const Vec3& n) const;
  void refine(const ConvexProfile& part, const Triangle& t, const Face& face, int depth);
  void meet(const ConvexProfile& part, const Triangle& t) {
    if (const auto at = castAgainst(part, from_, to_, t)) best_ = std::min(best_, *at);
  }

  const ContactQuery& query_;
  Vec3 from_, to_;
  double best_ = std::numeric_limits<double>::infinity();
  std::map<std::pair<std::uint32_t, std::size_t>, Sweep> sweeps_;  ///< by motion and part of its tool
};

Triangle ContactSearch::triangleAt(std::size_t i) const {
  const TriMesh& mesh = query_.surface_.mesh;
  Triangle t;
  for (std::size_t k = 0; k < 3; ++k) t[k] = mesh.positions[mesh.triangles[i][k]].cast<double>();
  return t;
}

ContactSearch::Face ContactSearch::faceOf(std::size_t i) {
  Face face;
  const std::uint32_t motion = query_.surface_.mesh.motion[i];
  const Triangle t = triangleAt(i);
  const Vec3 normal = normalOf(t);
  if (!(normal.norm() > 0.0)) return face;
  const Vec3 n = normal.normalized();
  const auto cornersOff = [&](const Face& f) {
    double off = 0.0;
    for (const Vec3& p : t) {
      const auto q = foot(f, p, n);
      off = std::max(off, q ? (*q - p).norm() : query_.h_);
    }
    return off;
  };
  if (motion >= query_.path_.motions.size()) {
    face.blank = motion == kNoMotion && query_.blank_ != nullptr;
    if (face.blank && cornersOff(face) > kCornerOff * query_.h_) face.blank = false;
    return face;
  }
  const Motion& m = query_.path_.motions[motion];
  const auto solid = query_.solids_.find(m.tool);
  if (solid == query_.solids_.end()) return face;
  double least = kCornerOff * query_.h_;
  const std::vector<ConvexProfile>& parts = solid->second.cutter;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const ArcGeometry* arc = m.arc < 0 ? nullptr : &query_.path_.arcs[static_cast<std::size_t>(m.arc)];
    const auto made = sweeps_.try_emplace({motion, k}, parts[k], m.from, m.to, arc).first;
    const double off = cornersOff({&made->second, false});
    if (off > least) continue;
    least = off;
    face.sweep = &made->second;
  }
  return face;
}

std::optional<Vec3> ContactSearch::foot(const Face& face, const Vec3& p, const Vec3& n) const {
  Vec3 q = p;
  if (face.sweep != nullptr) {
    q -= kPush * query_.h_ * n;
    const SweepSample s = face.sweep->sampleOutside(q, kFootMm);
    q -= s.value * s.gradient;
  } else {
    const BlankSample s = query_.blank_->sample(p);
    q -= s.value * s.normal;
  }
  if (!((q - p).norm() <= kMostOff * query_.h_)) return std::nullopt;
  return q;
}

void ContactSearch::refine(const ConvexProfile& part, const Triangle& t, const Face& face, int depth) {
  const Vec3 normal = normalOf(t);
  if (!face.known() || depth == kMaxDepth || !(normal.norm() > 0.0)) return meet(part, t);
  const Vec3 n = normal.normalized();
  std::array<Vec3, 3> middle;
  double off = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 p = k < 3 ? Vec3(0.5 * (t[k] + t[(k + 1) % 3])) : Vec3((t[0] + t[1] + t[2]) / 3.0);
    const auto q = foot(face, p, n);
    if (!q) return meet(part, t);
    off = std::max(off, (*q - p).norm());
    if (k < 3) middle[k] = *q;
  }
  if (off <= ContactQuery::kContactFlatMm) return meet(part, t);
  const auto bound = castAgainst(part, from_, to_, t, 2.0 * off);
  if (!bound || *bound >= best_) return;
  refine(part, {t[0], middle[0], middle[2]}, face, depth + 1);
  refine(part, {middle[0], t[1], middle[1]}, face, depth + 1);
  refine(part, {middle[2], middle[1], t[2]}, face, depth + 1);
  refine(part, middle, face, depth + 1);
}

void ContactSearch::add(const ConvexProfile& part) {
  const double around = kMostOff * query_.h_;
  const Box3 reach = Sweep(part, from_, to_, nullptr).bounds().inflated(around);
  std::vector<Candidate> candidates;
  const std::size_t count = query_.surface_.mesh.triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle t = triangleAt(i);
    const Vec3 low = t[0].cwiseMin(t[1]).cwiseMin(t[2]), high = t[0].cwiseMax(t[1]).cwiseMax(t[2]);
    if (!reach.overlaps(Box3{low, high})) continue;
    if (const auto bound = castAgainst(part, from_, to_, t, around)) candidates.push_back({*bound, i});
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.bound != b.bound ? a.bound < b.bound : a.triangle < b.triangle;
  });
  for (const Candidate& c : candidates) {
    if (c.bound >= best_) break;
    refine(part, triangleAt(c.triangle), faceOf(c.triangle), 0);
  }
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
