#include "removal/surface/cell/leaf_placer.h"

#include <algorithm>

#include "core/geometry/to_float.h"
#include "removal/surface/cell/low_step.h"

namespace proveout {

namespace {

/// A cell's surface bends little if its normals are within 12 degrees (cosine) of their mean.
constexpr float kGentleCos = 0.978f;
/// Vertices this far (in cells) outside the blank are put back: more than the rounding of its crossings.
constexpr double kBlankSlack = 1e-4;
/// Vertices farther off the surface than this, in cells, are reported: ridges and walls there are lost
/// between the samples.
constexpr double kOffBy = 0.2;
/// Vertices that stand out of the middle of their crossings by less than this are not, as tools are larger
/// than cells.
constexpr double kStandsOut = 0.15;
/// A face is trimmed before a vertex that is farther off its body than this, in cells; another face
/// continues it there if their normals are nearer than this (cosine).
constexpr double kTrimDistance = 0.02, kContinuesCos = 0.9;
/// As long as normals are within this of their mean (2 degrees, cosine), the crossings place the vertex of
/// any smooth face to better than 1e-3 cells.
constexpr float kBentCos = 0.9994f;
constexpr float kNormalUnit = 1.0f / Crossing::kNormalScale;

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

const std::array<CellPattern, kPatterns>& cellPatterns() {
  static const auto kTable = tableOfPatterns<CellPattern>(patternOf);
  return kTable;
}

}  // namespace

LeafPlacer::LeafPlacer(const Stock::Impl& impl, SurfaceLeaf& leaf, const CrossingTable& crossings,
                       LeafPatch* patch)
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

LeafPlacer::Placed LeafPlacer::place(int bit, int z, int rank, CellShape shape) {
  const int x = bit >> 3, y = bit & 7, sheets = cellCycles(shape).count;
  cell_.pattern = shape < kPatterns ? &cellPatterns()[shape] : &(joined_ = patternOf(shape));
  cell_.edges = CrossingTable::index(0, x, y, z);
  cell_.place = static_cast<std::uint16_t>(z << 6 | bit);
  cell_.rank = static_cast<std::uint16_t>(rank);
  cell_.origin = Vec3(x, y, z);
  cell_.faces = oneSheetFaces(shape);
  chooseState(leaf_.stock->origin.offsetBy(x, y, z));
  Placed out;
  Eigen::Vector3f n;
  if (sheets == 1 && placeOneFace(out.p, n)) {
    out.traits = cell_.faces | CellTraits::kSmooth;
    out.p += Eigen::Vector3f(x, y, z);
    keepGentle(out.p, n);
    return out;
  }
  asked_ = Vec3::Constant(kNoLimit);
  return sheets == 1 ? placeOneSheet() : placeSheets(sheets);
}

/// The vertex of a sheet by its crossings and bodies. `brought`: receives whether none of its faces came to
/// where they seemed to meet.
CellVertex LeafPlacer::vertexOf(int count, bool may_bring, bool& brought) {
  CellVertex v = placeVertex({points_.data(), static_cast<std::size_t>(count)}, exact_);
  const Vec3 on_feature = v.p;
  brought = may_bring && !v.smooth && exact_->active() && bringToSurface(v, count);
  if (v.outside && !v.smooth && isCutAway(v.p, count)) {
    v.p = v.inside;
    v.outside = false;
  }
  keepInBlank(v.p);
  keepInBlank(v.inside);
  if (!(v.p == on_feature)) v.along = Vec3::Zero();
  return v;
}

LeafPlacer::Placed LeafPlacer::placeOneSheet() {
  const int count = gather(0);
  bool brought = false;
  const CellVertex v = vertexOf(count, true, brought);
  Placed out;
  out.p = toFloat(cell_.origin + v.p);
  out.traits = cell_.faces | (v.smooth ? CellTraits::kSmooth : 0);
  leaf_.hidden += v.lifted;
  if (v.along != Vec3::Zero()) leaf_.feature_edges.push_back({cell_.place, v.outside, toFloat(v.along)});
  if (const auto step = findLowStep({points_.data(), static_cast<std::size_t>(count)}, *exact_)) {
    out.traits |= CellTraits::kStep;
    leaf_.steps.push_back(
        {cell_.rank, toFloat(cell_.origin + step->low), toFloat(cell_.origin + step->high), step->motion});
  }
  if (!v.smooth && isOffSurface(v.p, count)) {
    out.traits |= CellTraits::kOff;
    noteOff(kNoLimit, count, v.p);
  }
  if (brought) out.traits |= CellTraits::kMisses;
  if (const double missed = v.smooth || !exact_->active() ? 0.0 : missedBy(v.p, count); missed > 0.0) {
    out.traits |= CellTraits::kMisses;
    if (!goesOnBeside(v.p, count)) noteOff(missed, count, v.p);
  }
  Eigen::Vector3f n;
  if (v.outside) {
    out.traits |= CellTraits::kOutside;
    leaf_.outside.push_back(
        {cell_.place, toFloat(cell_.origin + v.inside), !v.smooth && isOffSurface(v.inside, count)});
  } else if (patch_ != nullptr && bendsLittle(count, n)) {
    keepGentle(out.p, n);
  }
  return out;
}

LeafPlacer::Placed LeafPlacer::placeSheets(int sheets) {
  std::array<Vec3, 4> p, mean;
  mean.fill(Vec3::Zero());
  for (int sheet = 0; sheet < sheets; ++sheet) {
    const int count = gather(sheet);
    bool brought = false;
    const CellVertex v = vertexOf(count, false, brought);
    // Beside another sheet a vertex leaves its cell by little at most.
    const bool near = (v.p - v.inside).squaredNorm() < 1.0 && v.p.minCoeff() > -kThinReach &&
                      v.p.maxCoeff() < 1.0 + kThinReach;
    p[sheet] = near ? v.p : v.inside;
    noteOff((v.p - p[sheet]).norm(), count, p[sheet]);
    for (int i = 0; i < count; ++i) mean[sheet] += points_[i].p / count;
  }
  keepApart({p.data(), static_cast<std::size_t>(sheets)}, mean);
  for (int sheet = 0; sheet < sheets; ++sheet) {
    keepInBlank(p[sheet]);
    if (sheet > 0)
      leaf_.extra.push_back({cell_.rank, static_cast<std::uint8_t>(sheet), toFloat(cell_.origin + p[sheet])});
  }
  return {toFloat(cell_.origin + p[0]), static_cast<std::uint16_t>(cell_.faces | CellTraits::kManySheets)};
}

void LeafPlacer::chooseState(const Coord& voxel) {
  const CellPattern& cell = *cell_.pattern;
  const auto isOld = [&](const CellEdge& e) {
    return knownMotion(crossings_[cell_.edges + e.offset]->motion) == kNoMotion;
  };
  const bool old = has_before_ && std::all_of(cell.edges.begin(), cell.edges.begin() + cell.count, isOld);
  exact_ = old ? &before_ : &cut_;
  for (ExactFaces* faces : {&cut_, &before_}) faces->setCell(impl_.position(voxel));
}

bool LeafPlacer::placeOneFace(Eigen::Vector3f& p, Eigen::Vector3f& normal) {
  const CellPattern& cell = *cell_.pattern;
  std::array<Eigen::Vector3f, 12> points, normals;
  Eigen::Vector3f mean = Eigen::Vector3f::Zero(), sum = mean;
  const Crossing* first = crossings_[cell_.edges + cell.edges[0].offset];
  bool flat = true;
  for (int i = 0; i < cell.count; ++i) {
    const CellEdge& e = cell.edges[i];
    const Crossing* c = crossings_[cell_.edges + e.offset];
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

bool LeafPlacer::sweepEndsWithin(std::int64_t body, const std::array<Eigen::Vector3f, 12>& points,
                                 const std::array<Eigen::Vector3f, 12>& normals, int count) const {
  const int first = exact_->sweepEndAt(body, points[0].cast<double>(), normals[0].cast<double>());
  for (int i = 1; i < count; ++i) {
    if (exact_->sweepEndAt(body, points[i].cast<double>(), normals[i].cast<double>()) != first) return true;
  }
  return false;
}

bool LeafPlacer::bends(const std::array<Eigen::Vector3f, 12>& normals, int count,
                       const Eigen::Vector3f& mean) {
  for (int i = 0; i < count; ++i) {
    if (normals[i].dot(mean) < kBentCos) return true;
  }
  return false;
}

void LeafPlacer::keepInBlank(Vec3& p) const {
  const Vec3 kept = (cell_.origin + p).cwiseMax(low_).cwiseMin(high_) - cell_.origin;
  if ((kept - p).cwiseAbs().maxCoeff() > kBlankSlack) p = kept;
}

int LeafPlacer::gather(int sheet) {
  const CellPattern& cell = *cell_.pattern;
  int count = 0;
  for (int i = 0; i < cell.count; ++i) {
    const CellEdge& e = cell.edges[i];
    if (e.cycle != sheet) continue;
    const Crossing* c = crossings_[cell_.edges + e.offset];
    SheetPoint& s = points_[count++];
    s.p = Vec3(e.start[0], e.start[1], e.start[2]);
    s.p[e.axis] += c->t;
    s.n = c->unitNormal();
    s.face = c->face();
  }
  return count;
}

bool LeafPlacer::isOffSurface(const Vec3& p, int count) {
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

void LeafPlacer::noteOff(double off, int count, const Vec3& p) {
  for (int i = 0; i < count; ++i) off = std::min(off, (p - points_[i].p).norm());
  if (toFloat(off) > leaf_.farthest.off) leaf_.farthest = {toFloat(off), cell_.place};
}

bool LeafPlacer::bringToSurface(CellVertex& v, int count) {
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

bool LeafPlacer::goesOnBeside(const Vec3& p, int count) {
  constexpr double kPart = 0.25;
  for (int i = 0; i < count; ++i) {
    const ExactFaces::Source source = exact_->source(points_[i].face);
    const Vec3 beside = p + kPart * (points_[i].p - p);
    const bool trimmed = source.ends_at_rims && exact_->isFarther(source.body, beside, kTrimDistance);
    if (trimmed && !exact_->isReachedByOthers(source.body, beside)) return false;
  }
  return true;
}

double LeafPlacer::missedBy(const Vec3& p, int count) {
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

bool LeafPlacer::isCutAway(const Vec3& p, int count) {
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

void LeafPlacer::keepApart(std::span<Vec3> p, const std::array<Vec3, 4>& mean) {
  for (std::size_t i = 1; i < p.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 across = (mean[i] - mean[j]).normalized();
      const double missing = kSheetGap - across.dot(p[i] - p[j]);
      if (missing <= 0.0 || missing > kThinReach) continue;
      const Vec3 back = p[j] - missing * across, on = p[i] + missing * across;
      const bool inside = back.minCoeff() > 0.0 && back.maxCoeff() < 1.0;
      (inside ? p[j] : p[i]) = inside ? back : on;
    }
  }
}

bool LeafPlacer::bendsLittle(int count, Eigen::Vector3f& n) const {
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < count; ++i) sum += points_[i].n;
  n = toFloat(sum.normalized());
  for (int i = 0; i < count; ++i) {
    if (n.dot(toFloat(points_[i].n)) < kGentleCos) return false;
  }
  return true;
}

void LeafPlacer::keepGentle(const Eigen::Vector3f& p, const Eigen::Vector3f& n) {
  if (patch_ == nullptr || cell_.faces != 0) return;
  patch_->gentle[cell_.place >> 6] |= 1ull << (cell_.place & 63);
  patch_->p[cell_.rank] = p;
  patch_->n[cell_.rank] = n;
}

}  // namespace proveout
