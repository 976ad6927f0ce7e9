#include "removal/cut/leaf_cutter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/assert.h"

namespace proveout {

namespace {

/// Samples that are deeper in a solid than one by no more than this factor are left alone.
constexpr double kNearlyDeepest = 1.25;

/// Transposes an 8x8 matrix of bits: bit y of byte z becomes bit z of byte y.
std::uint64_t transposeBits(std::uint64_t x) {
  std::uint64_t t = (x ^ x >> 7) & 0x00AA00AA00AA00AAull;
  x ^= t ^ t << 7;
  t = (x ^ x >> 14) & 0x0000CCCC0000CCCCull;
  x ^= t ^ t << 14;
  t = (x ^ x >> 28) & 0x00000000F0F0F0F0ull;
  return x ^ t ^ t << 28;
}

void layersToColumns(const LeafBits& layers, unsigned char* columns) {
  for (int x = 0; x < 8; ++x) {
    std::uint64_t rows = 0;
    for (int z = 0; z < 8; ++z) rows |= (layers[z] >> 8 * x & 0xFF) << 8 * z;
    const std::uint64_t bytes = transposeBits(rows);
    for (int y = 0; y < 8; ++y) columns[leafColumn(x, y)] = static_cast<unsigned char>(bytes >> 8 * y);
  }
}

void columnsToLayers(const unsigned char* columns, LeafBits& layers) {
  layers = {};
  for (int x = 0; x < 8; ++x) {
    std::uint64_t bytes = 0;
    for (int y = 0; y < 8; ++y) bytes |= static_cast<std::uint64_t>(columns[leafColumn(x, y)]) << 8 * y;
    const std::uint64_t rows = transposeBits(bytes);
    for (int z = 0; z < 8; ++z) layers[z] |= (rows >> 8 * z & 0xFF) << 8 * x;
  }
}

std::int64_t volumeUnits(double voxels) { return std::llround(voxels / kVolumeUnit); }

}  // namespace

void LeafCutter::cut(LeafChange& change, std::span<const StackReach> list) {
  PROVEOUT_ASSERT_DEAR(std::is_sorted(
      list.begin(), list.end(), [](const StackReach& a, const StackReach& b) { return a.pass < b.pass; }));
  start(change);
  if (columns_.layers == 0) return;
  for (std::size_t i = 0; i < list.size() && columns_.layers != 0;) {
    if (list[i].low >= highest_ || !counts(list[i])) {
      ++i;
    } else if (const std::size_t pieces = applyPieces(list.subspan(i))) {
      i += pieces;
    } else {
      apply(list[i++].pass);
    }
  }
  PROVEOUT_ASSERT(onlyTook());
  columnsToLayers(columns_.material, change.material);
  change.takers = takers_;
}

bool LeafCutter::counts(const StackReach& reach) const { return reach.counts(columns_.z[0], end_); }

double LeafCutter::highest() const {
  return level_tops_ && !columns_.undercut ? highest_ : std::numeric_limits<double>::infinity();
}

/// Whether no sample has become material.
bool LeafCutter::onlyTook() const {
  ColumnWords now;
  std::memcpy(now.data(), columns_.material, sizeof(now));
  std::uint64_t more = 0;
  for (int i = 0; i < 8; ++i) more |= now[i] & ~initial_[i];
  return more == 0;
}

/// Applies the pieces of one volume at the front of the list, if there are any, and returns their number.
/// They are one motion, so that their order does not count: those that reach lowest leave nothing to most
/// others.
std::size_t LeafCutter::applyPieces(std::span<const StackReach> list) {
  const Pass& first = table_.passes[list[0].pass];
  if (!first.body.isPiece() || first.watched || !first.cuts()) return 0;
  std::size_t count = 0;
  lowest_first_.clear();
  for (; count < list.size() && table_.passes[list[count].pass].body.isPieceWith(first.body); ++count) {
    if (counts(list[count])) lowest_first_.push_back({list[count].pass, list[count].low, list[count].high});
  }
  std::stable_sort(lowest_first_.begin(), lowest_first_.end(),
                   [](const Reach& a, const Reach& b) { return a.low < b.low; });
  for (const Reach& reach : lowest_first_) {
    if (reach.low >= highest_ || columns_.layers == 0) break;
    apply(reach.pass);
  }
  return count;
}

void LeafCutter::start(const LeafChange& change) {
  origin_ = change.origin;
  level_tops_ = false;
  removed_.clear();
  contacts_.clear();
  near_.clear();
  met_ = nullptr;
  evaluations_ = 0;
  covered_ = 0;
  LeafColumns& l = columns_;
  l.h = impl_.h;
  l.layers = 0;
  end_ = impl_.position(origin_.offsetBy(0, 0, 8)).z();
  for (int z = 0; z < 8; ++z) {
    l.z[z] = impl_.position(origin_.offsetBy(0, 0, z)).z();
    if (change.material[z] != 0) l.layers = z + 1;
  }
  if (l.layers == 0) return;
  layersToColumns(change.material, l.material);
  std::memcpy(initial_.data(), l.material, sizeof(initial_));
  joined_x_ = joined_y_ = joined_z_ = {};
  l.undercut = false;
  takers_ = {kNoPass, kNoPass};
  level_tops_ = true;
  most_sunk_ = 0.0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 at = impl_.position(origin_.offsetBy(i, i, 0));
    for (int k = 0; k < 8; ++k) {
      l.x[leafColumn(i, k)] = at.x();
      l.y[leafColumn(k, i)] = at.y();
    }
  }
  startTops(change);
  const Vec3 low = impl_.position(origin_);
  const double half = quarters_.half_width = 1.5 * l.h;
  for (int q = 0; q < 4; ++q) {
    quarters_.x[q] = low.x() + half + (q >> 1) * 4 * l.h;
    quarters_.y[q] = low.y() + half + (q & 1) * 4 * l.h;
    quarters_.z_low[q] = l.z[0];
    setQuarterTop(q);
  }
}

/// Of each column and the next along x and y: what both have.
void LeafCutter::pairUp(const ColumnWords& columns, ColumnWords& x, ColumnWords& y) {
  constexpr std::uint64_t kLastY = 0xFF000000FF000000;
  for (int q = 0; q < 4; ++q) {  // a word: two rows of four columns along y
    const std::uint64_t a = columns[2 * q], b = columns[2 * q + 1];
    const std::uint64_t beyond_x = q < 2 ? columns[2 * q + 4] : 0;
    x[2 * q] = a & (a >> 32 | b << 32);
    x[2 * q + 1] = b & (b >> 32 | beyond_x << 32);
    const std::uint64_t beyond_a = q % 2 == 0 ? columns[2 * q + 2] : 0,
                        beyond_b = q % 2 == 0 ? columns[2 * q + 3] : 0;
    y[2 * q] = a & ((a >> 8 & ~kLastY) | (beyond_a << 24 & kLastY));
    y[2 * q + 1] = b & ((b >> 8 & ~kLastY) | (beyond_b << 24 & kLastY));
  }
}

bool LeafCutter::holdsEdges(const Pass& pass) const {
  if (pass.body.isConvex()) return true;
  const Vec3 low = impl_.position(origin_), high = impl_.position(origin_.offsetBy(8, 8, 8));
  return pass.body.holdsEdges(impl_.h, 0.5 * (low + high).head<2>(), 6.0 * impl_.h);
}

/// Notes the edges that the last pass covered whole, level ones if `level`; `quarters` (bits) are those that
/// it went through.
void LeafCutter::join(unsigned quarters, bool level) {
  ColumnWords covered, x, y;
  for (int q = 0; q < 4; ++q) {
    if ((quarters >> q & 1) != 0) cover(q);
  }
  std::memcpy(covered.data(), columns_.covered, sizeof(covered));
  for (unsigned q = 0; q < 4; ++q) {
    if ((quarters >> q & 1) == 0) covered[2 * q] = covered[2 * q + 1] = 0;
  }
  if (columns_.undercut) joinUpright(covered);
  if (!level) return;
  pairUp(covered, x, y);
  for (int i = 0; i < 8; ++i) {
    joined_x_[i] |= x[i];
    joined_y_[i] |= y[i];
  }
}

/// A pass covers one stretch of each column.
void LeafCutter::joinUpright(const ColumnWords& covered) {
  constexpr std::uint64_t kNotLast = 0x7F7F7F7F7F7F7F7F;
  const double beyond = columns_.z[7] + columns_.h;
  ColumnWords leads_on;
  std::array<unsigned char, 64> last;
  for (int c = 0; c < 64; ++c) last[c] = columns_.hi[c] > beyond ? 0x80 : 0;
  std::memcpy(leads_on.data(), last.data(), sizeof(leads_on));
  for (int i = 0; i < 8; ++i) joined_z_[i] |= covered[i] & ((covered[i] >> 1 & kNotLast) | leads_on[i]);
}

std::unique_ptr<OpenEdges> LeafCutter::openEdges() const {
  ColumnWords taken, x, y;
  std::memcpy(taken.data(), columns_.material, sizeof(taken));
  for (int i = 0; i < 8; ++i) taken[i] = initial_[i] & ~taken[i];
  pairUp(taken, x, y);
  std::uint64_t any = 0;
  for (int i = 0; i < 8; ++i) {
    x[i] &= ~joined_x_[i];
    y[i] &= ~joined_y_[i];
    any |= x[i] | y[i];
  }
  if (any == 0 && !columns_.undercut) return nullptr;
  auto open = std::make_unique<OpenEdges>();
  for (int i = 0; i < 8; ++i) taken[i] &= ~joined_z_[i];
  columnsToLayers(reinterpret_cast<const unsigned char*>(taken.data()), open->upright);
  columnsToLayers(reinterpret_cast<const unsigned char*>(x.data()), open->level[0]);
  columnsToLayers(reinterpret_cast<const unsigned char*>(y.data()), open->level[1]);
  open->undercut = columns_.undercut;
  return open;
}

void LeafCutter::setQuarterTop(int quarter) {
  const double* top = columns_.top + quarter * kQuarter;
  const double* all = quarters_.z_high;
  double most[4] = {top[0], top[1], top[2], top[3]};
  for (int i = 4; i < kQuarter; i += 4) {
    for (int k = 0; k < 4; ++k) most[k] = std::max(most[k], top[i + k]);
  }
  quarters_.z_high[quarter] = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  highest_ = *std::max_element(all, all + 4);
  const unsigned bit = 1u << quarter;
  open_ = all[quarter] > columns_.z[0] ? open_ | bit : open_ & ~bit;
}

/// Heights that the removed volume is counted from: the crossing above the highest sample, or the next leaf.
void LeafCutter::startTops(const LeafChange& change) {
  const StockLeaf* leaf = reader_.leaf(origin_);
  LeafColumns& l = columns_;
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      const int c = leafColumn(x, y);
      const int highest = std::bit_width(static_cast<unsigned>(l.material[c])) - 1;
      l.top[c] = highest < 0 ? l.z[0] : l.z[highest] + l.h;
      if (highest < 0 || leaf == nullptr || !change.before.isCrossed(2, x, y, highest)) continue;
      l.top[c] = l.z[highest] + leaf->crossings[change.before.indexOf(2, x, y, highest)].t * l.h;
    }
  }
}

void LeafCutter::apply(std::uint32_t number) {
  const Pass& pass = table_.passes[number];
  if (pass.isEnvelope()) return lookAround(number);
  const bool asked = pass.watched || !pass.cuts();
  const unsigned hits = asked ? 15 : pass.body.hits(columns_, open_, highest_);
  if (hits == 0) return;
  double sunk = 0.0, low[4], high[4];
  pass.body.reach(quarters_, low, high);
  unsigned quarters = 0;
  for (int q = 0; q < 4; ++q) {
    if (low[q] < quarters_.z_high[q]) quarters |= 1u << q;
  }
  pass.body.leafColumns(columns_, quarters & hits);
  for (int q = 0; q < 4; ++q) {
    if ((quarters & hits) >> q & 1) sunk += applyQuarter(number, q);
  }
  if (sunk <= 0.0) return;
  if (const bool level = holdsEdges(pass); level || columns_.undercut) {
    look(pass, quarters & ~hits);
    join(quarters, level);
  }
  takers_[1] = number;
  if (!pass.body.coversUpTo(end_ + columns_.h)) level_tops_ = false;
  if (sunk > most_sunk_) {
    most_sunk_ = sunk;
    takers_[0] = number;
  }
  removed_.emplace_back(pass.motion, volumeUnits(sunk / columns_.h));
  unsigned any = 0;
  for (int c = 0; c < 64; ++c) any |= columns_.material[c];
  columns_.layers = std::bit_width(any);
}

/// What stands near to the part that an envelope is around.
void LeafCutter::lookAround(std::uint32_t number) {
  const Pass& envelope = table_.passes[number];
  double low[4], high[4];
  envelope.body.reach(quarters_, low, high);
  unsigned quarters = 0;
  for (unsigned q = 0; q < 4; ++q) {
    if (low[q] < quarters_.z_high[q] && high[q] > columns_.z[0]) quarters |= 1u << q;
  }
  if (quarters == 0) return;
  look(envelope, quarters);
  for (int q = 0; q < 4; ++q) {
    if ((quarters >> q & 1) == 0) continue;
    cover(q);
    addNearSamples(table_, number + static_cast<std::uint32_t>(envelope.around), columns_, q, near_);
  }
  covered_ &= ~quarters;
}

/// Finds what the pass covers in quarters (bits) that it takes nothing from.
void LeafCutter::look(const Pass& pass, unsigned quarters) {
  pass.body.leafColumns(columns_, quarters);
  covered_ &= ~quarters;
}

void LeafCutter::cover(int quarter) {
  if ((covered_ >> quarter & 1) != 0) return;
  cover_(columns_, quarter);
  covered_ |= 1u << quarter;
}

/// Height of columns that the pass, whose columns are found, takes away, mm; 0 for parts that do not cut.
double LeafCutter::applyQuarter(std::uint32_t number, int quarter) {
  const Pass& pass = table_.passes[number];
  LeafColumns& l = columns_;
  const int first = quarter * kQuarter;
  const bool cutter = pass.cuts(), watched = pass.watched || !cutter;
  double top[kQuarter];
  if (watched) std::copy_n(l.top + first, kQuarter, top);
  const double sunk = lower_(l, quarter);
  covered_ &= ~(1u << quarter);
  evaluations_ += kQuarter;
  if (watched) {
    cover(quarter);
    contact(number, quarter, top);
  }
  if (!cutter) {
    std::copy_n(top, kQuarter, l.top + first);
    return 0.0;
  }
  if (sunk <= 0.0) return 0.0;
  cover(quarter);
  for (int c = first; c < first + kQuarter; ++c) l.material[c] &= static_cast<unsigned char>(~l.covered[c]);
  setQuarterTop(quarter);
  return sunk;
}

/// Height of what a part touches in a column, mm: below its top, which was at `from`, or samples further
/// down. Parts of one curve lie over each other: what another one touched does not count again.
double LeafCutter::countMet(int column, double from, unsigned touched) {
  const auto c = static_cast<std::size_t>(column);
  const double low = columns_.top[column], known = met_low_[c];
  const unsigned fresh = touched & ~static_cast<unsigned>(met_bits_[c]);
  met_bits_[c] |= static_cast<unsigned char>(touched);
  if (low >= from) return columns_.h * countBits(fresh);
  met_low_[c] = std::min(known, low);
  return std::max(0.0, std::min(from, known) - low);
}

/// How deep the solid reaches below the tops (`top`: before the pass) and below samples of a quarter. No
/// place lies deeper in it than in its column, nor than the tool's axis comes near.
void LeafCutter::contact(std::uint32_t number, int quarter, const double* top) {
  const Pass& pass = table_.passes[number];
  const LeafColumns& l = columns_;
  ContactSample found{number, 0.0, Vec3::Zero(), 0};
  double height = 0.0;
  if (met_ == nullptr || !pass.body.isPieceWith(met_->body)) {
    met_low_.fill(std::numeric_limits<double>::infinity());
    met_bits_.fill(0);
  }
  met_ = &pass;
  const SweptField field = pass.body.field();
  const auto look = [&](int c, double z, double most) {
    const double known = found.depth > kContactToleranceMm ? kNearlyDeepest * found.depth : found.depth;
    if (std::min({most, z - l.lo[c], l.hi[c] - z}) <= known) return;
    const Vec3 at(l.x[c], l.y[c], z);
    const double depth = -field.distance(at, -found.depth);
    if (depth > found.depth) found.depth = depth, found.where = at;
  };
  for (int i = 0; i < kQuarter; ++i) {
    const int c = quarter * kQuarter + i;
    const unsigned touched = l.covered[c] & l.material[c];
    if (touched == 0 && l.top[c] >= top[i]) continue;
    const double most = pass.body.mostDepth(l.x[c], l.y[c]);
    if (l.top[c] < top[i]) look(c, top[i], most);
    for (int z = 7; z >= 0; --z) {
      if (touched >> z & 1) look(c, l.z[z], most);
    }
    height += countMet(c, top[i], touched);
  }
  if (found.depth <= kContactToleranceMm) return;
  found.volume = volumeUnits(height / l.h);
  contacts_.push_back(found);
}

}  // namespace proveout
