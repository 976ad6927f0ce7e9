#include "removal/cut/body_index.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"

namespace proveout {
namespace {

constexpr std::uint32_t kLeafBodies = 8;
/// Fewer are worked on by one thread.
constexpr std::uint32_t kAlone = 4096;

/// Nodes of the trees over `count` bodies and over one more.
std::array<std::uint32_t, 2> nodesOver(std::uint32_t count) {
  if (count < kLeafBodies) return {1, 1};
  const auto [half, more] = nodesOver(count / 2);
  const std::uint32_t uneven = 1 + half + more;
  if (count % 2 == 1) return {uneven, 1 + 2 * more};
  return {count == kLeafBodies ? 1 : 1 + 2 * half, uneven};
}

double distanceTo(const Box3& box, const Vec3& p) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(Vec3::Zero()).norm();
}

/// Whether what is in the box may be nearer to `p` than `within`; below 0: hold it deeper than that.
bool mayComeTo(const Box3& box, const Vec3& p, double within) {
  const Vec3 out = (box.min - p).cwiseMax(p - box.max);
  const double most = out.maxCoeff();
  if (most >= within) return false;
  return most < 0.0 || out.cwiseMax(Vec3::Zero()).squaredNorm() < within * within;
}

}  // namespace

SweptField SweptCutter::field(const PassTable& table) const { return table.passes[pass].body.field(); }

double SweptCutter::distance(const PassTable& table, const Vec3& p, double cutoff) const {
  return table.passes[pass].body.distance(p, cutoff);
}

CutterIndex::SmallBox::SmallBox(const Box3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = box.min[static_cast<int>(k)], high = box.max[static_cast<int>(k)];
    min[k] = std::nextafter(toFloat(low), -std::numeric_limits<float>::infinity());
    max[k] = std::nextafter(toFloat(high), std::numeric_limits<float>::infinity());
  }
}

Box3 CutterIndex::SmallBox::box() const {
  return {Vec3(double{min[0]}, double{min[1]}, double{min[2]}),
          Vec3(double{max[0]}, double{max[1]}, double{max[2]})};
}

CutterIndex::CutterIndex(const PassTable& table, MotionId end) : table_(table) {
  for (std::uint32_t i = 0; i < table.passes.size() && table.passes[i].motion < end; ++i) {
    const Pass& pass = table.passes[i];
    if (!pass.cuts()) continue;
    if (table.goesOn(i)) continue;  // another chord
    bodies_.push_back({pass.motion, i});
  }
  // Whoever waits here must not take up work that asks for this index.
  if (!bodies_.empty()) tbb::this_task_arena::isolate([&] { buildAll(); });
}

void CutterIndex::buildAll() {
  Room room{std::vector<Box3>(bodies_.size()), std::vector<Box3>(bodies_.size()),
            std::vector<std::uint32_t>(bodies_.size()), std::vector<SweptCutter>(bodies_.size())};
  parallelFor(std::size_t{0}, bodies_.size(),
              [&](std::size_t i) { room.boxes[i] = bodies_[i].field(table_).bounds(); });
  const auto count = static_cast<std::uint32_t>(bodies_.size());
  nodes_.resize(nodesOver(count)[0]);
  build(room, 0, 0, count);
  boxes_.reserve(count);
  for (const Box3& box : room.boxes) boxes_.emplace_back(box);
}

/// Gives the node over the bodies begin..end-1 its number and makes those below it.
void CutterIndex::build(Room& room, std::uint32_t number, std::uint32_t begin, std::uint32_t end) {
  PROVEOUT_ASSERT(begin < end);
  Node node;
  node.begin = begin;
  node.end = end;
  Box3 centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    node.box.extend(room.boxes[i]);
    centers.extend(room.boxes[i].center());
    node.first_motion = std::min(node.first_motion, bodies_[i].motion);
  }
  if (end - begin > kLeafBodies) {
    int axis = 0;
    centers.size().maxCoeff(&axis);
    halve(room, axis, begin, end);
    const std::uint32_t half = begin + (end - begin) / 2, left = number + 1;
    node.right = left + nodesOver(half - begin)[0];
    const auto child = [&](int side) {
      side == 0 ? build(room, left, begin, half) : build(room, node.right, half, end);
    };
    if (end - begin > kAlone) {
      parallelFor(0, 2, child);
    } else {
      child(0);
      child(1);
    }
  }
  nodes_[number] = node;
}

/// Puts the half of the bodies that is lower on the axis first.
void CutterIndex::halve(Room& room, int axis, std::uint32_t begin, std::uint32_t end) {
  const auto order = room.order.begin();
  std::iota(order + begin, order + end, begin);
  std::nth_element(order + begin, order + begin + (end - begin) / 2, order + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double ca = room.boxes[a].center()[axis], cb = room.boxes[b].center()[axis];
                     return ca != cb ? ca < cb : a < b;
                   });
  for (std::uint32_t i = begin; i < end; ++i) {
    room.sorted_bodies[i] = bodies_[order[i]];
    room.sorted[i] = room.boxes[order[i]];
  }
  std::copy(room.sorted_bodies.begin() + begin, room.sorted_bodies.begin() + end, bodies_.begin() + begin);
  std::copy(room.sorted.begin() + begin, room.sorted.begin() + end, room.boxes.begin() + begin);
}

CutterIndex::Near CutterIndex::nearest(const Vec3& p, MotionId end, double cutoff, const SweptCutter* hint,
                                       double enough) const {
  Near best{cutoff};
  if (nodes_.empty()) return best;
  const auto look = [&](const SweptCutter& body) {
    if (body.motion >= end) return;
    const double distance = body.distance(table_, p, best.distance);
    if (distance < best.distance) best = {distance, &body};
  };
  if (hint != nullptr) look(*hint);
  std::array<std::uint32_t, 64> stack;  // the tree halves: its depth is below 32
  int size = 0;
  stack[size++] = 0;
  while (size > 0 && best.distance >= enough) {
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
      if (&bodies_[i] != hint && distanceTo(boxes_[i].box(), p) < best.distance) look(bodies_[i]);
    }
  }
  return best;
}

template <typename Reaches, typename Visit>
bool CutterIndex::anyOf(const Reaches& reaches, const Visit& visit) const {
  if (nodes_.empty()) return false;
  std::array<std::uint32_t, 64> stack;
  int size = 0;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t number = stack[--size];
    const Node& node = nodes_[number];
    if (!reaches(node.box)) continue;
    if (node.right != 0) {
      stack[size++] = node.right;
      stack[size++] = number + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      if (reaches(boxes_[i].box()) && visit(bodies_[i])) return true;
    }
  }
  return false;
}

void CutterIndex::collect(const Vec3& p, double within, std::vector<SweptField>& out) const {
  anyOf([&](const auto& box) { return distanceTo(box, p) < within; },
        [&](const SweptCutter& body) {
          if (body.distance(table_, p, within) < within) out.push_back(body.field(table_));
          return false;
        });
}

bool CutterIndex::comesTo(const Vec3& p, double within, std::uint32_t except) const {
  return anyOf([&](const auto& box) { return mayComeTo(box, p, within); },
               [&](const SweptCutter& body) {
                 return body.pass != except && body.distance(table_, p, within) < within;
               });
}

}  // namespace proveout
