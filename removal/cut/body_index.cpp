#include "removal/cut/body_index.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/assert.h"

namespace proveout {
namespace {

constexpr std::uint32_t kLeafBodies = 8;

double distanceTo(const Box3& box, const Vec3& p) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(Vec3::Zero()).norm();
}

/// Below 0 inside: what is in the box is no deeper.
double signedDistanceTo(const Box3& box, const Vec3& p) {
  const Vec3 out = (box.min - p).cwiseMax(p - box.max);
  return out.maxCoeff() < 0.0 ? out.maxCoeff() : out.cwiseMax(Vec3::Zero()).norm();
}

}  // namespace

Sweep SweptCutter::sweep(const PassTable& table) const { return table.passes[pass].body.wholeSweep(); }

CutterIndex::CutterIndex(const PassTable& table, MotionId end) : table_(table) {
  std::vector<Box3> boxes;
  for (std::uint32_t i = 0; i < table.passes.size() && table.passes[i].motion < end; ++i) {
    const Pass& pass = table.passes[i];
    if (!pass.cuts()) continue;
    if (table.goesOn(i)) continue;  // another chord
    bodies_.push_back({pass.motion, i});
    boxes.push_back(bodies_.back().sweep(table).bounds());
  }
  if (!bodies_.empty()) build(boxes, 0, static_cast<std::uint32_t>(bodies_.size()));
}

/// Number of the node over the bodies begin..end-1.
std::uint32_t CutterIndex::build(std::vector<Box3>& boxes, std::uint32_t begin, std::uint32_t end) {
  PROVEOUT_ASSERT(begin < end);
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Node node;
  node.begin = begin;
  node.end = end;
  Box3 centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    node.box.extend(boxes[i]);
    centers.extend(boxes[i].center());
    node.first_motion = std::min(node.first_motion, bodies_[i].motion);
  }
  if (end - begin > kLeafBodies) {
    int axis = 0;
    centers.size().maxCoeff(&axis);
    std::vector<std::uint32_t> order(end - begin);
    std::iota(order.begin(), order.end(), begin);
    const auto middle = order.begin() + (end - begin) / 2;
    std::nth_element(order.begin(), middle, order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double ca = boxes[a].center()[axis], cb = boxes[b].center()[axis];
      return ca != cb ? ca < cb : a < b;
    });
    std::vector<SweptCutter> bodies;
    std::vector<Box3> sorted;
    for (const std::uint32_t i : order) {
      bodies.push_back(bodies_[i]);
      sorted.push_back(boxes[i]);
    }
    std::copy(bodies.begin(), bodies.end(), bodies_.begin() + begin);
    std::copy(sorted.begin(), sorted.end(), boxes.begin() + begin);
    const std::uint32_t half = begin + (end - begin) / 2;
    build(boxes, begin, half);
    node.right = build(boxes, half, end);
  }
  nodes_[number] = node;
  return number;
}

CutterIndex::Near CutterIndex::nearest(const Vec3& p, MotionId end, double cutoff,
                                       const SweptCutter* hint) const {
  Near best{cutoff};
  if (nodes_.empty()) return best;
  const auto look = [&](const SweptCutter& body) {
    if (body.motion >= end) return;
    const double distance = body.sweep(table_).distance(p, best.distance);
    if (distance < best.distance) best = {distance, &body};
  };
  if (hint != nullptr) look(*hint);
  std::array<std::uint32_t, 64> stack;  // the tree halves: its depth is below 32
  int size = 0;
  stack[size++] = 0;
  while (size > 0 && best.distance >= 0.0) {
    const std::uint32_t number = stack[--size];
    const Node& node = nodes_[number];
    if (node.first_motion >= end || distanceTo(node.box, p) >= best.distance) continue;
    if (node.right != 0) {
      const std::uint32_t left = number + 1;
      const bool left_first = distanceTo(nodes_[left].box, p) <= distanceTo(nodes_[node.right].box, p);
      stack[size++] = left_first ? node.right : left;
      stack[size++] = left_first ? left : node.right;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (&bodies_[i] != hint) look(bodies_[i]);
    }
  }
  return best;
}

bool CutterIndex::comesTo(const Vec3& p, double within, std::uint32_t except) const {
  if (nodes_.empty()) return false;
  std::array<std::uint32_t, 64> stack;
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t number = stack[--size];
    const Node& node = nodes_[number];
    if (signedDistanceTo(node.box, p) >= within) continue;
    if (node.right != 0) {
      stack[size++] = node.right;
      stack[size++] = number + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (bodies_[i].pass != except && bodies_[i].sweep(table_).distance(p, within) < within) return true;
    }
  }
  return false;
}

}  // namespace proveout
