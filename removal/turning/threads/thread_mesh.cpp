#include "removal/turning/threads/thread_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/geometry/to_float.h"
#include "core/mesh/intersections.h"
#include "core/tool/convex_outline.h"
#include "removal/turning/threads/slice_faces.h"
#include "removal/turning/threads/slice_match.h"
#include "removal/turning/threads/slice_strips.h"
#include "removal/turning/threads/thread_slices.h"

namespace proveout {

namespace {

using namespace thread_detail;

/// Half sections all round: at least; at most, before those at the ends of grooves; and at most in all.
constexpr int kFewest = 24, kMost = 4096;
constexpr std::size_t kMostSlices = 16384;
/// Sections are this far apart at least, rad: below, what appears between them does so at once, and is
/// measured by its thickness.
constexpr double kLeastStep = 5e-4;
/// What still appears at once may be this large, in tolerances.
constexpr double kMostJump = 5.0;
constexpr double kFullTurn = 2.0 * kPi;

/// A half section at its angle, in front of or behind some of the ends of passes there.
struct Node {
  double phi;
  std::span<const PassEnd> ends;
  std::size_t passed = 0;
  Slice slice;
  /// How far the section behind it is off this one, mm; below 0: they do not go over into each other. Nothing
  /// where that has not been looked at.
  std::optional<double> off;
  bool between = false;  ///< made for what the sections beside it do not tell
  /// Its corners and those of the section behind it, if that has been looked at and they have stayed.
  std::optional<std::vector<LoopMatch>> matches = {};
  std::vector<Node> middle = {};  ///< the section half way to that one, if it was made
};

/// All half sections round the part, so close together that each goes over into the next.
class SliceRing {
 public:
  SliceRing(const ThreadSlicer& slicer, double tolerance, const Progress& progress)
      : slicer_(slicer), tolerance_(tolerance), progress_(progress) {}

  /// False: the sections do not go over into each other, or the work was cancelled.
  bool make(int steps) {
    sample(steps);
    while (!progress_.cancelled()) {
      std::vector<Node> between = unclear();
      if (failed_ || nodes_.size() + between.size() > kMostSlices) return false;
      if (between.empty()) return !progress_.cancelled();
      nodes_.insert(nodes_.end(), std::make_move_iterator(between.begin()),
                    std::make_move_iterator(between.end()));
      std::stable_sort(nodes_.begin(), nodes_.end(),
                       [](const Node& a, const Node& b) { return a.phi < b.phi; });
    }
    return false;
  }

  std::vector<Node>& nodes() { return nodes_; }
  double deviation() const { return deviation_; }
  /// What the threads take, mm3: the mean over the angle.
  double taken() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      sum += step(k) * 0.5 * (nodes_[k].slice.taken_mm3 + after(k).slice.taken_mm3);
    return sum / kFullTurn;
  }
  double step(std::size_t k) const {
    return k + 1 < nodes_.size() ? nodes_[k + 1].phi - nodes_[k].phi
                                 : kFullTurn - nodes_[k].phi + nodes_.front().phi;
  }
  const Node& after(std::size_t k) const { return nodes_[(k + 1) % nodes_.size()]; }
  std::int32_t turnsTo(std::size_t k) const { return k + 1 < nodes_.size() ? 0 : 1; }

  void sample(int steps) {
    const std::vector<PassEnd>& ends = slicer_.ends();
    for (std::size_t first = 0; first < ends.size();) {
      std::size_t last = first;
      while (last < ends.size() && ends[last].phi == ends[first].phi) ++last;
      const std::span<const PassEnd> here(ends.data() + first, last - first);
      for (std::size_t passed = 0; passed <= here.size(); ++passed)
        nodes_.push_back({ends[first].phi, here, passed, {}, {}});
      first = last;
    }
    // Even steps, but for those that an end is near to.
    const double step = kFullTurn / steps;
    const std::size_t special = nodes_.size();
    for (int j = 0; j < steps; ++j) {
      const double phi = j * step;
      const auto near = [&](const Node& node) {
        return std::abs(std::remainder(node.phi - phi, kFullTurn)) < 0.25 * step;
      };
      if (std::none_of(nodes_.begin(), nodes_.begin() + static_cast<std::ptrdiff_t>(special), near))
        nodes_.push_back({phi, {}, 0, {}, {}});
    }
    std::stable_sort(nodes_.begin(), nodes_.end(),
                     [](const Node& a, const Node& b) { return a.phi < b.phi; });
    fill(nodes_);
  }

 private:
  void fill(std::vector<Node>& nodes) {
    parallelFor(std::size_t{0}, nodes.size(), [&](std::size_t k) {
      if (!progress_.cancelled())
        nodes[k].slice = slicer_.slice(nodes[k].phi, nodes[k].ends, nodes[k].passed);
    });
  }

  /// Looks at the surface between a section and the next one.
  void look(std::size_t k) {
    Node& node = nodes_[k];
    node.off = 0.0;
    if (step(k) <= 0.0) return;
    const Slice &a = node.slice, &b = after(k).slice;
    node.matches = matchSlices(a, b, turnsTo(k));
    const auto& matches = node.matches;
    if (!matches) node.off = -1.0;
    const bool last = step(k) < 2.0 * kLeastStep;
    double thick = 0.0;
    for (std::size_t l = 0; matches && l < matches->size(); ++l) {
      const LoopMatch& match = (*matches)[l];
      const CornerLoop &la = a.loops[match.a], &lb = b.loops[match.b];
      node.off = std::max(*node.off, mismatch(la, lb, match));
      if (last) thick = std::max(thick, thickness(la, lb, match));
    }
    if (last && matches) node.off = std::min(*node.off, thick);
    if (last || (*node.off >= 0.0 && *node.off <= tolerance_)) return;
    // Corners that appear and vanish mostly do so within the surface: the section half way tells.
    const double phi = node.phi + 0.5 * step(k);
    const bool over = phi >= kFullTurn;
    node.middle.push_back({over ? phi - kFullTurn : phi, {}, 0, {}, {}, true});
    node.middle.front().slice = slicer_.slice(node.middle.front().phi);
    if (matches)
      node.off = std::min(*node.off, offMiddle(a, b, *matches, node.middle.front().slice, over ? 1 : 0));
  }

  /// Sections half way between those that differ by more than the tolerance.
  std::vector<Node> unclear() {
    parallelFor(std::size_t{0}, nodes_.size(), [&](std::size_t k) {
      if (!nodes_[k].off && !progress_.cancelled()) look(k);
    });
    std::vector<Node> between;
    deviation_ = 0.0;
    for (const Node& node : nodes_) deviation_ = std::max(deviation_, node.slice.left_out_mm);
    for (std::size_t k = 0; k < nodes_.size() && !progress_.cancelled(); ++k) {
      const double off = *nodes_[k].off;
      std::vector<Node> middle = std::move(nodes_[k].middle);
      nodes_[k].middle.clear();
      if (off >= 0.0 && off <= tolerance_) continue;
      if (step(k) < 2.0 * kLeastStep) {
        failed_ = failed_ || off < 0.0;
        deviation_ = std::max(deviation_, off);
        continue;
      }
      nodes_[k].off.reset();
      nodes_[k].matches.reset();
      between.push_back(std::move(middle.front()));
    }
    return between;
  }

  const ThreadSlicer& slicer_;
  double tolerance_;
  const Progress& progress_;
  std::vector<Node> nodes_;
  double deviation_ = 0.0;
  bool failed_ = false;
};

/// Joins half sections to a surface.
class Stitcher {
 public:
  Stitcher(const ThreadSlicer& slicer, SliceRing& ring) : slicer_(slicer), ring_(ring) {}

  /// False: two sections at one angle cross.
  bool run() {
    conform();
    std::vector<Node>& nodes = ring_.nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const bool same = k > 0 && nodes[k - 1].phi == nodes[k].phi;
      number(nodes[k], same ? &nodes[k - 1] : nullptr);
    }
    const auto own = [](const Node& node) { return !node.between; };
    const auto first =
        static_cast<std::size_t>(std::find_if(nodes.begin(), nodes.end(), own) - nodes.begin());
    for (std::size_t k = first; k < first + nodes.size();) {
      std::size_t last = k + 1;
      while (nodes[last % nodes.size()].between) ++last;
      if (!(ring_.step(k % nodes.size()) > 0.0 ? bands(k, last) : face(k % nodes.size()))) return false;
      k = last;
    }
    dropUnused();
    return true;
  }

  TriMesh mesh;

 private:
  /// Sections at one angle get each other's corners on their edges.
  void conform() {
    std::vector<Node>& nodes = ring_.nodes();
    for (bool again = true; again;) {
      again = false;
      for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        if (nodes[k].phi != nodes[k + 1].phi) continue;
        const bool own = splitEdges(nodes[k].slice, nodes[k + 1].slice),
                   other = splitEdges(nodes[k + 1].slice, nodes[k].slice);
        again |= own || other;
        nodes[(k + nodes.size() - 1) % nodes.size()].matches.reset();
        nodes[k + 1].matches.reset();
      }
    }
  }

  void number(Node& node, const Node* same) {
    std::vector<std::pair<double, const Corner*>> known;  // by height
    if (same != nullptr) {
      for (const CornerLoop& loop : same->slice.loops) {
        for (const Corner& corner : loop) known.emplace_back(corner.at.y(), &corner);
      }
      std::sort(known.begin(), known.end());
    }
    const double c = std::cos(node.phi), s = std::sin(node.phi);
    for (CornerLoop& loop : node.slice.loops) {
      for (Corner& corner : loop) corner.vertex = vertexAt(corner.at, c, s, known);
    }
  }

  std::uint32_t vertexAt(const Vec2& p, double c, double s,
                         const std::vector<std::pair<double, const Corner*>>& known) {
    const auto next = static_cast<std::uint32_t>(mesh.positions.size());
    if (p.x() <= 0.0) {
      const auto [it, is_new] = on_axis_.try_emplace(std::llround(p.y() / kOnePointMm), next);
      if (!is_new) return it->second;
    } else {
      auto it = std::lower_bound(known.begin(), known.end(), p.y() - kOnePointMm,
                                 [](const auto& corner, double z) { return corner.first < z; });
      for (; it != known.end() && it->first <= p.y() + kOnePointMm; ++it) {
        if (std::abs(it->second->at.x() - p.x()) <= kOnePointMm) return it->second->vertex;
      }
    }
    mesh.positions.emplace_back(toFloat(p.x() * c), toFloat(p.x() * s), toFloat(p.y()));
    return next;
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, MotionId motion) {
    if (a == b || b == c || c == a) return;  // at the axis
    mesh.triangles.push_back({a, b, c});
    mesh.motion.push_back(motion);
  }

  /// Between two sections and those that were put in between.
  bool bands(std::size_t first, std::size_t last) {
    const std::size_t n = ring_.nodes().size();
    std::vector<const Slice*> slices{&ring_.nodes()[first % n].slice};
    std::vector<std::vector<LoopMatch>> matches;
    for (std::size_t k = first; k < last; ++k) {
      slices.push_back(&ring_.after(k % n).slice);
      auto match = std::move(ring_.nodes()[k % n].matches);
      if (!match) match = matchSlices(*slices[k - first], *slices.back(), ring_.turnsTo(k % n));
      if (!match) return false;
      matches.push_back(std::move(*match));
    }
    const SliceStrips through(slices, matches);
    for (std::size_t k = 0; k < matches.size(); ++k) band(*slices[k], *slices[k + 1], matches[k], through, k);
    for (const Strip& strip : through.strips()) {
      const MotionId motion = slicer_.motionOf(strip.name);
      zip(
          strip, [&](auto... corners) { return shorter(corners...); },
          [&](auto... corners) { add(corners..., motion); });
    }
    return true;
  }

  /// What is no part of strips between a section and the next one.
  void band(const Slice& a, const Slice& b, const std::vector<LoopMatch>& matches, const SliceStrips& through,
            std::size_t k) {
    for (const LoopMatch& match : matches) {
      const CornerLoop &la = a.loops[match.a], &lb = b.loops[match.b];
      for (std::size_t m = 0; m < match.corners.size(); ++m) {
        const auto &from = match.corners[m], &to = match.corners[(m + 1) % match.corners.size()];
        if (!through.covers(k, match.a, from.first))
          stretch(la, from.first, to.first, lb, from.second, to.second);
      }
    }
  }

  void stretch(const CornerLoop& la, std::size_t a0, std::size_t a1, const CornerLoop& lb, std::size_t b0,
               std::size_t b1) {
    const Stretch a(la, a0, a1), b(lb, b0, b1);
    const auto of_a = [&](std::size_t i) { return a.corners[i]->vertex; };
    const auto of_b = [&](std::size_t j) { return b.corners[j]->vertex; };
    // Of one edge on either side the shorter diagonal is taken.
    zigzag(
        a, b,
        [&](std::size_t i, std::size_t j) { return shorter(of_a(i), of_b(j + 1), of_a(i + 1), of_b(j)); },
        [&](std::size_t i, std::size_t j, bool forth) {
          if (forth)
            add(of_a(i), of_b(j), of_b(j + 1), slicer_.motionOf(b.corners[j]->out));
          else
            add(of_a(i), of_b(j), of_a(i + 1), slicer_.motionOf(a.corners[i]->out));
        });
  }

  /// Whether the line a-b is no longer than c-d, within a thousandth.
  bool shorter(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    return (mesh.positions[a] - mesh.positions[b]).squaredNorm() <=
           1.002f * (mesh.positions[c] - mesh.positions[d]).squaredNorm();
  }

  bool face(std::size_t k) {
    const Node &a = ring_.nodes()[k], &b = ring_.after(k);
    const auto triangles = facesBetween(a.slice, b.slice);
    if (!triangles) return false;
    PROVEOUT_ASSERT(a.passed < a.ends.size());
    const PassEnd& end = a.ends[a.passed];
    for (const auto& t : *triangles) add(t[0], t[1], t[2], slicer_.motionOf({end.sweep, end.turn, 0}));
    return true;
  }

  /// Corners of sections that no triangle has.
  void dropUnused() {
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> number(mesh.positions.size(), kNone);
    for (const auto& t : mesh.triangles) {
      for (const std::uint32_t v : t) number[v] = 0;
    }
    std::uint32_t kept = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == kNone) continue;
      mesh.positions[kept] = mesh.positions[v];
      number[v] = kept++;
    }
    mesh.positions.resize(kept);
    for (auto& t : mesh.triangles) {
      for (std::uint32_t& v : t) v = number[v];
    }
  }

  const ThreadSlicer& slicer_;
  SliceRing& ring_;
  std::map<long long, std::uint32_t> on_axis_;
};

double sectionVolume(const SectionBody& body) {
  double volume = 0.0;
  for (const SectionLoop& loop : body.loops) volume += revolvedVolume(loop.points);
  return volume;
}

double largestRadius(const SectionBody& body) {
  double radius = 0.0;
  for (const Vec2& p : body.loops.front().points) radius = std::max(radius, p.x());
  return radius;
}

/// Half sections for a volume alone.
constexpr int kVolumeSteps = 128;

int stepsFor(const SectionBody& body, double tolerance) {
  return std::clamp(circleSteps(largestRadius(body), tolerance), kFewest, kMost);
}

}  // namespace

std::optional<ThreadedSurface> threadedSurface(const SectionBody& body,
                                               const std::vector<ThreadSweep>& threads, double tolerance,
                                               const Progress& progress) {
  const ThreadSlicer slicer(body, threads, tolerance, kMostJump * tolerance);
  SliceRing ring(slicer, tolerance, progress);
  if (!ring.make(stepsFor(body, tolerance)) || ring.deviation() > kMostJump * tolerance) return std::nullopt;
  ThreadedSurface surface;
  surface.volume_mm3 = sectionVolume(body) - ring.taken();
  surface.deviation_mm = std::max(2.0 * tolerance, ring.deviation());

  Stitcher stitcher(slicer, ring);
  if (!stitcher.run()) return std::nullopt;
  surface.mesh = std::move(stitcher.mesh);
  const std::vector<std::uint8_t> all(surface.mesh.positions.size(), 1);
  if (!findIntersections(surface.mesh, all).empty()) return std::nullopt;
  return surface;
}

double threadedVolume(const SectionBody& body, const std::vector<ThreadSweep>& threads) {
  const ThreadSlicer slicer(body, threads, kSectionChordMm, 0.0);
  const Progress progress;
  SliceRing ring(slicer, kSectionChordMm, progress);
  ring.sample(kVolumeSteps);
  return sectionVolume(body) - ring.taken();
}

}  // namespace proveout
