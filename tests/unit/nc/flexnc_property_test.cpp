// Laws that hold for FlexNC templates with any letters, at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/geometry/plane.h"
#include "core/nc/services/contour_elements.h"
#include "flexnc_call.h"

namespace proveout {
namespace {

using nc::CycleAnswer;
using nc::CycleCall;
using nc::CycleMove;
using test::contourOf;
using Role = CycleMove::Role;

/// Where the letters X and A lie on the profile.
enum class At { kNowhere, kStart, kEnd, kLineStart, kLineEnd };
struct Template {
  std::string code, letters;  ///< letters besides P, C, B, V, Z
  At x, a;
  bool hole = true;
};
void PrintTo(const Template& t, std::ostream* out) { *out << t.code; }

std::vector<Template> templates() {
  return {{"G3.1", "XAR", At::kEnd, At::kStart, false},
          {"G12", "XR", At::kEnd, At::kNowhere},
          {"G13", "XR", At::kEnd, At::kNowhere},
          {"G77", "XAY", At::kEnd, At::kStart},
          {"G77.1", "XYG", At::kEnd, At::kNowhere},
          {"G77.2", "AYG", At::kNowhere, At::kStart},
          {"G77.3", "AXG", At::kEnd, At::kStart},
          {"G13.1", "XYRG", At::kEnd, At::kNowhere},
          {"G13.2", "AYRG", At::kNowhere, At::kStart},
          {"G13.5", "XARG", At::kEnd, At::kStart, false},
          {"G12.1", "XYRG", At::kEnd, At::kNowhere},
          {"G12.2", "AYRG", At::kNowhere, At::kStart},
          {"G12.3", "AYRG", At::kNowhere, At::kLineStart},
          {"G12.5", "XARG", At::kEnd, At::kStart},
          {"G22.1", "XYRUG", At::kEnd, At::kNowhere},
          {"G22.2", "AYRUG", At::kNowhere, At::kStart},
          {"G22.3", "AYRUG", At::kNowhere, At::kLineStart},
          {"G23.1", "XYRUG", At::kLineEnd, At::kNowhere},
          {"G23.2", "AYRUG", At::kNowhere, At::kLineStart},
          {"G23.3", "XYRUG", At::kEnd, At::kNowhere},
          {"G23.4", "AYRUG", At::kNowhere, At::kStart},
          {"G8.1", "XARU", At::kEnd, At::kStart, false}};
}

class FlexncLaws : public testing::TestWithParam<Template> {
 protected:
  static constexpr int kCalls = 60;
  static constexpr unsigned kSeed = 20260020;

  void SetUp() override { RecordProperty("seed", static_cast<int>(kSeed)); }

  double number(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }

  CycleCall anyCall(double side, bool contour) {
    CycleCall call = test::flexncCall(GetParam().code);
    for (const char letter : GetParam().letters) {
      const bool diameter = letter == 'X' || letter == 'A';
      const double most = letter == 'G' ? 85.0 : letter == 'Y' ? 60.0 : diameter ? 200.0 : 30.0;
      call.arguments.set(letter, number(letter == 'G' ? 3.0 : 1.0, most));
    }
    call.arguments.set('Z', number(0.0, 1.0) < 0.2 && GetParam().code != "G3.1" ? 0.0 : number(1.0, 60.0));
    call.arguments.set('C', side * number(0.5, 4.0));
    if (number(0.0, 1.0) < 0.3) call.arguments.set('V', number(0.0, 10.0));
    if (number(0.0, 1.0) < 0.5) call.arc_view = nc::ArcView::kXUp;
    call.arguments.set('P', contour ? 0.0 : number(0.3, 5.0));
    contour ? call.arguments.set('K', 1.0) : call.arguments.set('B', number(0.5, 5.0));
    return call;
  }

  /// Calls that the control takes, their profile behind the start plane.
  template <typename Law>
  void forGoodCalls(bool contour, const Law& law) {
    for (const double side : GetParam().hole ? std::vector{1.0, -1.0} : std::vector{1.0}) {
      int good = 0;
      for (int tries = 0; tries < 200000 && good < kCalls; ++tries) {
        const CycleCall call = anyCall(side, contour);
        const CycleAnswer answer = performCycle(call);
        if (answer.alarm || !answer.warnings.empty()) continue;
        ++good;
        SCOPED_TRACE(testing::Message() << textOf(call) << " seed " << kSeed);
        law(call, answer, side);
        if (HasFailure()) return;
      }
      EXPECT_EQ(good, kCalls) << "calls that are taken are too rare";
    }
  }

  static std::string textOf(const CycleCall& call) {
    std::string text = cycleName(call.code);
    for (char letter = 'A'; letter <= 'Z'; ++letter)
      if (call.arguments.has(letter)) text += letter + std::to_string(call.arguments.value(letter));
    return text + (call.arc_view == nc::ArcView::kXUp ? " up" : "");
  }

  std::mt19937 random_{kSeed};
};

/// Radius of the profile at z, led on along its start's cylinder; of a plane the end away from the stock.
double radiusAt(const PlaneContour& profile, double z) {
  if (z >= profile.front().from.x()) return profile.front().from.y();
  for (const ContourElement& e : profile) {
    if (z < e.to.x()) continue;
    if (!e.arc) return e.from.y() + (e.to.y() - e.from.y()) * (z - e.from.x()) / (e.to.x() - e.from.x());
    const double w = z - e.center.x(), radius = (e.from - e.center).norm();
    const double root = std::sqrt(std::max(radius * radius - w * w, 0.0));
    return e.center.y() + (0.5 * (e.from.y() + e.to.y()) > e.center.y() ? root : -root);
  }
  return profile.back().to.y();
}

double distanceFrom(const PlaneContour& profile, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContourElement& e : profile) least = std::min(least, proveout::distanceFrom(e, p));
  return least;
}

TEST_P(FlexncLaws, ProfilesGoOneWay) {
  forGoodCalls(true, [](const CycleCall&, const CycleAnswer& answer, double side) {
    const PlaneContour profile = contourOf(answer);
    for (std::size_t k = 0; k < profile.size(); ++k) {
      const ContourElement& e = profile[k];
      if (e.arc) {
        EXPECT_NEAR((e.from - e.center).norm(), (e.to - e.center).norm(), 1e-9);
        EXPECT_LT((pointOn(e, 0.999999) - e.to).norm(), 1e-3);  // its sweep ends where it ends
        EXPECT_LT(std::abs(e.sweep), kPi);
      }
      for (int i = 0; i < 20; ++i) {
        const Vec2 way = pointOn(e, (i + 1) / 20.0) - pointOn(e, i / 20.0);
        EXPECT_LT(way.x(), 1e-9);
        EXPECT_GT(side * way.y(), -1e-9);
      }
    }
    EXPECT_GT(side * (profile.back().to.y() - profile.front().from.y()), 0.0);
  });
}

// Elements of one profile are tangent to each other; noses and shoulders to planes, roots and crests to
// cylinders.
TEST_P(FlexncLaws, ElementsAreTangent) {
  forGoodCalls(true, [](const CycleCall& call, const CycleAnswer& answer, double) {
    const PlaneContour profile = contourOf(answer);
    for (std::size_t k = 1; k < profile.size(); ++k) {
      EXPECT_NEAR(cross2(directionOn(profile[k - 1], true), directionOn(profile[k], false)), 0.0, 1e-7);
    }
    if (call.code == nc::CycleCode::kG3_1) return;
    const ContourElement &first = profile.front(), &last = profile.back();
    const auto square = [](const Vec2& d) { return std::min(std::abs(d.x()), std::abs(d.y())); };
    EXPECT_NEAR(first.arc ? square(directionOn(first, false)) : 0.0, 0.0, 1e-7);
    EXPECT_NEAR(last.arc ? square(directionOn(last, true)) : 0.0, 0.0, 1e-7);
  });
}

// X and A are where the manual has them, Y is the axial length, G the angle of the cone.
TEST_P(FlexncLaws, LettersMeanWhatTheManualSays) {
  forGoodCalls(true, [](const CycleCall& call, const CycleAnswer& answer, double side) {
    const PlaneContour profile = contourOf(answer);
    const Vec2 start = profile.front().from, end = profile.back().to;
    const auto cone = std::find_if(profile.begin(), profile.end(), [](const auto& e) { return !e.arc; });
    const auto at = [&](At where) {
      if (where == At::kStart) return start.y();
      if (where == At::kEnd) return end.y();
      const double z = where == At::kLineStart ? start.x() : end.x();
      const Vec2 way = cone->to - cone->from;
      return cone->from.y() + (z - cone->from.x()) * way.y() / way.x();
    };
    for (const auto& [letter, where] : {std::pair{'X', GetParam().x}, {'A', GetParam().a}}) {
      const bool on_line = where == At::kLineStart || where == At::kLineEnd;
      if (where == At::kNowhere || (on_line && (cone->to - cone->from).norm() < 0.01)) continue;
      EXPECT_NEAR(2.0 * at(where), call.arguments.value(letter), 1e-6) << letter;
    }
    if (call.arguments.has('Y')) {
      EXPECT_NEAR(start.x() - end.x(), call.arguments.value('Y'), 1e-9);
    }
    if (call.arguments.has('G') && cone != profile.end() && (cone->to - cone->from).norm() > 0.01) {
      const Vec2 way = cone->to - cone->from;
      EXPECT_NEAR(radToDeg(std::atan2(side * way.y(), -way.x())), call.arguments.value('G'), 1e-6);
    }
    for (const ContourElement& e : profile) {
      const double radius = (e.from - e.center).norm();
      if (e.arc) {
        EXPECT_LT(std::min(std::abs(radius - call.arguments.value('R')),
                           std::abs(radius - call.arguments.value('U'))),
                  1e-9);
      }
    }
  });
}

// Row: fnc-3.1-rough
TEST_P(FlexncLaws, PassesEndOnTheProfile) {
  forGoodCalls(false, [](const CycleCall&, const CycleAnswer& answer, double) {
    const PlaneContour profile = contourOf(answer);
    for (const CycleMove& move : answer.moves) {
      if (move.role != Role::kPass) continue;
      EXPECT_LT(distanceFrom(profile, move.element.to), 1e-6);
      EXPECT_EQ(move.element.from.y(), move.element.to.y());
    }
  });
}

TEST_P(FlexncLaws, NoMoveEntersTheProfile) {
  forGoodCalls(false, [](const CycleCall&, const CycleAnswer& answer, double side) {
    const PlaneContour profile = contourOf(answer);
    for (const CycleMove& move : answer.moves) {
      if (move.role == Role::kContour || move.role == Role::kApproach) continue;
      for (int i = 0; i <= 20; ++i) {
        const Vec2 p = pointOn(move.element, i / 20.0);
        const bool inside = side * (p.y() - radiusAt(profile, p.x())) < -1e-6;
        EXPECT_TRUE(!inside || distanceFrom(profile, p) < 1e-6) << p.transpose();
      }
    }
  });
}

// Wherever a pass could go a step deeper, one does.
TEST_P(FlexncLaws, AtMostOneDepthIsLeft) {
  forGoodCalls(false, [this](const CycleCall& call, const CycleAnswer& answer, double side) {
    const PlaneContour profile = contourOf(answer);
    const double front = profile.front().from.x(), back = profile.back().to.x();
    for (int i = 0; i < 50; ++i) {
      const double z = number(back, front), finished = radiusAt(profile, z);
      double left = side * (profile.back().to.y() - finished);
      for (const CycleMove& move : answer.moves) {
        if (move.role == Role::kPass && move.element.to.x() <= z)
          left = std::min(left, side * (move.element.to.y() - finished));
      }
      EXPECT_LE(left, call.arguments.value('P') + 1e-6) << z;
    }
  });
}

nc::CycleArguments without(const nc::CycleArguments& arguments, const std::string& letters) {
  nc::CycleArguments kept;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (arguments.has(letter) && letters.find(letter) == std::string::npos)
      kept.set(letter, arguments.value(letter));
  }
  return kept;
}

// The contour of the roughing block is that of the contour block with the same letters, and K0 runs it from
// elsewhere. Rows: fnc-3.1-contour fnc-3.1-K
TEST_P(FlexncLaws, ContourBlocksFollowTheSameProfile) {
  forGoodCalls(false, [](const CycleCall& call, const CycleAnswer& answer, double) {
    const PlaneContour roughed = contourOf(answer);
    CycleCall first = call, next = call;
    first.arguments = without(call.arguments, "P");
    first.arguments.set('K', 1.0);
    next.arguments = without(call.arguments, call.code == nc::CycleCode::kG3_1 ? "P" : "PZ");
    next.arguments.set('K', 0.0);
    next.at = roughed.front().from;
    next.chain = nc::ContourChain{};
    for (const CycleCall& again : {first, next}) {
      const CycleAnswer contour = performCycle(again);
      ASSERT_FALSE(contour.alarm) << contour.alarm->text;
      const PlaneContour elements = contourOf(contour);
      ASSERT_EQ(elements.size(), roughed.size());
      for (std::size_t k = 0; k < elements.size(); ++k) {
        EXPECT_LT((elements[k].from - roughed[k].from).norm(), 1e-9);
        EXPECT_LT((elements[k].to - roughed[k].to).norm(), 1e-9);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, FlexncLaws, testing::ValuesIn(templates()));

}  // namespace
}  // namespace proveout
