// Signed distance to the polygons of a turned section, and where lines meet them.
#pragma once

#include <vector>

#include "removal/turning/section/section.h"

namespace proveout {

/// The surfaces that the polygons of all bodies make when they turn about Z. Points are (r, z), r >= 0, mm.
/// Where edges of one motion meet at less than 0.1 rad they are one smooth curve: its normals turn steadily.
class SectionField {
 public:
  /// Requires loops of 3 points or more and a motion for each edge.
  explicit SectionField(const std::vector<SectionBody>& bodies);

  struct Edge {
    Vec2 from, to;
    Vec2 normal_from, normal_to;  ///< out of the material, unit
    MotionId motion = kNoMotion;
    int face = 0;  ///< number of the smooth curve
    bool on_axis = false;
    bool first = false, last = false;  ///< of its smooth curve

    Vec2 normalAt(const Vec2& p) const;
  };
  const Edge& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }

  bool empty() const { return edges_.empty(); }
  int faceCount() const { return faces_; }
  /// The edges of a smooth curve are straight and level or upright: a plane or a cylinder.
  bool isSimple(int face) const { return simple_[static_cast<std::size_t>(face)]; }
  Vec2 min() const { return min_; }  ///< of the bounds
  Vec2 max() const { return max_; }
  double volume() const { return volume_; }  ///< mm3

  /// Points nearer to the axis than this are asked about at this radius: on the axis itself material lies to
  /// one side of the polygons only, mm.
  static constexpr double kLeastRadius = 2e-6;
  /// Radii at which edges cross the level z, in no order: a point has material where the number of those
  /// below its r, at least kLeastRadius, is odd. Edges on the axis count, with r = 0.
  void radiiAt(double z, std::vector<double>& radii) const;
  bool inside(const Vec2& p) const;

  /// Calls body(edge, r) for each edge that crosses the level z.
  template <typename Body>
  void forEachAtLevel(double z, Body&& body) const;
  /// Calls body(edge, z) for each edge that crosses the radius r at a height between `low` and `high`.
  template <typename Body>
  void forEachAtRadius(double r, double low, double high, Body&& body) const;

  struct Nearest {
    double distance;  ///< >= 0
    int edge;         ///< -1: none as near as asked for
    Vec2 point;
  };
  /// The nearest point of edges off the axis; nothing farther than `most` is looked for. `face`: of that face
  /// alone, if not negative.
  Nearest nearest(const Vec2& p, double most, int face = -1) const;
  /// The point of a smooth curve that is nearest to `p`; beyond its ends it goes on straight.
  Nearest nearestOn(int face, const Vec2& p, double most) const;

 private:
  void addLoop(const SectionLoop& loop);
  void makeBins();
  int binOf(double z) const;

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> bin_start_, bin_edges_;  ///< edges by the heights that they reach over
  double bin_height_ = 1.0;
  int bins_ = 0, faces_ = 0;
  Vec2 min_ = Vec2::Zero(), max_ = Vec2::Zero();
  std::vector<bool> simple_;  ///< by face
  double volume_ = 0.0;
};

template <typename Body>
void SectionField::forEachAtLevel(double z, Body&& body) const {
  if (!(z >= min_.y() && z <= max_.y())) return;
  const auto bin = static_cast<std::size_t>(binOf(z));
  for (std::uint32_t i = bin_start_[bin]; i < bin_start_[bin + 1]; ++i) {
    const Edge& e = edges_[bin_edges_[i]];
    if ((e.from.y() > z) == (e.to.y() > z)) continue;
    const double share = (z - e.from.y()) / (e.to.y() - e.from.y());
    body(static_cast<int>(bin_edges_[i]), e.from.x() + share * (e.to.x() - e.from.x()));
  }
}

template <typename Body>
void SectionField::forEachAtRadius(double r, double low, double high, Body&& body) const {
  if (high < min_.y() || low > max_.y()) return;
  const int first = binOf(low), last = binOf(high);
  for (int bin = first; bin <= last; ++bin) {
    const auto b = static_cast<std::size_t>(bin);
    for (std::uint32_t i = bin_start_[b]; i < bin_start_[b + 1]; ++i) {
      const Edge& e = edges_[bin_edges_[i]];
      if ((e.from.x() > r) == (e.to.x() > r)) continue;
      const double share = (r - e.from.x()) / (e.to.x() - e.from.x());
      const double z = e.from.y() + share * (e.to.y() - e.from.y());
      if (z >= low && z <= high) body(static_cast<int>(bin_edges_[i]), z);
    }
  }
}

}  // namespace proveout
