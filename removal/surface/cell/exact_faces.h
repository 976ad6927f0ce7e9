// Where the faces of a surface lie exactly: on the swept volumes that cut them, or on the blank.
#pragma once

#include <array>
#include <cstdint>

#include "removal/cut/cut_record.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// Answers for one cell at a time.
class ExactFaces {
 public:
  /// For the cells of the leaf at `origin`. Not active where it is not known what cut the stock.
  ExactFaces(const Stock::Impl& impl, const Coord& origin)
      : impl_(impl),
        origin_(origin),
        record_(impl.cut.get()),
        blank_(impl.field.get()),
        cut_(impl.cut_field.get()),
        h_(impl.h) {}
  /// The state before the last path: for cells whose crossings are all older, so that they are read the same
  /// before and after it. Gives the faces of a blank where these are known, no others.
  static ExactFaces beforeCut(const Stock::Impl& impl, const Coord& origin) {
    ExactFaces out(impl, origin);
    if (out.blank_ == nullptr) out.blank_ = out.cut_;
    out.record_ = nullptr;
    out.cut_ = nullptr;
    return out;
  }

  bool active() const { return record_ != nullptr || blank_ != nullptr; }
  /// The cell's lowest corner, mm.
  void setCell(const Vec3& corner) { corner_ = corner; }

  /// What made a face.
  struct Source {
    std::int64_t
        body;  ///< number of the swept body, equal for faces of one body; kNoBody where no pass made it
    /// The face is part of a plane, a sphere or a round cylinder, which several crossings and their normals
    /// determine exactly. True for faces that no pass made.
    bool simple;
    double bend = 0.0;  ///< largest curvature of a simple face, by cell; 0 where it is not known
    /// A pass made the face with a straight piece of its tool's profile: it is trimmed at rims. Round pieces
    /// blend into others.
    bool ends_at_rims = false;
    bool cone = false;  ///< that piece is slanted

    /// Curvature, per cell: with so much (a radius of 17 cells) a surface is 0.0075 cells off the plane of
    /// its crossings half a cell beside them.
    static constexpr double kMostBend = 0.06;
    bool isShown() const { return simple && bend < kMostBend; }
  };
  static constexpr std::int64_t kNoBody = -1;  ///< below it: faces of a blank whose faces are known
  /// `face`: Crossing::face().
  Source source(std::uint64_t face);

  /// Depth in the material from which bodies are probed for a crossing or a vertex, in units of the cell:
  /// more than the point may be off the bodies that it is on.
  static constexpr double kProbeDepth = 0.25;
  /// Foot point: the point of a body nearest to a probe.
  struct Foot {
    Vec3 p;       ///< in units of the cell
    Vec3 normal;  ///< unit, out of the material (into the body)
    int element;  ///< as SweptField::sampleOutside says
  };
  /// The foot point of `q` (in units of the cell) on the body. Exact where `q` lies outside the body, as it
  /// should.
  Foot foot(std::int64_t body, const Vec3& q);
  /// Whether a pass made the body with a tool that has a round element, so that its faces may blend into
  /// each other.
  bool isRounded(std::int64_t body) const;
  /// Whether `q` is farther than `by` (above 0) from a body that a pass made, both in units of the cell; to a
  /// twentieth of that.
  bool isFarther(std::int64_t body, const Vec3& q, double by);
  /// The distance itself, to a thousandth of a cell; any value above `most` where it is more than that.
  double distanceTo(std::int64_t body, const Vec3& q, double most);
  /// Whether the surface is the blank's own.
  bool ofBlank() const { return blank_ != nullptr; }
  /// Signed value of the blank at `q` (in units of the cell), below 0 in the material. Requires ofBlank.
  double blankValue(const Vec3& q) const;
  /// Whether a body other than this one reaches `q` (in units of the cell).
  bool isReachedByOthers(std::int64_t body, const Vec3& q);
  /// Whether `q` lies inside a body, at least `depth` deep (both in units of the cell).
  bool isCovered(const Vec3& q, double depth);
  /// Whether `q`, which should be on the blank, is farther than `by` off it (both in units of the cell).
  /// False where that is not known.
  bool isOffCutBlank(const Vec3& q, double by) const;
  /// Whether a foot point on the body that made `face` can belong to that face: it is on the same element of
  /// the tool, or on its rim where the rim made the face. Round elements are not distinguished from their
  /// ends.
  bool isOnFace(const Foot& foot, std::uint64_t face) const;
  /// Whether it belongs to a neighbouring element of the tool that continues the face's element with a
  /// common tangent.
  bool isOnTangentNeighbour(const Foot& foot, std::uint64_t face) const;
  /// Whether passes of one tool made both faces with the same straight slanted element of its profile:
  /// cones, and walls that cones swept.
  bool areOfOneCone(std::uint64_t face, std::uint64_t other) const;
  /// The same of an upright element: cylinders and walls that they swept.
  bool areOfOneCylinder(std::uint64_t face, std::uint64_t other) const;
  /// The same where the tool leans: the grid's lines meet such a wall in no regular way, so that pieces of it
  /// one below the other seem to face apart.
  bool areOfLeaningCylinder(std::uint64_t face, std::uint64_t other) const;
  /// As SweptBody::directionAt; `q` in units of the cell. Requires a body that a pass made.
  Vec3 directionAt(std::int64_t body, const Vec3& q) const;
  /// Which part of a sweep made a face with this normal (out of the material) at `q` (in units of the cell):
  /// 0 the tool in passing, 1 the round where the motion began, -1 the one where it ended. 0 where that is
  /// not known.
  int sweepEndAt(std::int64_t body, const Vec3& q, const Vec3& normal) const;
  /// Whether both faces are of one motion and of neighbouring elements of a tool that meet with a common
  /// tangent, so that the seam between them is smooth.
  bool areTangentNeighbours(std::uint64_t face, std::uint64_t other) const;

 private:
  const Pass* passOf(std::uint64_t face) const;
  const ConvexProfile::Element* straightElementOf(std::uint64_t face, std::uint64_t other) const;
  Foot footOnField(std::uint64_t face, const Vec3& q) const;
  Source findSource(std::uint64_t face) const;

  static constexpr std::size_t kKept = 8;
  struct Body {
    std::int64_t number = kNoBody;
    SweptField field;
    double start = SweptField::kAnywhere;  ///< of the search for a nearest point: where the last one was
  };
  Body& bodyOf(std::int64_t number);

  const Stock::Impl& impl_;
  Coord origin_;  ///< voxel of the leaf's first sample
  const CutRecord* record_;
  const BlankField* blank_;  ///< each of its faces is a body of its own
  const BlankField* cut_;    ///< the same, of a blank that passes have cut
  double h_;
  Vec3 corner_ = Vec3::Zero();
  struct KnownFace {
    std::uint64_t face = ~0ull;  ///< no face has this number
    Source source{kNoBody, true};
  };
  std::array<KnownFace, 16> known_;  ///< the last that were asked for
  std::vector<Body> kept_;           ///< the last that were asked for
  std::size_t oldest_ = 0;
};

}  // namespace proveout
