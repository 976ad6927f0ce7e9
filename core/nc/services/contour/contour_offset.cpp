#include "core/nc/services/contour/contour_offset.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/nc/services/cutter_comp.h"

namespace proveout {

namespace {

constexpr double kSame = 1e-6;  ///< mm; shorter elements are none

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

/// Whether the path keeps its distance from the contour, at points of it.
bool keepsDistance(const PlaneContour& path, const PlaneContour& contour, double distance) {
  constexpr int kPoints = 16;
  for (const ContourElement& e : path) {
    for (int k = 0; k <= kPoints; ++k) {
      const Vec2 p = pointOn(e, static_cast<double>(k) / kPoints);
      for (const ContourElement& c : contour) {
        if (distanceFrom(c, p) < distance - 1e-4) return false;
      }
    }
  }
  return true;
}

bool tooTight(const ContourElement& e, double offset) {
  return e.arc && (e.sweep > 0.0 ? offset : -offset) >= (e.to - e.center).norm();
}

/// Straight ways in and out, tangent to the contour: its first and last corners are none. Their blocks have
/// the tags 0 and `behind`, those of the contour 1 and up.
std::vector<CompBlock> withWaysInAndOut(const PlaneContour& contour, double offset, std::uint64_t behind,
                                        Vec2& first) {
  const double lead = 2.0 * std::abs(offset) + 1.0;
  const Vec2 in = directionOn(contour.front(), false), out = directionOn(contour.back(), true);
  const Vec2 start = contour.front().from, end = contour.back().to;
  first = start - 2.0 * lead * in;
  std::vector<CompBlock> blocks = {blockOf(lineElement(first, start - lead * in), offset, 0),
                                   blockOf(lineElement(start - lead * in, start), offset, 0)};
  for (std::size_t k = 0; k < contour.size(); ++k) blocks.push_back(blockOf(contour[k], offset, k + 1));
  blocks.push_back(blockOf(lineElement(end, end + lead * out), offset, behind));
  blocks.push_back(blockOf(lineElement(end + lead * out, end + 2.0 * lead * out), offset, behind));
  return blocks;
}

CutterCompPolicy rolling() {
  CutterCompPolicy policy;
  policy.start_ramp = policy.cancel_ramp = CompRamp::kA;
  policy.outer_corner = CompOuterCorner::kArc;
  policy.extra_look_ahead = 8;
  policy.min_step = 0.0;
  return policy;
}

}  // namespace

Result<PlaneContour> offsetContour(const PlaneContour& contour, double offset, bool& fits) {
  if (offset == 0.0 || contour.empty()) return contour;
  if (std::any_of(contour.begin(), contour.end(), [&](auto& e) { return tooTight(e, offset); })) {
    return inputError(
        "negative radius under compensation: an arc of the contour is smaller than tool and allowance");
  }
  const std::uint64_t behind = contour.size() + 1;
  Vec2 first;
  const std::vector<CompBlock> blocks = withWaysInAndOut(contour, offset, behind, first);
  CutterComp filter(rolling());
  filter.reset(Vec3(first.x(), first.y(), 0.0));
  CompOutput pieces;
  CompStatus status;
  for (const CompBlock& block : blocks) {
    if (status = filter.push(block, pieces); !status.ok()) break;
  }
  if (status.ok()) status = filter.flush(pieces);
  if (!status.ok()) return inputError("tool and allowance do not fit into the contour");
  PlaneContour result;
  for (const CompPiece& piece : pieces.pieces) {
    if (piece.tag == 0 || piece.tag == behind || piece.role == CompPiece::Role::kPassThrough) continue;
    ContourElement e = lineElement(piece.from.head<2>(), piece.to.head<2>());
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

void shiftContour(PlaneContour& contour, const Vec2& by) {
  for (ContourElement& e : contour) {
    e.from += by;
    e.to += by;
    e.center += by;
  }
}

double allowanceDepth(const ContourAllowance& stock, const ContourAllowance& finish) {
  if (stock.offset != finish.offset) return stock.offset - finish.offset;
  return (stock.shift - finish.shift).norm();
}

std::vector<ContourAllowance> contourLayers(const ContourAllowance& stock, const ContourAllowance& finish,
                                            double depth) {
  const double all = allowanceDepth(stock, finish);
  if (!(all > 0.0)) return {finish};
  const Vec2 way = stock.shift - finish.shift;
  const auto count = static_cast<int>(std::max(1.0, std::ceil(all / depth - 1e-9)));
  std::vector<ContourAllowance> layers;
  for (int k = 1; k <= count; ++k) {
    const double cut = std::min(k * depth, all);
    layers.push_back({std::max(stock.offset - k * depth, finish.offset), stock.shift - way * (cut / all)});
  }
  return layers;
}

}  // namespace proveout
