// Laws that hold for FlexNC templates with any letters, at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/geometry/plane.h"
#include "core/nc/services/contour/contour_elements.h"
#include "flexnc_random.h"

namespace proveout {
namespace {

using nc::CycleAnswer;
using nc::CycleCall;
using nc::CycleMove;
using test::At;
using test::contourOf;
using test::distanceFrom;
using test::flexncBlock;
using test::FlexncRandom;
using test::FlexncTemplate;
using test::radiusAt;
using test::without;
using Role = CycleMove::Role;

class FlexncLaws : public testing::TestWithParam<FlexncTemplate> {
 protected:
  static constexpr int kCalls = 60;
  static constexpr unsigned kSeed = 20260020;

  void SetUp() override { RecordProperty("seed", static_cast<int>(kSeed)); }

  /// Calls that the control takes, their profile behind the start plane.
  template <typename Law>
  void forGoodCalls(bool contour, const Law& law) {
    for (const double side : GetParam().hole ? std::vector{1.0, -1.0} : std::vector{1.0}) {
      for (int k = 0; k < kCalls; ++k) {
        const auto good = random_.goodCall(GetParam(), side, contour);
        ASSERT_TRUE(good) << "calls that are taken are too rare";
        SCOPED_TRACE(testing::Message() << textOf(good->call) << " seed " << kSeed);
        law(good->call, good->answer, side);
        if (HasFailure()) return;
      }
    }
  }

  static std::string textOf(const CycleCall& call) {
    return flexncBlock(call.code, call.arguments) + (call.arc_view == nc::ArcView::kXUp ? " up" : "");
  }

  FlexncRandom random_{kSeed};
};

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
      const double z = random_.number(back, front), finished = radiusAt(profile, z);
      double left = side * (profile.back().to.y() - finished);
      for (const CycleMove& move : answer.moves) {
        if (move.role == Role::kPass && move.element.to.x() <= z)
          left = std::min(left, side * (move.element.to.y() - finished));
      }
      EXPECT_LE(left, call.arguments.value('P') + 1e-6) << z;
    }
  });
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

INSTANTIATE_TEST_SUITE_P(All, FlexncLaws, testing::ValuesIn(test::flexncTemplates()));

}  // namespace
}  // namespace proveout
