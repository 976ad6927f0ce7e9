#include "removal/surface/cell/surface_grid.h"

#include <algorithm>
#include <tuple>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "removal/grid/leaf_layers.h"
#include "removal/surface/cell/face_joins.h"
#include "removal/surface/cell/low_step.h"

namespace proveout {

namespace {

/// A cell's surface bends little if its normals are within 12 degrees (cosine) of their mean.
constexpr float kGentleCos = 0.978f;
/// How far vertices of cells with several sheets may leave them, in cells.
constexpr double kThinReach = 0.1;
/// Vertices this far (in cells) outside the blank are put back: more than the rounding of its crossings.
constexpr double kBlankSlack = 1e-4;
constexpr double kNoLimit = 1e12;
const Vec3 kNoPlace = Vec3::Constant(kNoLimit);
/// Vertices farther off the surface than this, in cells, are reported: ridges and walls there are lost
/// between the samples.
constexpr double kOffBy = 0.2;
/// Vertices that stand out of the middle of their crossings by less than this are not, as tools are larger
/// than cells.
constexpr double kStandsOut = 0.15;
/// A face is trimmed before a vertex that is farther off its body than this, in cells; another face
/// continues it there if their normals are nearer than this (cosine).
constexpr double kTrimDistance = 0.02, kContinuesCos = 0.9;
/// Sheets of one cell keep their vertices this far apart (in cells), as seen from one to the other.
constexpr double kSheetGap = 0.01;
/// As long as normals are within this of their mean (2 degrees, cosine), the crossings place the vertex of
/// any smooth face to better than 1e-3 cells.
constexpr float kBentCos = 0.9994f;
constexpr float kNormalUnit = 1.0f / Crossing::kNormalScale;

/// The crossings that the cells of a leaf touch, by the start of their edge (0..8 in each coordinate). Only
/// entries of crossed edges are valid.
class CrossingTable {
 public:
  void fill(const std::vector<SurfaceLeaf>& leaves, const SurfaceLeaf& leaf) {
    const Crossing* c = leaf.stock->crossings.data();
    forEachEdge(leaf.edges, [&](int axis, int x, int y, int z) { at_[index(axis, x, y, z)] = c++; });
    for (int i = 1; i < 7; ++i) {
      if (leaf.upper[i] >= 0) fillFrom(leaves[static_cast<std::size_t>(leaf.upper[i])], i);
    }
  }
  static int index(int axis, int x, int y, int z) { return ((axis * 9 + x) * 9 + y) * 9 + z; }
  const Crossing* operator[](int i) const { return at_[i]; }

 private:
  /// `place`: of the leaf, as seen from the one whose cells are read.
  void fillFrom(const SurfaceLeaf& leaf, int place) {
    const int dx = (place & 1) * 8, dy = (place >> 1 & 1) * 8, dz = (place >> 2) * 8;
    const std::uint64_t columns = (dx != 0 ? kColumnX0 : ~0ull) & (dy != 0 ? kColumnY0 : ~0ull);
    for (int axis = 0; axis < 3; ++axis) {
      if (place >> axis & 1) continue;
      for (int z = 0; z < (dz != 0 ? 1 : 8); ++z) {
        const std::uint64_t crossed = leaf.edges.crossed[axis][z];
        for (std::uint64_t rest = crossed & columns; rest != 0; rest &= rest - 1) {
          const int bit = std::countr_zero(rest);
          const int n = leaf.edges.first[axis][z] + countBits(crossed & ((1ull << bit) - 1));
          at_[index(axis, (bit >> 3) + dx, (bit & 7) + dy, z + dz)] =
              &leaf.stock->crossings[static_cast<std::size_t>(n)];
        }
      }
    }
  }
  std::array<const Crossing*, 3 * 729> at_;
};

/// A crossed edge of a cell: what to add to the cell's index in a CrossingTable, its start and its axis.
struct CellEdge {
  std::int16_t offset;
  std::int8_t axis, cycle;
  std::array<float, 3> start;
};
struct CellPattern {
  int count = 0;
  std::array<CellEdge, 12> edges{};
};

CellPattern patternOf(CellShape shape) {
  const CellCycles cycles = cellCycles(shape);
  CellPattern out;
  for (int e = 0; e < 12; ++e) {
    const int cycle = cycles.cycle_of_edge[e];
    if (cycle < 0) continue;
    const int corner = edgeStartCorner(e), axis = e / 4;
    const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    out.edges[out.count++] = {static_cast<std::int16_t>(CrossingTable::index(axis, x, y, z)),
                              static_cast<std::int8_t>(axis),
                              static_cast<std::int8_t>(cycle),
                              {toFloat(x), toFloat(y), toFloat(z)}};
  }
  return out;
}

std::uint8_t findOneSheetFaces(CellShape shape) {
  const CellCycles cycles = cellCycles(shape);
  const auto& cycle = cycles.cycle_of_edge;
  std::uint8_t out = 0;
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, base = (face & 1) << axis;
    const int first = cycle[edgeAt(u, base)];
    if (first >= 0 && cycle[edgeAt(u, base | 1 << v)] == first && cycle[edgeAt(v, base)] == first &&
        cycle[edgeAt(v, base | 1 << u)] == first) {
      out |= static_cast<std::uint8_t>(1 << face);
    }
  }
  return out;
}

const std::array<CellPattern, kPatterns>& cellPatterns() {
  static const auto kTable = tableOfPatterns<CellPattern>(patternOf);
  return kTable;
}

/// Places the vertices of one leaf's cells.
class LeafPlacer {
 public:
  LeafPlacer(const Stock::Impl& impl, SurfaceLeaf& leaf, const CrossingTable& crossings, LeafPatch* patch)
      : impl_(impl),
        leaf_(leaf),
        crossings_(crossings),
        patch_(patch),
        cut_(impl, leaf.stock->origin),
        before_(ExactFaces::beforeCut(impl, leaf.stock->origin)),
        has_before_(impl.cut_field != nullptr) {
    if (impl.blank.empty()) return;
    const Vec3 origin = impl.position(leaf.stock->origin);
    low_ = (impl.blank.min - origin) / impl.h;
    high_ = (impl.blank.max - origin) / impl.h;
  }

  struct Placed {
    Eigen::Vector3f p;
    std::uint16_t traits = 0;
  };

  Placed place(int bit, int z, int rank, CellShape shape) {
    const CellPattern& cell = shape < kPatterns ? cellPatterns()[shape] : joined_ = patternOf(shape);
    const int x = bit >> 3, y = bit & 7, at = CrossingTable::index(0, x, y, z);
    const std::uint8_t faces = oneSheetFaces(shape);
    const int sheets = cellCycles(shape).count;
    Placed out;
    Eigen::Vector3f n;
    setCell(cell, at, leaf_.stock->origin.offsetBy(x, y, z));
    if (sheets == 1 && placeOneFace(cell, at, out.p, n)) {
      out.traits = faces | CellTraits::kSmooth;
      out.p += Eigen::Vector3f(x, y, z);
      keepGentle(bit, z, rank, faces, out.p, n);
      return out;
    }
    asked_ = kNoPlace;
    for (int sheet = 0; sheet < sheets; ++sheet) {
      const int count = gather(cell, at, sheet);
      CellVertex v = placeVertex({points_.data(), static_cast<std::size_t>(count)}, exact_);
      const Vec3 origin(x, y, z), on_feature = v.p;
      const bool brought = sheets == 1 && !v.smooth && exact_->active() && bringToSurface(v, count);
      if (v.outside && !v.smooth && isCutAway(v.p, count)) {
        v.p = v.inside;
        v.outside = false;
      }
      keepInBlank(origin, v.p);
      keepInBlank(origin, v.inside);
      // Beside another sheet a vertex leaves its cell by little at most.
      const bool near = (v.p - v.inside).squaredNorm() < 1.0 && v.p.minCoeff() > -kThinReach &&
                        v.p.maxCoeff() < 1.0 + kThinReach;
      const Vec3& thin = near ? v.p : v.inside;
      if (sheets > 1) {
        noteOff((v.p - thin).norm(), count, thin, bit, z);
        sheet_p_[sheet] = thin;
        sheet_mean_[sheet] = Vec3::Zero();
        for (int i = 0; i < count; ++i) sheet_mean_[sheet] += points_[i].p / count;
      }
      if (sheet > 0) {
        leaf_.extra.push_back(
            {static_cast<std::uint16_t>(rank), static_cast<std::uint8_t>(sheet), toFloat(origin + thin)});
        continue;
      }
      out.p = toFloat(origin + (sheets == 1 ? v.p : thin));
      out.traits = faces | (v.smooth && sheets == 1 ? CellTraits::kSmooth : 0);
      if (sheets > 1) continue;
      leaf_.hidden += v.lifted;
      if (v.along != Vec3::Zero() && v.p == on_feature)
        leaf_.feature_edges.push_back(
            {static_cast<std::uint16_t>(z << 6 | bit), v.outside, toFloat(v.along)});
      if (const auto step = findLowStep({points_.data(), static_cast<std::size_t>(count)}, *exact_)) {
        out.traits |= CellTraits::kStep;
        leaf_.steps.push_back({static_cast<std::uint16_t>(rank), toFloat(origin + step->low),
                               toFloat(origin + step->high), step->motion});
      }
      if (!v.smooth && isOffSurface(v.p, count)) {
        out.traits |= CellTraits::kOff;
        noteOff(kNoLimit, count, v.p, bit, z);
      }
      if (brought) out.traits |= CellTraits::kMisses;
      if (const double missed = v.smooth || !exact_->active() ? 0.0 : missedBy(v.p, count); missed > 0.0) {
        out.traits |= CellTraits::kMisses;
        if (!goesOnBeside(v.p, count)) noteOff(missed, count, v.p, bit, z);
      }
      if (v.outside) {
        leaf_.outside.push_back({static_cast<std::uint16_t>(z << 6 | bit), toFloat(origin + v.inside),
                                 !v.smooth && isOffSurface(v.inside, count)});
        out.traits |= CellTraits::kOutside;
      } else if (patch_ != nullptr && bendsLittle(count, n)) {
        keepGentle(bit, z, rank, faces, out.p, n);
      }
    }
    if (sheets > 1) {
      out.traits |= CellTraits::kManySheets;
      keepApart(sheets);
      for (int sheet = 0; sheet < sheets; ++sheet) keepInBlank(Vec3(x, y, z), sheet_p_[sheet]);
      const Eigen::Vector3f origin(x, y, z);
      out.p = origin + toFloat(sheet_p_[0]);
      ExtraVertex* extra = leaf_.extra.data() + leaf_.extra.size() - (sheets - 1);
      for (int sheet = 1; sheet < sheets; ++sheet, ++extra) extra->p = origin + toFloat(sheet_p_[sheet]);
    }
    return out;
  }

 private:
  /// Where the path made none of the crossings, the cell is read as it was before it.
  void setCell(const CellPattern& cell, int at, const Coord& voxel) {
    const auto isOld = [&](const CellEdge& e) {
      return knownMotion(crossings_[at + e.offset]->motion) == kNoMotion;
    };
    const bool old = has_before_ && std::all_of(cell.edges.begin(), cell.edges.begin() + cell.count, isOld);
    exact_ = old ? &before_ : &cut_;
    for (ExactFaces* faces : {&cut_, &before_}) faces->setCell(impl_.position(voxel));
  }

  /// The usual case: all crossings are of one face and their normals do not spread widely. The rule is that
  /// of placeVertex.
  bool placeOneFace(const CellPattern& cell, int at, Eigen::Vector3f& p, Eigen::Vector3f& normal) {
    std::array<Eigen::Vector3f, 12> points, normals;
    Eigen::Vector3f mean = Eigen::Vector3f::Zero(), sum = mean;
    const Crossing* first = crossings_[at + cell.edges[0].offset];
    bool flat = true;
    for (int i = 0; i < cell.count; ++i) {
      const CellEdge& e = cell.edges[i];
      const Crossing* c = crossings_[at + e.offset];
      if (c->face() != first->face()) return false;
      flat = flat && c->normal[0] == first->normal[0] && c->normal[1] == first->normal[1] &&
             c->normal[2] == first->normal[2];
      points[i] = Eigen::Vector3f(e.start[0], e.start[1], e.start[2]);
      points[i][e.axis] += c->t;
      normals[i] = Eigen::Vector3f(c->normal[0], c->normal[1], c->normal[2]) * kNormalUnit;
      mean += points[i];
      sum += normals[i];
    }
    const float share = 1.0f / toFloat(cell.count);
    p = mean * share;
    normal = sum.normalized();
    if (flat) return true;
    if (exact_->active()) {
      const ExactFaces::Source source = exact_->source(first->face());
      if (!source.simple && bends(normals, cell.count, normal)) return false;
      if (!source.isShown() && !source.cone && sweepEndsWithin(source.body, points, normals, cell.count))
        return false;
    }
    float height = 0.0f;
    for (int i = 0; i < cell.count; ++i) {
      const Eigen::Vector3f middle = normals[i] + normal;
      const float along = middle.dot(normal);
      if (along < 1.97f) return false;  // 14 degrees: the full rules
      height += middle.dot(p - points[i]) / along;
    }
    p -= normal * (height * share);
    return p.minCoeff() > 1e-3f && p.maxCoeff() < 1.0f - 1e-3f;
  }

  /// Whether some crossings of a face are of the tool in passing, and others of the round where its motion
  /// began or ended.
  bool sweepEndsWithin(std::int64_t body, const std::array<Eigen::Vector3f, 12>& points,
                       const std::array<Eigen::Vector3f, 12>& normals, int count) const {
    const int first = exact_->sweepEndAt(body, points[0].cast<double>(), normals[0].cast<double>());
    for (int i = 1; i < count; ++i) {
      if (exact_->sweepEndAt(body, points[i].cast<double>(), normals[i].cast<double>()) != first) return true;
    }
    return false;
  }

  static bool bends(const std::array<Eigen::Vector3f, 12>& normals, int count, const Eigen::Vector3f& mean) {
    for (int i = 0; i < count; ++i) {
      if (normals[i].dot(mean) < kBentCos) return true;
    }
    return false;
  }

  /// Where a sliver at the blank's face crosses no edge of the cell, the other faces may meet outside the
  /// blank.
  void keepInBlank(const Vec3& origin, Vec3& p) const {
    const Vec3 kept = (origin + p).cwiseMax(low_).cwiseMin(high_) - origin;
    if ((kept - p).cwiseAbs().maxCoeff() > kBlankSlack) p = kept;
  }

  int gather(const CellPattern& cell, int at, int sheet) {
    int count = 0;
    for (int i = 0; i < cell.count; ++i) {
      const CellEdge& e = cell.edges[i];
      if (e.cycle != sheet) continue;
      const Crossing* c = crossings_[at + e.offset];
      SheetPoint& s = points_[count++];
      s.p = Vec3(e.start[0], e.start[1], e.start[2]);
      s.p[e.axis] += c->t;
      s.n = c->unitNormal();
      s.face = c->face();
    }
    return count;
  }

  /// Whether a vertex is off the surface: on none of the faces of its crossings, or where another tool cut
  /// away what is there. Never near a crossing. Vertices of a blank whose faces are known are put onto them.
  bool isOffSurface(const Vec3& p, int count) {
    if (exact_->ofBlank()) return isCutAway(p, count);
    double nearest2 = kNoLimit, plane = kNoLimit;
    bool on_blank = false;  // the nearest plane is the blank's
    for (int i = 0; i < count; ++i) {
      const Vec3 from = p - points_[i].p;
      nearest2 = std::min(nearest2, from.squaredNorm());
      const double off = std::abs(points_[i].n.dot(from));
      if (off < plane) {
        plane = off;
        on_blank = exact_->source(points_[i].face).body <= ExactFaces::kNoBody;
      }
    }
    if (nearest2 < kOffBy * kOffBy) return false;
    if (plane > kOffBy) return true;
    if (on_blank && exact_->isOffCutBlank(p, kOffBy)) return true;
    return isCutAway(p, count);
  }

  /// Keeps how far a vertex is off the surface: no farther than the nearest crossing.
  void noteOff(double off, int count, const Vec3& p, int bit, int z) {
    for (int i = 0; i < count; ++i) off = std::min(off, (p - points_[i].p).norm());
    if (toFloat(off) > leaf_.farthest.off)
      leaf_.farthest = {toFloat(off), static_cast<std::uint16_t>(z << 6 | bit)};
  }

  /// Where cones seem to meet beyond the ends of all their bodies, below tips that are smaller than the cell,
  /// there is no vertex: it is put onto the surface, where the nearest body is as seen from the material. Of
  /// other faces the place where they seem to meet says more of the volume.
  bool bringToSurface(CellVertex& v, int count) {
    constexpr double kBeyond = 0.05;
    for (int i = 0; i < count; ++i) {
      const ExactFaces::Source source = exact_->source(points_[i].face);
      if (!source.cone || exact_->ofBlank() || !exact_->isFarther(source.body, v.p, kBeyond)) return false;
    }
    Vec3 mean = Vec3::Zero(), normal = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
      mean += points_[i].p / count;
      normal += points_[i].n;
    }
    const Vec3 probe = mean - ExactFaces::kProbeDepth * normal.normalized();
    double least = kNoLimit;
    Vec3 nearest = v.inside;
    for (int i = 0; i < count; ++i) {
      const std::int64_t body = exact_->source(points_[i].face).body;
      const Vec3 foot = exact_->foot(body, probe).p;
      if (const double distance = (foot - probe).squaredNorm(); distance < least) {
        least = distance;
        nearest = foot;
      }
    }
    if (outsideBy(nearest) > -kWallGap) return false;
    v.p = v.inside = nearest;
    v.outside = false;
    return true;
  }

  /// Whether some other body comes to the faces that are trimmed before a vertex, on the way from it to their
  /// crossings, as the next motion does on one floor.
  bool goesOnBeside(const Vec3& p, int count) {
    constexpr double kPart = 0.25;
    for (int i = 0; i < count; ++i) {
      const ExactFaces::Source source = exact_->source(points_[i].face);
      const Vec3 beside = p + kPart * (points_[i].p - p);
      const bool trimmed = source.ends_at_rims && exact_->isFarther(source.body, beside, kTrimDistance);
      if (trimmed && !exact_->isReachedByOthers(source.body, beside)) return false;
    }
    return true;
  }

  /// How far (in cells) before the vertex a face is trimmed that no other continues: there is surface beside
  /// the vertex that no crossing shows. 0 where there is none.
  double missedBy(const Vec3& p, int count) {
    std::array<double, 12> missed{};
    bool any = false;
    for (int i = 0; i < count; ++i) {
      const ExactFaces::Source source = exact_->source(points_[i].face);
      if (!source.ends_at_rims) continue;
      const bool as_before = i > 0 && points_[i].face == points_[i - 1].face;
      const double distance = as_before ? missed[i - 1] : exact_->distanceTo(source.body, p, kVertexReach);
      missed[i] = distance > kTrimDistance ? distance : 0.0;
      any = any || missed[i] > 0.0;
    }
    if (!any) return 0.0;
    const auto isContinued = [&](int i) {
      for (int j = 0; j < count; ++j) {
        if (missed[j] == 0.0 && points_[i].n.dot(points_[j].n) > kContinuesCos) return true;
      }
      return false;
    };
    double most = 0.0;
    for (int i = 0; i < count; ++i) {
      if (missed[i] > most && !isContinued(i)) most = missed[i];
    }
    return most;
  }

  /// Whether a tool cut away what is at a vertex without making one of its crossings. Only asked where the
  /// vertex stands out from among them, as asking all tools is expensive.
  bool isCutAway(const Vec3& p, int count) {
    Vec3 middle = Vec3::Zero(), normal = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
      if ((p - points_[i].p).squaredNorm() < kOffBy * kOffBy) return false;
      middle += points_[i].p;
      normal += points_[i].n;
    }
    const double height = std::abs((p - middle / count).dot(normal));
    if (height <= kStandsOut * normal.norm()) return false;
    if (!(p == asked_)) {  // mostly asked twice
      covered_ = cut_.isCovered(p, kOffBy);
      asked_ = p;
    }
    return covered_;
  }

  /// Where a wall narrower than the cell ends, two sheets end at one place: their vertices are on the wrong
  /// sides of each other by no more than their uncertainty, and are put right.
  void keepApart(int sheets) {
    for (int i = 1; i < sheets; ++i) {
      for (int j = 0; j < i; ++j) {
        const Vec3 across = (sheet_mean_[i] - sheet_mean_[j]).normalized();
        const double missing = kSheetGap - across.dot(sheet_p_[i] - sheet_p_[j]);
        if (missing <= 0.0 || missing > kThinReach) continue;
        const Vec3 back = sheet_p_[j] - missing * across, on = sheet_p_[i] + missing * across;
        const bool inside = back.minCoeff() > 0.0 && back.maxCoeff() < 1.0;
        (inside ? sheet_p_[j] : sheet_p_[i]) = inside ? back : on;
      }
    }
  }

  bool bendsLittle(int count, Eigen::Vector3f& n) const {
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < count; ++i) sum += points_[i].n;
    n = toFloat(sum.normalized());
    for (int i = 0; i < count; ++i) {
      if (n.dot(toFloat(points_[i].n)) < kGentleCos) return false;
    }
    return true;
  }

  void keepGentle(int bit, int z, int rank, std::uint8_t faces, const Eigen::Vector3f& p,
                  const Eigen::Vector3f& n) {
    if (patch_ == nullptr || faces != 0) return;
    patch_->gentle[z] |= 1ull << bit;
    patch_->p[rank] = p;
    patch_->n[rank] = n;
  }

  const Stock::Impl& impl_;
  SurfaceLeaf& leaf_;
  const CrossingTable& crossings_;
  LeafPatch* patch_;
  ExactFaces cut_, before_;
  bool has_before_;            ///< the blank's faces were known before the path
  ExactFaces* exact_ = &cut_;  ///< the one that answers for the cell
  Vec3 low_ = Vec3::Constant(-kNoLimit),
       high_ = Vec3::Constant(kNoLimit);  ///< the blank, in the leaf's cells
  Vec3 asked_ = kNoPlace;  ///< the last place of this cell of which it was asked whether it is covered
  bool covered_ = false;
  CellPattern joined_;  ///< of the cell, where it has joined faces
  std::array<SheetPoint, 12> points_;
  std::array<Vec3, 4> sheet_p_, sheet_mean_;  ///< of the sheets of one cell: vertices, means of the crossings
};

/// The places of one layer across an axis.
LeafBits layerAcross(int axis, int layer) {
  LeafBits bits{};
  for (int z = 0; z < 8; ++z) {
    bits[z] = axis == 0 ? kColumnX0 << 8 * layer : axis == 1 ? kColumnY0 << layer : z == layer ? ~0ull : 0ull;
  }
  return bits;
}

LevelFace levelFace(const SurfaceLeaf& leaf) {
  LevelFace out;
  const std::vector<Crossing>& crossings = leaf.stock->crossings;
  if (leaf.cells != 64 || leaf.edges.count != 64 || crossings.size() != 64) return out;
  const auto* const normal = crossings.front().normal;
  int axis = 0;
  while (axis < 2 && normal[axis] == 0) ++axis;
  if (normal[(axis + 1) % 3] != 0 || normal[(axis + 2) % 3] != 0) return out;
  int layer = 0;
  while (layer < 8 && layerAcross(axis, layer) != leaf.mixed) ++layer;
  if (layer == 8 || leaf.edges.crossed[axis] != leaf.mixed) return out;
  if (std::any_of(crossings.begin(), crossings.end(), [&](const Crossing& c) { return c != crossings[0]; }))
    return out;
  out.axis = static_cast<std::int8_t>(axis);
  out.layer = static_cast<std::int8_t>(layer);
  out.crossing = crossings.front();
  std::array<int, 3> place{};
  place[axis] = layer;
  out.material_below = leafSample(leaf.stock->material(), place[0], place[1], place[2]);
  return out;
}

}  // namespace

std::uint8_t oneSheetFaces(CellShape shape) {
  static const auto kTable = tableOfPatterns<std::uint8_t>(findOneSheetFaces);
  return shape < kPatterns ? kTable[shape] : findOneSheetFaces(shape);
}

void SurfaceGrid::linkLeaf(SurfaceLeaf& leaf, std::size_t number) {
  const LeafReader read(impl_);
  leaf.stock = &impl_.leaves[number];
  const Coord& at = leaf.stock->origin;
  leaf.upper = read.statesBeside(at, 1);
  PROVEOUT_ASSERT(leaf.upper[0] == static_cast<std::int32_t>(number));
  // Each leaf enters itself as the lower one of its neighbours; the last entry is never read.
  for (std::size_t i = 0; i < 7; ++i) {
    if (leaf.upper[i] >= 0)
      leaves_[static_cast<std::size_t>(leaf.upper[i])].lower[i] = static_cast<std::int32_t>(number);
  }
  const BlockBits bits = blockBits(leaf);
  leaf.edges = leafEdges(leaf.stock->material(), {bits[1], bits[2], bits[4]});
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    leaf.mixed[z] = mixedBits(low[0], low[1], low[2], low[3], high[0], high[1], high[2], high[3]);
    leaf.first_cell[z] = leaf.cells;
    leaf.cells = static_cast<std::uint16_t>(leaf.cells + countBits(leaf.mixed[z]));
    low = high;
  }
  leaf.level = levelFace(leaf);
}

bool SurfaceGrid::isLevel(const SurfaceLeaf& leaf, const std::array<std::int32_t, 8>& beside) const {
  if (leaf.level.axis < 0) return false;
  const int u = 1 << (leaf.level.axis + 1) % 3, v = 1 << (leaf.level.axis + 2) % 3;
  for (const int place : {u, v, u | v}) {
    const std::int32_t n = beside[static_cast<std::size_t>(place)];
    if (n < 0 || leaves_[static_cast<std::size_t>(n)].level != leaf.level) return false;
  }
  return true;
}

BlockBits SurfaceGrid::blockBits(const SurfaceLeaf& leaf) const {
  BlockBits bits;
  for (int i = 0; i < 8; ++i) {
    const std::int32_t n = leaf.upper[i];
    bits[i] = n >= 0 ? &impl_.leaves[static_cast<std::size_t>(n)].material()
                     : (n == StockTree::kInside ? &kAllInside : &kAllOutside);
  }
  return bits;
}

/// What placeLeaf does, for a leaf and neighbours of one level face.
void SurfaceGrid::placeLevel(SurfaceLeaf& leaf) {
  constexpr std::array<std::uint8_t, 3> kLowCorners = {0x55, 0x33, 0x0F};
  leaf.all_level = true;
  const auto& [axis, layer, material_below, c] = leaf.level;
  const std::uint8_t low = kLowCorners[static_cast<std::size_t>(axis)];
  const CellShape shape = static_cast<std::uint8_t>(material_below ? low : ~low);
  const auto traits = static_cast<std::uint16_t>(oneSheetFaces(shape) | CellTraits::kSmooth);
  const float height = 0.25f * (c.t + c.t + c.t + c.t) + toFloat(layer);  // rounded as for any cell
  std::size_t number = leaf.base;
  for (int z = 0; z < 8; ++z) {
    for (std::uint64_t rest = leaf.mixed[z]; rest != 0; rest &= rest - 1, ++number) {
      const int bit = std::countr_zero(rest);
      Eigen::Vector3f p = Eigen::Vector3f(bit >> 3, bit & 7, z) + Eigen::Vector3f::Constant(0.5f);
      p[axis] = height;
      vertices_[number] = p;
      shapes_[number] = shape;
      traits_[number] = traits;
    }
  }
  const Eigen::Vector3f normal(c.normal[0], c.normal[1], c.normal[2]);
  if (flatness_ > 0.0) leaf.clusters = planeClusters((normal * kNormalUnit).normalized());
}

void SurfaceGrid::placeLeaf(SurfaceLeaf& leaf) {
  const auto flatness = toFloat(flatness_);
  if ((flatness == 0.0f || mergesPlanes(flatness)) && isLevel(leaf, leaf.upper)) return placeLevel(leaf);
  const BlockBits bits = blockBits(leaf);
  CrossingTable crossings;
  crossings.fill(leaves_, leaf);
  LeafPatch patch;
  LeafPlacer placer(impl_, leaf, crossings, flatness_ > 0.0 ? &patch : nullptr);
  const FaceJoins joins(impl_);
  int rank = 0;
  std::array<std::uint64_t, 4> low = cornerLayer(bits, 0);
  for (int z = 0; z < 8; ++z) {
    const std::array<std::uint64_t, 4> high = cornerLayer(bits, z + 1);
    for (std::uint64_t rest = leaf.mixed[z]; rest != 0; rest &= rest - 1, ++rank) {
      const int bit = std::countr_zero(rest);
      int pattern = 0;
      for (int c = 0; c < 4; ++c) {
        pattern |= static_cast<int>(low[c] >> bit & 1) << c | static_cast<int>(high[c] >> bit & 1) << (c + 4);
      }
      const Coord at = leaf.stock->origin.offsetBy(bit >> 3, bit & 7, z);
      const CellShape shape = joins.shapeOf(at, static_cast<std::uint8_t>(pattern));
      const LeafPlacer::Placed placed = placer.place(bit, z, rank, shape);
      const std::size_t number = leaf.base + static_cast<std::size_t>(rank);
      vertices_[number] = placed.p;
      shapes_[number] = shape;
      traits_[number] = placed.traits;
    }
    low = high;
  }
  PROVEOUT_ASSERT(rank == leaf.cells);
  PROVEOUT_ASSERT_DEAR(
      std::is_sorted(leaf.extra.begin(), leaf.extra.end(), [](const ExtraVertex& a, const ExtraVertex& b) {
        return std::tie(a.cell, a.sheet) < std::tie(b.cell, b.sheet);
      }));
  if (flatness_ > 0.0) {
    patch.faces = crossedFaces(bits);
    leaf.clusters = findClusters(leaf, patch, flatness);
  }
}

void SurfaceGrid::numberExtras() {
  for (SurfaceLeaf& leaf : leaves_) {
    leaf.extra_base = static_cast<std::uint32_t>(cell_count_ + extra_count_);
    extra_count_ += leaf.extra.size();
  }
}

std::size_t SurfaceGrid::countThin() const {
  constexpr std::uint16_t kThin = CellTraits::kManySheets | CellTraits::kOff;
  return static_cast<std::size_t>(std::count_if(&traits_[0], &traits_[cell_count_],
                                                [](std::uint16_t traits) { return (traits & kThin) != 0; }));
}

bool SurfaceGrid::build(Progress& progress) {
  leaves_.resize(impl_.leaves.size());
  const auto eachLeaf = [&](auto&& body) {
    parallelFor(std::size_t{0}, leaves_.size(), [&](std::size_t i) {
      if (!progress.cancelled()) body(i);
    });
  };
  eachLeaf([&](std::size_t i) { linkLeaf(leaves_[i], i); });
  if (progress.cancelled()) return true;
  for (SurfaceLeaf& leaf : leaves_) {
    if (leaf.stock->crossings.size() != leaf.edges.count) return false;
    leaf.base = static_cast<std::uint32_t>(cell_count_);
    cell_count_ += leaf.cells;
  }
  vertices_ = std::make_unique_for_overwrite<Eigen::Vector3f[]>(cell_count_);
  shapes_ = std::make_unique_for_overwrite<CellShape[]>(cell_count_);
  traits_ = std::make_unique_for_overwrite<std::uint16_t[]>(cell_count_);
  eachLeaf([&](std::size_t i) { placeLeaf(leaves_[i]); });
  if (!progress.cancelled()) numberExtras();
  return true;
}

std::size_t SurfaceGrid::leafOf(std::uint32_t cell) const {
  const auto above = std::upper_bound(leaves_.begin(), leaves_.end(), cell,
                                      [](std::uint32_t c, const SurfaceLeaf& leaf) { return c < leaf.base; });
  return static_cast<std::size_t>(above - leaves_.begin()) - 1;
}

std::uint32_t SurfaceGrid::cellOf(std::uint32_t vertex) const {
  if (vertex < cell_count_) return vertex;
  const auto above =
      std::upper_bound(leaves_.begin(), leaves_.end(), vertex,
                       [](std::uint32_t v, const SurfaceLeaf& leaf) { return v < leaf.extra_base; });
  const SurfaceLeaf& leaf = *(above - 1);
  return leaf.base + leaf.extra[vertex - leaf.extra_base].cell;
}

bool SurfaceGrid::putInside(std::uint32_t cell, const Eigen::Vector3f& p, bool off) {
  if (!(traits_[cell] & CellTraits::kFolds)) return false;
  if (off) traits_[cell] |= CellTraits::kOff;
  traits_[cell] &= static_cast<std::uint16_t>(~(CellTraits::kFolds | CellTraits::kOutside));
  vertices_[cell] = p;
  return true;
}

double SurfaceGrid::crossingOn(int axis, const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  if (number < 0) return 0.5;
  const SurfaceLeaf& leaf = leaves_[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leaf.edges.isCrossed(axis, x, y, z)) return 0.5;
  const auto i = static_cast<std::size_t>(leaf.edges.indexOf(axis, x, y, z));
  return std::clamp<double>(leaf.stock->crossings[i].t, kEndGap, 1.0 - kEndGap);
}

std::optional<std::uint32_t> SurfaceGrid::cellAt(const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  if (number < 0) return std::nullopt;
  const SurfaceLeaf& leaf = leaves_[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leafSample(leaf.mixed, x, y, z)) return std::nullopt;
  return leaf.cellAt(z << 6 | leafBit(x, y));
}

bool SurfaceGrid::isCrossed(int axis, const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  return number >= 0 &&
         leaves_[static_cast<std::size_t>(number)].edges.isCrossed(axis, at.x() & 7, at.y() & 7, at.z() & 7);
}

MotionId SurfaceGrid::motionOn(int axis, const Coord& at) const {
  const std::int32_t number = LeafReader(impl_).state(at & ~7);
  if (number < 0) return kNoMotion;
  const SurfaceLeaf& leaf = leaves_[static_cast<std::size_t>(number)];
  const int x = at.x() & 7, y = at.y() & 7, z = at.z() & 7;
  if (!leaf.edges.isCrossed(axis, x, y, z)) return kNoMotion;
  const int i = leaf.edges.indexOf(axis, x, y, z);
  return knownMotion(leaf.stock->crossings[static_cast<std::size_t>(i)].motion);
}

bool verticesInReach(const SurfaceGrid& grid) {
  constexpr double kRounding = 1e-4;
  const auto outside = [](const SurfaceLeaf& leaf, int rank, const Eigen::Vector3f& p) {
    const int place = leaf.placeOf(rank);
    return outsideBy(p.cast<double>() - Vec3(place >> 3 & 7, place & 7, place >> 6));
  };
  for (const SurfaceLeaf& leaf : grid.leaves()) {
    for (int rank = 0; rank < leaf.cells; ++rank) {
      const std::uint32_t cell = leaf.base + static_cast<std::uint32_t>(rank);
      const std::uint16_t traits = grid.traits(cell);
      const double reach = traits & CellTraits::kOutside      ? kVertexReach
                           : traits & CellTraits::kManySheets ? kThinReach + kSheetGap
                                                              : 0.0;
      if (!(outside(leaf, rank, grid.vertex(cell)) <= reach + kRounding)) return false;
    }
    for (const ExtraVertex& extra : leaf.extra) {
      if (!(outside(leaf, extra.cell, extra.p) <= kThinReach + kSheetGap + kRounding)) return false;
    }
  }
  return true;
}

}  // namespace proveout
