// The search for the nearest place of a solid on a curve. Only for the .cpp files of the sweep.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "core/base/assert.h"
#include "removal/sweep/sweep.h"

namespace proveout {

/// Every part of the way is either settled by a lower bound of its values or left on a stack of pieces, which
/// are halved until they are settled. On helices about z (CurveSearch::turns) most of the way is settled by
/// bounds of whole turns, and the rest by Newton's method.
struct Sweep::CurveSearch {
  struct End {
    double value = 0.0;
    Vec3 gradient = Vec3::Zero(), at = Vec3::Zero();
  };
  struct Piece {
    double a, b, low;
    bool known;  ///< its ends
    End ea, eb;
  };
  /// Places from which the slopes of the distance are known, on a span [a, b].
  struct Bracket {
    double a, b;
    double bend;  ///< the second derivative of the distance is nowhere below minus this
    Place low, high;
    bool low_known = false, high_known = false;
    double between = -std::numeric_limits<double>::infinity();  ///< least value between low and high

    bool both() const { return low_known && high_known; }
    double width() const { return high.t - low.t; }
    void add(const Place& place);
    double support();
  };
  /// The place of one turn that passes nearest to the point, and what holds around it.
  struct Turn {
    double middle;      ///< parameter; may lie outside of the way
    double radius;      ///< of the way there, mm
    double convex_rad;  ///< the distance is convex this far to both sides,
    double slack_bend;  ///< but for this much of its second derivative
    double slack_mm;    ///< the level distance is off that of a circle by no more
  };

  CurveSearch(const Sweep& s, const Vec3& point, double above, double within)
      : sweep(s), p(point), cutoff(above), tolerance(within), angle(std::abs(s.arc_.sweep_rad)) {}

  /// Bounds above the cutoff are what is asked for, so that they may not be the cutoff itself.
  double goal() const {
    return std::min(best - tolerance - kFarTolerance * std::abs(best), cutoff + tolerance);
  }
  At consider(double t) {
    const At at = sweep.evaluateCurve(p, t);
    if (at.value < best) {
      best = at.value;
      place = {t, at};
    }
    return at;
  }
  End end(double t);
  double chordBound(double a, const End& ea, double b, const End& eb) const;
  void leave(double a, double b, double low);
  void push(const Piece& first, const Piece& second);
  void spans();
  void divide();

  void newton(double a, double b, double start, double bend);
  void settle(const Bracket& bracket);
  void walk(Place from, double end, double bend);
  double levelGap() const;
  double heightBound(double gap, double a, double b, double& slope) const;
  double bendBound(const Turn& turn, double off_rad) const;
  Turn turnAt(double middle) const;
  void searchTurn(double middle, double start);
  void searchSide(const Turn& turn, int side);
  double firstTurn(double near, double last, double start);
  void turns(double start);

  /// Away from the surface the search may stop this much (relative) above the least value.
  static constexpr double kFarTolerance = 1e-4;
  /// Rounding of bounds that the value may meet exactly, mm.
  static constexpr double kBoundSlackMm = 1e-10;

  const Sweep& sweep;
  const Vec3 p;
  double cutoff, tolerance;
  double angle;                                           ///< of the whole way, radians
  double best = std::numeric_limits<double>::infinity();  ///< the value at `place`
  Place place{0.0, {}};
  double bound = std::numeric_limits<double>::infinity();
  double off_axis = 0.0;  ///< level distance of the point from the axis of the way, mm
  static constexpr int kMostPieces = 128;
  /// Made only as far as it is used: most searches need none of it.
  union Stack {
    Stack() {}
    ~Stack() {}
    std::array<Piece, kMostPieces> pieces;
  };
  Stack stack;
  int size = 0;
  void add(const Piece& piece) {
    PROVEOUT_ASSERT_DEAR(size < kMostPieces && piece.a <= piece.b);
    std::construct_at(&stack.pieces[static_cast<std::size_t>(size++)], piece);
  }
};

}  // namespace proveout
