// The exact crossings of one leaf's edges after its passes went through.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "removal/cut/leaf_cutter.h"

namespace proveout {

/// Material that the grid loses in a leaf.
struct LostFilm {
  static constexpr int kParts = 48;
  int edges = 0;              ///< grid edges that run through it
  int parts = 0;              ///< about its volume, in parts of a cell
  Vec3 where = Vec3::Zero();  ///< on the first of them, mm
};

/// Finds crossings; one object a thread, used again and again.
class CrossingFinder {
 public:
  CrossingFinder(const Stock::Impl& impl, const PassTable& table) : impl_(impl), table_(table) {}

  /// Crossings of the crossed `edges` of the changed leaf, in order. On each edge the one nearest to the
  /// material counts: of the surface that was there (`before`, the crossings of change.before), or of a pass
  /// in `list`.
  std::vector<Crossing> find(const LeafChange& change, const LeafEdges& edges,
                             const std::vector<Crossing>& before, std::span<const Reach> list);

  /// Material that the grid loses: edges whose old crossing is gone although no pass in `list` took the
  /// material next to it. What is left there is thinner than a cell, and counts as half of one.
  LostFilm findLost(const LeafChange& change, const LeafEdges& edges, const std::vector<Crossing>& before,
                    std::span<const Reach> list);

 private:
  void addBeyond(SampleReader& read, const Coord& start, int axis, bool material_first, const Vec3& p);
  bool isSolidBelow(SampleReader& read, const Vec3& p, const Vec3& normal, std::span<const Reach> list);
  std::vector<char> barePoints(const std::vector<Vec3>& points, std::span<const Reach> list);

  static constexpr std::uint32_t kOld = 0xFFFFFFFFu;
  struct Edge {
    Vec3 a;                     ///< material end
    std::uint8_t quarter;       ///< of the leaf, in which the edge starts
    std::int8_t axis, forward;  ///< forward: +1 where the material end is the start
    double s = 1.0;             ///< fraction of the edge from its material end
    std::uint32_t pass = kOld;
    std::int32_t old = -1;  ///< number in `before`
    int moved = 0;          ///< value of moves_ when its crossing moved last
    double start = -1.0;    ///< see EdgeCut
  };
  /// A point that is asked: is it in the sweep?
  enum class Probe : std::uint8_t { kEnd, kMiddle };

  void collect(const LeafChange& change, const LeafEdges& edges, const std::vector<Crossing>& before);
  void addProbes(int quarter);
  void placeProbe(std::size_t i);
  /// Probes of the edges that start in one quarter of the leaf.
  struct Group {
    std::size_t first = 0, last = 0;
  };
  /// A pass that may touch those of some quarters (bits), and heights between which, mm; of pieces that are
  /// asked as one the first.
  struct Near {
    std::uint32_t pass;
    unsigned quarters;
    std::array<double, 4> low, high;
  };
  Group addGroup(const LeafChange& change, int quarter, FourBlocks& boxes);
  void listPasses(std::span<const Reach> list, const FourBlocks& boxes);
  void cutEdges();
  void tryPass(const Near& near, int since);
  void tryBatch(std::uint32_t number);
  void tryEdge(std::uint32_t number, std::size_t probe, double lo, double hi);
  void addTogether(std::size_t probe, double lo, double hi);
  struct TogetherCuts;
  void cutTogether(std::uint32_t number, TogetherCuts& together);
  void tryWhole(const Near& near, int since);
  void giveUntaken();
  void moveCrossing(std::uint32_t number, std::uint32_t edge, const EdgeCut& cut);
  void dropCovered(const Pass& pass);
  template <typename Covers>
  void dropBatch(std::size_t first, std::size_t count, std::size_t& kept, Covers&& covers);
  Crossing crossing(const Edge& edge, const std::vector<Crossing>& before) const;

  const Stock::Impl& impl_;
  const PassTable& table_;
  std::vector<Edge> edges_;
  struct ProbeOf {
    std::uint32_t edge;
    Probe kind;
  };
  std::vector<ProbeOf> probes_;
  std::vector<std::array<std::int32_t, 2>> probes_of_edge_;
  std::vector<double> x_, y_, z_;
  std::array<double, kMaxColumns> ask_x_{}, ask_y_{};  ///< of probes that are asked together
  std::array<std::size_t, kMaxColumns> ask_{};         ///< their numbers
  std::size_t ask_count_ = 0;
  /// Edges that a body cuts together.
  struct TogetherCuts {
    EdgeCuts cuts;
    std::array<std::uint32_t, kMaxColumns> edge;  ///< their numbers
    std::array<double, kMaxColumns> at;           ///< of vertical ones: as EdgeCut::at
  };
  TogetherCuts level_cuts_{}, upright_cuts_{};
  std::vector<std::uint32_t> tag_;  ///< of points that are asked who covers them: their numbers
  std::vector<Vec3> beyond_;        ///< places beside lost edges
  std::array<double, kMaxColumns> lo_, hi_;
  std::array<Group, 4> groups_;
  std::vector<Near> passes_;
  ReachList united_;        ///< see unitePieces
  bool moved_ = false;      ///< a crossing was taken over
  int moves_ = 0;           ///< how many were, of the edges in hand
  std::vector<int> asked_;  ///< of each pass in hand: value of moves_ when it was asked last
};

}  // namespace proveout
