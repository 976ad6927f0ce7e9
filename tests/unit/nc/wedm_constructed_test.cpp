// Offsets and tapers of the wire EDM control against the constructed tests of the digest wedm, D14. The
// offset is on before the first element: a lead-in without it ends where the first element begins.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/nc/services/contour/contour_clearance.h"
#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/wire_offset.h"
#include "core/nc/services/wire_taper.h"
#include "wedm_path.h"

namespace proveout {
namespace {

using Points = std::vector<Vec2>;

constexpr double kDigitsOfDigest = 2.2e-6;

ContourElement arcTo(const Vec2& from, const Vec2& to, const Vec2& center, bool counter_clockwise) {
  ContourElement arc = lineElement(from, to);
  arc.arc = true;
  arc.center = center;
  const Vec2 a = from - center, b = to - center;
  double sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  if (counter_clockwise && sweep <= 1e-12) sweep += 2 * kPi;
  if (!counter_clockwise && sweep >= -1e-12) sweep -= 2 * kPi;
  arc.sweep = sweep;
  return arc;
}

std::vector<OffsetPiece> piecesOf(const PlaneContour& contour, double offset,
                                  OuterJoin outer = OuterJoin::kArc) {
  std::vector<OffsetPiece> pieces;
  for (const ContourElement& e : contour) {
    OffsetPiece piece;
    piece.element = e;
    piece.offset = offset;
    piece.outer = outer;
    pieces.push_back(piece);
  }
  return pieces;
}

/// Ends of all tracks, spikes and joins, in order.
Points endsOf(const OffsetContour& contour) {
  Points ends;
  for (const OffsetTrack& track : contour.tracks) {
    ends.push_back(track.track.to);
    for (const ContourElement& e : track.spike) ends.push_back(e.to);
    for (const ContourElement& e : track.join) ends.push_back(e.to);
  }
  return ends;
}

void expectStart(const Points& got, const Points& wanted) {
  ASSERT_GE(got.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    EXPECT_LT((got[k] - wanted[k]).norm(), kDigitsOfDigest) << k << ": " << got[k].transpose();
}

const Vec2 kOrigin(0, 0), kCorner(10, 0);
const PlaneContour kSharp{lineElement(kOrigin, kCorner), lineElement(kCorner, {5, 8.660254037844386})};
const PlaneContour kObtuse{lineElement(kOrigin, kCorner), lineElement(kCorner, {15, 8.660254037844386})};
const PlaneContour kBridge{lineElement(kOrigin, kCorner), arcTo(kCorner, {20, 0}, {15, 0}, false),
                           lineElement({20, 0}, {30, 0})};

// K1 to K4. Rows: wedm-5.6.3-joins wedm-5.5.2-G28 wedm-5.5.2-G29
TEST(WedmConstructedOffset, CornersOfLines) {
  expectStart(endsOf(offsetContour(piecesOf(kSharp, -0.5), 0.002)), {{10, -0.5}, {10.433013, 0.25}});
  expectStart(endsOf(offsetContour(piecesOf(kSharp, -0.5, OuterJoin::kMiter), 0.002)),
              {{10, -0.5}, {10.5, -0.5}, {10.683013, -0.183013}, {10.433013, 0.25}});
  expectStart(endsOf(offsetContour(piecesOf(kObtuse, -0.5, OuterJoin::kMiter), 0.002)),
              {{10, -0.5}, {10.288675, -0.5}, {10.433013, -0.25}});
  expectStart(endsOf(offsetContour(piecesOf(kObtuse, 0.5), 0.002)), {{9.711325, 0.5}});
}

// K5, K6. Row: wedm-5.6.3-joins
TEST(WedmConstructedOffset, CornersOfLinesAndArcs) {
  const OffsetContour inner = offsetContour(piecesOf(kBridge, 0.5), 0.002);
  expectStart(endsOf(inner), {{9.522774, 0.5}, {20.477226, 0.5}, {30, 0.5}});
  EXPECT_NEAR((inner.tracks[1].track.from - Vec2(15, 0)).norm(), 5.5, 1e-9);
  expectStart(endsOf(offsetContour(piecesOf(kBridge, -0.5), 0.002)),
              {{10, -0.5}, {10.5, 0}, {19.5, 0}, {20, -0.5}, {30, -0.5}});
}

std::string squareHole(const std::string& overcut) {
  return "H000=0;H001=110;G90G92X1.5Y1.5;G42H000;G01Y1.;G01Y0;G42H001;" + overcut +
         "X0;Y3.;X3.;Y0;X1.5;G36;G40G01Y1.;M02;";
}

// K7, K8. Row: wedm-5.5.5-G37
TEST(WedmConstructedOffset, CornersOfAHole) {
  const test::WedmPath run(squareHole(""));
  EXPECT_EQ(run.error(), "") << run.first(Severity::kError).message;
  expectStart(
      run.ends(),
      {{1.5, 1}, {1.5, .11}, {.11, .11}, {.11, 2.89}, {2.89, 2.89}, {2.89, .11}, {1.5, .11}, {1.5, 1}});
  double length = 0.0;
  for (std::size_t k = 0; k < run.count(); ++k) length += test::wireTrackLength(run.wire(k).lower);
  EXPECT_NEAR(length, 13.4, 1e-9);
  const test::WedmPath cut(squareHole("G37X50;"));
  expectStart(cut.ends(), {{1.5, 1}, {1.5, .11}, {.11, .11}, {0.074645, 0.074645}, {.11, .11}});
}

// K9, K10. Row: wedm-14-R
TEST(WedmConstructedOffset, RoundedCorners) {
  for (const auto& [code, radius] : {std::pair{"G41", 1.9}, {"G42", 2.1}}) {
    const test::WedmPath run("G92X-5.Y0;H001=100;G01" + std::string(code) +
                             "H001X0;X10.R2.;Y10.;G40X20.;M02;");
    ASSERT_EQ(run.error(), "");
    const WireTrack& arc = run.wire(2).lower;
    EXPECT_LT((arc.center - Vec2(8, 2)).norm(), kDigitsOfDigest);
    EXPECT_NEAR((arc.from - arc.center).norm(), radius, 1e-9) << code;
  }
  const test::WedmPath run("G92X-5.Y0;G01G41H000X0;X10.R2.;G02X20.I5.;G01X30.;M02;");
  const WireTrack& arc = run.wire(2).lower;
  EXPECT_LT((arc.center - Vec2(8.291796, 2)).norm(), kDigitsOfDigest);
  EXPECT_LT((arc.from - Vec2(8.291796, 0)).norm(), kDigitsOfDigest);
  EXPECT_LT((arc.to - Vec2(10.208426, 1.428571)).norm(), kDigitsOfDigest);
  EXPECT_GT(arc.sweep_rad, 0.0);
}

TaperedContour tapered(const PlaneContour& contour, const std::vector<double>& degrees, double side) {
  std::vector<TaperPiece> pieces;
  TaperPiece lead;  // upright and on, so that the first element is no start-up
  lead.on = true;
  lead.element =
      lineElement(contour.front().from - directionOn(contour.front(), false), contour.front().from);
  lead.lean = side * 20 * std::tan(degToRad(degrees.front()));
  pieces.push_back(lead);
  for (std::size_t k = 0; k < contour.size(); ++k) {
    TaperPiece piece;
    piece.on = true;
    piece.element = contour[k];
    piece.lean = side * 20 * std::tan(degToRad(degrees[std::min(k, degrees.size() - 1)]));
    pieces.push_back(piece);
  }
  return taperContour(pieces, {});
}

Points taperEnds(const TaperedContour& contour) {
  Points ends;
  for (std::size_t k = 1; k < contour.elements.size(); ++k) ends.push_back(contour.elements[k].element.to);
  return ends;
}

// K11 to K14 (where the digest gives 1.397010, radii 8.119223 meet at 1.397014), K16. Row: wedm-7.3-joins
TEST(WedmConstructedTaper, CornersWithArcs) {
  expectStart(taperEnds(tapered(kBridge, {3}, -1)),
              {{10, -1.048156}, {11.048156, 0}, {18.951844, 0}, {20, -1.048156}});
  expectStart(taperEnds(tapered(kBridge, {3}, 1)), {{9.043361, 1.048156}, {20.956639, 1.048156}});
  const PlaneContour arcs{arcTo({0, 0}, {10, 0}, {5, 5}, true), arcTo({10, 0}, {20, 0}, {15, 5}, true)};
  expectStart(taperEnds(tapered(arcs, {3}, 1)), {{9.258842, 0.741158}, {10.741158, 0.741158}});
  expectStart(taperEnds(tapered(arcs, {3}, -1)), {{10, -1.397014}});
  expectStart(taperEnds(tapered(kBridge, {0, 3}, 1)), {{8.951844, 0}});
  expectStart(taperEnds(tapered(kBridge, {0, 3}, -1)), {{11.048156, 0}});
}

// K15. Row: wedm-7.5-error
TEST(WedmConstructedTaper, ChangeAtATangentArcIsAnError) {
  const PlaneContour tangent{lineElement(kOrigin, kCorner), arcTo(kCorner, {15, 5}, {10, 5}, true)};
  const TaperedContour contour = tapered(tangent, {0, 3}, 1);
  ASSERT_TRUE(contour.failure);
  EXPECT_EQ(contour.failure->kind, TaperFailure::Kind::kProcessing);
}

// K19, K20. Row: wedm-5.6.7-overcut
TEST(WedmConstructedOffset, Overcut) {
  const PlaneContour circle{arcTo({1, 0}, {1, 0}, {0, 0}, true)};
  const OffsetContour small = offsetContour(piecesOf(circle, 1.2), 0.002);
  ASSERT_TRUE(small.failure);
  EXPECT_EQ(small.failure->kind, OffsetFailure::Kind::kRadius);
  const PlaneContour slot{lineElement({0, 10}, {0, 0}), lineElement({0, 0}, {2, 0}),
                          lineElement({2, 0}, {2, 10})};
  EXPECT_TRUE(offsetContour(piecesOf(slot, 1.2), 0.002).failure);
  const OffsetContour fits = offsetContour(piecesOf(slot, 0.9), 0.002);
  EXPECT_FALSE(fits.failure);
  EXPECT_NEAR((fits.tracks[1].track.to - fits.tracks[1].track.from).norm(), 0.2, 1e-9);
  const PlaneContour zigzag{lineElement({0, 0}, {10, 0}), lineElement({10, 0}, {10, 5}),
                            lineElement({10, 5}, {0, 1})};
  EXPECT_TRUE(offsetContour(piecesOf(zigzag, 0.9), 0.002).failure);
}

/// A star-shaped closed contour of lines and arcs, counter-clockwise.
PlaneContour randomContour(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const int corners = 4 + static_cast<int>(random() % 8);
  Points points;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * kPi * (k + 0.6 * unit(random)) / corners, radius = 5 + 15 * unit(random);
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  PlaneContour contour;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 &a = points[k], &b = points[(k + 1) % points.size()];
    if (unit(random) < 0.5) {
      contour.push_back(lineElement(a, b));
      continue;
    }
    const Vec2 chord = b - a;
    const double bulge = (0.6 + 2 * unit(random)) * (unit(random) < 0.5 ? -1 : 1);
    contour.push_back(arcTo(a, b, 0.5 * (a + b) + bulge * Vec2(-chord.y(), chord.x()), bulge > 0));
  }
  return contour;
}

// Rows: wedm-5.6.3-joins wedm-5.6.7-overcut
TEST(WedmOffsetProperty, TheWireKeepsItsDistanceOrAnAlarmSaysWhyNot) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> offsets(-1.5, 1.5);
  int good = 0, refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const PlaneContour contour = randomContour(random);
    const double offset = offsets(random);
    const auto outer = static_cast<OuterJoin>(trial % 3);
    const OffsetContour wire = offsetContour(piecesOf(contour, offset, outer), 0.002);
    if (wire.failure) {
      ++refused;
      continue;
    }
    ++good;
    Vec2 last = wire.tracks.front().track.from;
    const auto look = [&](const ContourElement& e) {
      EXPECT_LT((e.from - last).norm(), 1e-9) << "the way has no gaps, trial " << trial;
      last = e.to;
      for (int i = 0; i <= 50; ++i) {
        double distance = INFINITY;
        for (const ContourElement& c : contour)
          distance = std::min(distance, distanceFrom(c, pointOn(e, i / 50.0)));
        EXPECT_GT(distance, std::abs(offset) - 0.00201) << "trial " << trial << " offset " << offset;
      }
    };
    for (const OffsetTrack& track : wire.tracks) {
      look(track.track);
      for (const ContourElement& e : track.join) look(e);
    }
  }
  EXPECT_GT(good, 100);
  EXPECT_GT(refused, 5);
}

// Where one plane fails at the element behind the next one, nothing is sent whose end is not known there.
TEST(WedmOffset, WhatIsSentBeforeAFailureHangsTogether) {
  ControlSettings settings;
  settings.parameters = {{"T", 20}, {"ZM", 20}, {"ZS", 0}};
  const test::WedmPath run(
      "H001=0.135;\nG90 G92 X0 Y0 U0 V0;\nC001;\nG61;\nG41 H000;\nG01 X0 Y10. : G01 X0;\nG41 H001;\n"
      "G02 X-10. Y20. I0 J10. : X-10. Y20.;\nX0 Y30. I10. J0 : X0 Y30.;\nH001=0.135;\nG90 G92 X0 Y0 U0 V0;\n"
      "G61;\nG41 H000;\nG01 X0 Y10.;\nM02;\n",
      settings);
  EXPECT_EQ(run.error(), "wedm-5.6.4-cancel");
  ASSERT_GT(run.count(), 0u);
  for (std::size_t k = 1; k < run.count(); ++k) {
    EXPECT_EQ(run.wire(k).lower.from, run.wire(k - 1).lower.to) << k;
    EXPECT_EQ(run.wire(k).upper.from, run.wire(k - 1).upper.to) << k;
  }
}

// The distance that the check of overcut uses, by brute force.
TEST(WedmOffsetProperty, DistancesOfElementsAreThoseOfTheirPoints) {
  std::mt19937 random(21);
  for (int trial = 0; trial < 100; ++trial) {
    const PlaneContour a = randomContour(random), b = randomContour(random);
    const double distance = distanceBetween(a[0], b[1]);
    double brute = INFINITY;
    for (int i = 0; i <= 2000; ++i) brute = std::min(brute, distanceFrom(b[1], pointOn(a[0], i / 2000.0)));
    EXPECT_LE(distance, brute + 1e-9) << trial;
    EXPECT_GT(distance, brute - 0.03) << trial;
  }
}

}  // namespace
}  // namespace proveout
