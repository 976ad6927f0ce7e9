// FlexNC templates with random letters.
#pragma once

#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "flexnc_call.h"

namespace proveout::test {

/// Where the letters X and A lie on the profile.
enum class At { kNowhere, kStart, kEnd, kLineStart, kLineEnd };
struct FlexncTemplate {
  std::string code, letters;  ///< letters besides P, C, B, V, Z
  At x, a;
  bool hole = true;
};
inline void PrintTo(const FlexncTemplate& t, std::ostream* out) { *out << t.code; }

inline std::vector<FlexncTemplate> flexncTemplates() {
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

/// The block that makes the call.
inline std::string flexncBlock(nc::CycleCode code, const nc::CycleArguments& arguments) {
  std::string text = nc::cycleName(code);
  for (char letter = 'A'; letter <= 'Z'; ++letter)
    if (arguments.has(letter)) text += letter + std::to_string(arguments.value(letter));
  return text;
}

/// Without some letters.
inline nc::CycleArguments without(const nc::CycleArguments& arguments, const std::string& letters) {
  nc::CycleArguments kept;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (arguments.has(letter) && letters.find(letter) == std::string::npos)
      kept.set(letter, arguments.value(letter));
  }
  return kept;
}

class FlexncRandom {
 public:
  explicit FlexncRandom(unsigned seed) : random_(seed) {}

  double number(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }

  struct GoodCall {
    nc::CycleCall call;
    nc::CycleAnswer answer;
  };
  /// A call that the control takes without a warning: its profile lies behind the start plane. `side`: 1 a
  /// shaft, -1 a hole. Nothing: such calls are too rare.
  std::optional<GoodCall> goodCall(const FlexncTemplate& t, double side, bool contour) {
    for (int tries = 0; tries < 20000; ++tries) {
      const nc::CycleCall call = anyCall(t, side, contour);
      nc::CycleAnswer answer = performCycle(call);
      if (!answer.alarm && answer.warnings.empty()) return GoodCall{call, std::move(answer)};
    }
    return std::nullopt;
  }

 private:
  nc::CycleCall anyCall(const FlexncTemplate& t, double side, bool contour) {
    nc::CycleCall call = flexncCall(t.code);
    for (const char letter : t.letters) {
      const bool diameter = letter == 'X' || letter == 'A';
      const double most = letter == 'G' ? 85.0 : letter == 'Y' ? 60.0 : diameter ? 200.0 : 30.0;
      call.arguments.set(letter, number(letter == 'G' ? 3.0 : 1.0, most));
    }
    call.arguments.set('Z', number(0.0, 1.0) < 0.2 && t.code != "G3.1" ? 0.0 : number(1.0, 60.0));
    call.arguments.set('C', side * number(0.5, 4.0));
    if (number(0.0, 1.0) < 0.3) call.arguments.set('V', number(0.0, 10.0));
    if (number(0.0, 1.0) < 0.5) call.arc_view = nc::ArcView::kXUp;
    call.arguments.set('P', contour ? 0.0 : number(0.3, 5.0));
    contour ? call.arguments.set('K', 1.0) : call.arguments.set('B', number(0.5, 5.0));
    return call;
  }

  std::mt19937 random_;
};

/// Radius of the profile at z, led on along its start's cylinder; of a plane the end away from the stock.
inline double radiusAt(const PlaneContour& profile, double z) {
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

inline double distanceFrom(const PlaneContour& profile, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContourElement& e : profile) least = std::min(least, proveout::distanceFrom(e, p));
  return least;
}

}  // namespace proveout::test
