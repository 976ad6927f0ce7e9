#include "removal/leaf_cutter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace proveout {

namespace {

/// Penetration that counts as contact, mm: below any gauge on a shop floor.
constexpr double kContactToleranceMm = 1e-3;

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
    std::memcpy(columns + 8 * x, &bytes, 8);
  }
}

void columnsToLayers(const unsigned char* columns, LeafBits& layers) {
  layers = {};
  for (int x = 0; x < 8; ++x) {
    std::uint64_t bytes;
    std::memcpy(&bytes, columns + 8 * x, 8);
    const std::uint64_t rows = transposeBits(bytes);
    for (int z = 0; z < 8; ++z) layers[z] |= (rows >> 8 * z & 0xFF) << 8 * x;
  }
}

static_assert(std::endian::native == std::endian::little, "bytes of a word stand for columns in order");

std::int64_t volumeUnits(double voxels) { return std::llround(voxels / kVolumeUnit); }

}  // namespace

void LeafCutter::cut(LeafChange& change, std::span<const std::uint32_t> list) {
  start(change);
  if (columns_.layers == 0) return;
  for (const std::uint32_t number : list) {
    apply(number);
    if (columns_.layers == 0) break;
  }
  columnsToLayers(columns_.material, change.material);
}

void LeafCutter::start(const LeafChange& change) {
  origin_ = change.origin;
  removed_.clear();
  contacts_.clear();
  evaluations_ = 0;
  LeafColumns& l = columns_;
  l.h = impl_.h;
  l.layers = 0;
  for (int z = 0; z < 8; ++z) {
    l.z[z] = impl_.position(origin_.offsetBy(0, 0, z)).z();
    if (change.material[z] != 0) l.layers = z + 1;
  }
  if (l.layers == 0) return;
  layersToColumns(change.material, l.material);
  for (int i = 0; i < 8; ++i) {
    const Vec3 at = impl_.position(origin_.offsetBy(i, i, 0));
    for (int k = 0; k < 8; ++k) {
      l.x[8 * i + k] = at.x();
      l.y[8 * k + i] = at.y();
    }
  }
  const Vec3 middle = impl_.position(origin_) + Vec3::Constant(3.5 * impl_.h);
  box_ = {middle.x(), middle.y(), 3.5 * impl_.h, l.z[0], l.z[7]};
  startTops(change);
}

/// Heights that the removed volume is counted from: the crossing above the highest sample, or the next leaf.
void LeafCutter::startTops(const LeafChange& change) {
  const StockLeaf* leaf = reader_.leaf(origin_);
  LeafColumns& l = columns_;
  for (int c = 0; c < 64; ++c) {
    const int highest = std::bit_width(static_cast<unsigned>(l.material[c])) - 1;
    l.top[c] = highest < 0 ? l.z[0] : l.z[highest] + l.h;
    if (highest < 0 || leaf == nullptr || !change.before.isCrossed(2, c >> 3, c & 7, highest)) continue;
    const float t = leaf->crossings[change.before.indexOf(2, c >> 3, c & 7, highest)].t;
    l.top[c] = l.z[highest] + t * l.h;
  }
}

void LeafCutter::apply(std::uint32_t number) {
  const Pass& pass = table_.passes[number];
  LeafColumns& l = columns_;
  // Up to one step above the highest samples a pass removes volume, though no sample.
  box_.z_high = l.z[l.layers - 1] + l.h;
  if (reachIn(pass, box_) >= box_.z_high) return;
  const bool cutter = pass.part == ToolPart::kCutter, watched = pass.watched || !cutter;
  double top[64];
  if (watched) std::copy_n(l.top, 64, top);
  const double sunk = kernel_(pass.columns, l);
  evaluations_ += 64;
  if (watched) contact(number, top);
  if (!cutter) {
    std::copy_n(top, 64, l.top);
    return;
  }
  if (sunk > 0.0) removed_.emplace_back(pass.motion, volumeUnits(sunk / l.h));
  unsigned any = 0;
  for (int c = 0; c < 64; ++c) {
    l.material[c] &= static_cast<unsigned char>(~l.covered[c]);
    any |= l.material[c];
  }
  l.layers = std::bit_width(any);
}

/// How deep the solid reaches below the tops (`top`: before the pass) and below samples.
void LeafCutter::contact(std::uint32_t number, const double* top) {
  const Pass& pass = table_.passes[number];
  const LeafColumns& l = columns_;
  ContactSample found{number, 0.0, Vec3::Zero(), 0};
  double height = 0.0;
  const Sweep* arc = table_.levelArc(pass);
  const Sweep sweep = arc != nullptr ? *arc : pass.lineSweep();
  const auto look = [&](int c, double z) {
    const Vec3 at(l.x[c], l.y[c], z);
    const double depth = -sweep.distance(at, 0.0);
    if (depth > found.depth) found.depth = depth, found.where = at;
  };
  for (int c = 0; c < 64; ++c) {
    const unsigned touched = l.covered[c] & l.material[c];
    if (l.top[c] < top[c]) look(c, top[c]);
    for (int z = 0; z < 8; ++z) {
      if (touched >> z & 1) look(c, l.z[z]);
    }
    height += l.top[c] < top[c] ? top[c] - l.top[c] : l.h * std::popcount(touched);
  }
  if (found.depth <= kContactToleranceMm) return;
  found.volume = volumeUnits(height / l.h);
  contacts_.push_back(found);
}

}  // namespace proveout
