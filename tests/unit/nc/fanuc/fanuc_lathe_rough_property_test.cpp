// Random contours roughed by whole programs: G71 and G72 in both forms and types, inside and outside. No
// motion enters the finish contour with its allowance, which G70 shows. fan-16-G71 fan-16-G71II fan-16-G71one
// fan-16-G72 haas-18-latheG71 haas-18-latheG72
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/unit/nc/fanuc/lathe_run.h"

namespace proveout::test {
namespace {

/// How the contour lies. `along`: coordinate of (z, x) that its blocks go along.
struct RoughCase {
  bool facing = false, inside = false, pockets = false, one_line = false, haas = false;
  double depth = 1.5, across = 0.4, along = 0.1;  ///< allowances: of X a diameter
};

class RandomRough {
 public:
  explicit RandomRough(unsigned seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  RoughCase make() {
    RoughCase c;
    c.facing = below(3) == 0;
    c.inside = below(3) == 0;
    c.pockets = below(2) == 0;
    c.one_line = below(2) == 0;
    c.haas = c.one_line && below(2) == 0;
    c.depth = 0.5 + 0.25 * below(8);
    return c;
  }

  /// The blocks of the contour by steps of a millimetre: `s` goes on by itself, `d` is the depth over it.
  /// G71: s is -Z, d the radius; G72: s the radius towards the axis or away, d is Z.
  std::string contour(const RoughCase& c) {
    const int first = 4;
    int s = 0, d = first;
    std::string text = fmt::format("N10 G0 {}\n", c.pockets ? point(c, s, d) : depthWord(c, d));
    if (!c.pockets) text += fmt::format("G1 {}\n", stepWord(c, s));
    const int blocks = 3 + below(5);
    bool fell = false;
    for (int k = 0; k < blocks; ++k) {
      const bool falls = c.pockets && !fell && k > 0 && k + 1 < blocks && below(3) == 0 && d > 3;
      const int ds = 1 + below(5), dd = falls ? -(1 + below(std::min(3, d - 2))) : below(4);
      fell = falls;
      const bool quarter = ds == dd && d + dd < 20;
      s += ds;
      d = std::min(d + dd, 20);
      if (quarter) {
        text += fmt::format("G{} {} R{}.\n", below(2) == 0 ? 2 : 3, point(c, s, d), dd);
      } else {
        text += fmt::format("G1 {}\n", point(c, s, d));
      }
      if (!falls && !c.pockets && below(4) == 0)
        text += fmt::format("G1 {}\n", stepWord(c, s += 2 + below(3)));
    }
    return text + fmt::format("N20 G1 {}\n", depthWord(c, 22));
  }

 private:
  /// Of G71 X is 40 + 2 d outside, 90 - 2 d inside; of G72 Z is d - 40.
  static std::string depthWord(const RoughCase& c, int d) {
    if (c.facing) return fmt::format("Z{}.", d - 40);
    return fmt::format("X{}.", c.inside ? 90 - 2 * d : 40 + 2 * d);
  }
  static std::string stepWord(const RoughCase& c, int s) {
    if (!c.facing) return fmt::format("Z-{}.", s);
    return fmt::format("X{}.", c.inside ? 20 + 2 * s : 120 - 2 * s);
  }
  static std::string point(const RoughCase& c, int s, int d) {
    return c.facing ? stepWord(c, s) + " " + depthWord(c, d) : depthWord(c, d) + " " + stepWord(c, s);
  }

  std::mt19937 random_;
};

/// Where the cycle begins: off the contour on the side of the tool.
std::string startOf(const RoughCase& c) {
  if (c.facing) return c.inside ? "G0 X17. Z-16.\n" : "G0 X123. Z-16.\n";
  return c.inside ? "G0 X44. Z2.\n" : "G0 X86. Z2.\n";
}

std::string roughWords(const RoughCase& c) {
  const double u = c.facing ? 0.0 : c.inside ? -c.across : c.across;
  const double w = c.facing ? c.across : c.along;
  const std::string code = c.facing ? "G72" : "G71";
  const std::string allowance = fmt::format("U{:.3f} W{:.3f}", u, w);
  if (c.one_line)
    return fmt::format("{} P10 Q20 {} D{:.3f}{} F.2\n", code, allowance, c.depth, c.pockets ? " R1" : "");
  return fmt::format("{} {}{:.3f} R.5\n{} P10 Q20 {} F.2\n", code, c.facing ? 'W' : 'U', c.depth, code,
                     allowance);
}

/// Points (z, x) along the motions of lines of a program, arcs by many chords.
/// With `feeds` the feed motions alone, as a polygon.
std::vector<Vec2> sampled(const Toolpath& path, std::uint32_t first_line, std::uint32_t last_line,
                          bool feeds) {
  std::vector<Vec2> all;
  for (const Motion& m : path.motions) {
    if (m.source.line < first_line || m.source.line > last_line) continue;
    if (feeds && m.kind == MotionKind::kRapid) continue;
    const int chords = m.arc >= 0 ? 96 : feeds ? 1 : 12;
    for (int k = 0; k <= chords; ++k) {
      const Vec3 p = path.pointAt(m, static_cast<double>(k) / chords);
      all.emplace_back(p.z(), p.x());
    }
  }
  return all;
}

/// The contour as the highest depth over a coordinate: it goes one way along that.
class Ground {
 public:
  /// `depth`: index of the depth in (z, x); `side`: +1 where the tool stands at larger values.
  Ground(std::vector<Vec2> points, int depth, double side)
      : points_(std::move(points)), depth_(depth), along_(1 - depth), side_(side) {}
  /// How deep a point lies in the contour, mm; below 0: it is clear.
  double inside(const Vec2& p) const {
    double least = -1e9;
    for (const double shift : {-1e-3, 1e-3}) {  // on a wall the lower side counts
      const double ground = groundAt(p[along_] + shift);
      const double deep = ground - side_ * p[depth_];
      least = shift < 0.0 ? deep : std::min(least, deep);
    }
    return least;
  }

 private:
  double groundAt(double s) const {
    double ground = -1e9;
    for (std::size_t k = 1; k < points_.size(); ++k) {
      const Vec2 &a = points_[k - 1], &b = points_[k];
      const double low = std::min(a[along_], b[along_]), high = std::max(a[along_], b[along_]);
      if (s < low || s > high || high - low < 1e-9) continue;
      const double share = (s - a[along_]) / (b[along_] - a[along_]);
      ground = std::max(ground, side_ * (a[depth_] + share * (b[depth_] - a[depth_])));
    }
    return ground;
  }
  std::vector<Vec2> points_;
  int depth_, along_;
  double side_;
};

std::uint32_t linesIn(const std::string& text) {
  return static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n'));
}

void checkRough(unsigned seed, int& with_pockets) {
  RandomRough random(seed);
  const RoughCase c = random.make();
  const std::string contour = random.contour(c);
  const std::string head = "O1\nG21 G40 G18 G97 S500 M3\n" + startOf(c) + roughWords(c);
  const std::string text = head + contour + "G70 P10 Q20 F.1\nM30\n";
  const ControlSettings settings = latheAt(140, 20, {{"flavour", c.haas ? 1 : 0}, {"decimal", 0}});
  const IsoRun run = lathe(text, settings);
  ASSERT_EQ(run.error(), "") << run.message() << "\n" << text;
  const std::uint32_t rough = linesIn(head), finish_from = rough + 1, finish_to = rough + linesIn(contour);
  // The cycle ends with its way back to the start; what follows is G70, whose motions are the blocks' own.
  std::size_t behind = 0;
  for (std::size_t k = 0; k < run.path.motions.size(); ++k)
    if (run.path.motions[k].source.line == rough) behind = k + 1;
  ASSERT_GT(behind, 0U) << text;
  Toolpath first = run.path, second = run.path;
  first.motions.resize(behind);
  second.motions.erase(second.motions.begin(), second.motions.begin() + static_cast<std::ptrdiff_t>(behind));
  std::vector<Vec2> shape = sampled(second, finish_from, finish_to, true);
  ASSERT_GT(shape.size(), 3U) << text;
  const Vec2 allowance(c.facing ? c.across : c.along,
                       c.facing ? 0.0 : 0.5 * (c.inside ? -c.across : c.across));
  for (Vec2& p : shape) p += allowance;
  const double side = !c.facing && c.inside ? -1.0 : 1.0;
  const Ground ground(shape, c.facing ? 0 : 1, side);
  for (const Vec2& p : sampled(first, rough, finish_to, false))
    ASSERT_LT(ground.inside(p), 5e-3) << "z " << p.x() << " x " << 2.0 * p.y() << "\n" << text;
  // The last pass is the contour with its allowance.
  const std::vector<Vec2> last = sampled(first, finish_from, finish_to, true);
  ASSERT_FALSE(last.empty()) << text;
  EXPECT_LT((last.back() - shape.back()).norm(), 1e-6) << text;
  with_pockets += c.pockets ? 1 : 0;
}

TEST(FanucLatheRoughProperty, NothingEntersTheFinishContour) {
  int with_pockets = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    checkRough(seed, with_pockets);
    if (::testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(with_pockets, 350);
}

}  // namespace
}  // namespace proveout::test
