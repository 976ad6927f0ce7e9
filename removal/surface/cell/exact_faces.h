// Where the faces of a surface are exactly: the swept volumes that cut them, or the blank.
#pragma once

#include <array>
#include <cstdint>

#include "removal/cut/cut_record.h"
#include "removal/grid/stock_impl.h"

namespace proveout {

/// Answers for one cell at a time.
class ExactFaces {
 public:
  /// For the cells of the leaf at `origin`. Knows nothing where it is not known what cut the stock.
  ExactFaces(const Stock::Impl& impl, const Coord& origin)
      : impl_(impl),
        origin_(origin),
        record_(impl.cut.get()),
        blank_(impl.field.get()),
        cut_(impl.cut_field.get()),
        h_(impl.h) {}
  /// As it was before the last path: for cells of which all crossings are older, so that these are read alike
  /// before and after it. Knows the faces of a blank that are known, no others.
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
    /// show exactly. True for faces that no pass made.
    bool simple;
    double bend = 0.0;  ///< largest curvature of a simple face, by cell; 0 where it is not known
    /// A pass made it with a straight piece of its tool's profile: it ends at rims. Round pieces go over into
    /// others.
    bool ends = false;
    bool cone = false;  ///< that piece is slanted

    /// Half a cell off its crossings a surface leaves their plane by 0.0075 cells where it bends as much, by
    /// cell (a radius of 17 cells).
    static constexpr double kMostBend = 0.06;
    bool isShown() const { return simple && bend < kMostBend; }
  };
  static constexpr std::int64_t kNoBody = -1;  ///< below it: faces of a blank whose faces are known
  /// `face`: Crossing::face().
  Source source(std::uint64_t face);

  /// How far into the material a crossing or a vertex is looked at from, in units of the cell: farther than
  /// it is off the bodies that it is on.
  static constexpr double kLookFrom = 0.25;
  /// Point of the surface of a body.
  struct Foot {
    Vec3 p;       ///< in units of the cell
    Vec3 normal;  ///< unit, out of the material (into the body)
    int element;  ///< as SweptField::sampleOutside says
  };
  /// The point of the body nearest to `q` (in units of the cell), which should lie outside of the body: exact
  /// there.
  Foot foot(std::int64_t body, const Vec3& q);
  /// Whether a pass made it with a tool that is round somewhere, so that its faces may go over into each
  /// other.
  bool isRounded(std::int64_t body) const;
  /// Distance of `q` from a body that a pass made, both in units of the cell; not above 1.
  double distanceTo(std::int64_t body, const Vec3& q);
  /// The surface is the blank's own.
  bool ofBlank() const { return blank_ != nullptr; }
  /// Signed value of the blank at `q` (in units of the cell), below 0 in the material. Requires ofBlank.
  double blankValue(const Vec3& q) const;
  /// Whether a body other than this reaches to `q`.
  bool isReachedByOthers(std::int64_t body, const Vec3& q);
  /// Whether a body holds `q`, this deep (in units of the cell).
  bool isCovered(const Vec3& q, double depth);
  /// Whether a place that should be on the blank is farther off it than this (in units of the cell). False
  /// where that is not known.
  bool isOffCutBlank(const Vec3& q, double by) const;
  /// Whether a point of the body that made `face` can be of that face: the same element of the tool, and its
  /// rim where that made the face. Round elements are not told apart from their ends.
  bool isOf(const Foot& foot, std::uint64_t face) const;
  /// Whether it is of an element that the face's goes over into without a break.
  bool isBeside(const Foot& foot, std::uint64_t face) const;
  /// Whether passes of one tool made both with one straight slanted element of its profile: cones, and walls
  /// that they swept.
  bool areOfOneCone(std::uint64_t face, std::uint64_t other) const;
  /// The same of an upright element: cylinders and their walls.
  bool areOfOneCylinder(std::uint64_t face, std::uint64_t other) const;
  /// As SweptBody::directionAt; `q` in units of the cell. Requires a body that a pass made.
  Vec3 directionAt(std::int64_t body, const Vec3& q) const;
  /// What of its way the tool left at `q` (in units of the cell) of a face with this normal (out of the
  /// material) there: 0 where it passed by, 1 where it began, -1 where it ended. 0 where that is not known.
  int endAt(std::int64_t body, const Vec3& q, const Vec3& normal) const;
  /// Whether both are of one motion and of elements of a tool that go over into each other without a break.
  bool goOver(std::uint64_t face, std::uint64_t other) const;

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
