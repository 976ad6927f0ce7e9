#include "core/nc/linuxcnc/cycles/profile.h"

#include <fmt/core.h>

#include <cctype>
#include <cstdlib>
#include <map>
#include <string>

#include "core/geometry/degrees.h"

namespace proveout::nc {
namespace {

/// A line without blanks and comments, in small letters.
std::string lcnPlain(std::string_view line) {
  std::string text;
  int depth = 0;
  for (const char ch : line) {
    if (ch == ';') break;
    if (ch == '(') ++depth;
    if (depth == 0 && ch != ' ' && ch != '\t' && ch != '\r')
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(ch)));
    if (ch == ')' && depth > 0) --depth;
  }
  return text;
}

/// Words of a line by letter, G codes by themselves. False: something else than numbers stands there.
bool lcnNumbers(const std::string& line, std::map<char, double>& words, std::vector<double>& codes) {
  for (std::size_t i = 0; i < line.size();) {
    const char letter = line[i];
    if (letter < 'a' || letter > 'z') return false;
    std::size_t end = i + 1;
    while (end < line.size() && (std::isdigit(static_cast<unsigned char>(line[end])) != 0 ||
                                 line[end] == '.' || line[end] == '-' || line[end] == '+'))
      ++end;
    if (end == i + 1) return false;
    const double value = std::strtod(line.substr(i + 1, end - i - 1).c_str(), nullptr);
    if (letter == 'g') {
      codes.push_back(value);
    } else {
      words[letter] = value;
    }
    i = end;
  }
  return true;
}

/// Makes elements of the lines.
class LcnProfileReader {
 public:
  LcnProfileReader(IsoContext& c, const BlockPlan& plan, const Vec2& from, LinuxCncProfile& out)
      : c_(c), out_(out), at_(from), unit_(plan.next.unitScale()) {
    x_unit_ = plan.next.active[kGroupLathe] == lcn::kDiameterMode ? 0.5 * unit_ : unit_;
    absolute_ = plan.next.active[kGroupArcCentre] == lcn::kCentreAbsolute;
  }

  bool take(const std::string& line) {
    std::map<char, double> words;
    std::vector<double> codes;
    if (!lcnNumbers(line, words, codes))
      return lcnFail(c_, "profile",
                     fmt::format("the contour's line '{}' has more than words with numbers: it is not "
                                 "read here",
                                 line));
    for (const double code : codes) {
      if (code != std::floor(code) || code < 0.0 || code > 3.0) return true;  // other lines do nothing
      motion_ = static_cast<int>(code);
    }
    if (words.contains('a') || words.contains('c'))
      return lcnFail(c_, "profile",
                     "A and C (fillet, chamfer) in the contour of G70, G71, G72 are not simulated");
    const bool moves =
        words.contains('x') || words.contains('z') || words.contains('u') || words.contains('w');
    return !moves || motion_ < 0 || move(words);
  }

 private:
  bool move(const std::map<char, double>& words) {
    const auto value = [&](char letter, double unit, double otherwise) {
      const auto found = words.find(letter);
      return found == words.end() ? otherwise : found->second * unit;
    };
    Vec2 to(value('z', unit_, at_.x() + value('w', unit_, 0.0)),
            value('x', x_unit_, at_.y() + value('u', x_unit_, 0.0)));
    if (!started_) {
      // The first motion leads to the contour's begin.
      started_ = true;
      out_.begin = at_ = to;
      return true;
    }
    if (motion_ < 2) {
      if ((to - at_).norm() > 0.0) out_.contour.push_back(lineElement(at_, to));
      at_ = to;
      return true;
    }
    return arc(words, to);
  }

  bool arc(const std::map<char, double>& words, const Vec2& to) {
    const bool ccw = motion_ == 3;
    Vec2 center = absolute_ ? Vec2(Vec2::Zero()) : at_;
    if (words.contains('r')) {
      const double radius = words.at('r') * unit_;
      const Vec2 chord = to - at_;
      const double half = 0.5 * chord.norm();
      if (!(half > 0.0) || half > std::abs(radius) + 0.00127)
        return lcnFail(c_, "arc-reach", "Arc radius too small to reach end point, in the contour");
      const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
      const double side = ccw == (radius > 0.0) ? 1.0 : -1.0;
      center = 0.5 * (at_ + to) + Vec2(-chord.y(), chord.x()) * (side * height / (2.0 * half));
    } else {
      if (words.contains('k')) center.x() += words.at('k') * unit_;
      if (words.contains('i')) center.y() += words.at('i') * unit_;
    }
    const Vec2 a = at_ - center, b = to - center;
    if (std::abs(a.norm() - b.norm()) > 0.03 || a.norm() < 1e-6)
      return lcnFail(c_, "arc-radius", "Radius to end of arc differs from radius to start, in the contour");
    double sweep = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    if (ccw && sweep <= 0.0) sweep += 2.0 * kPi;
    if (!ccw && sweep >= 0.0) sweep -= 2.0 * kPi;
    out_.contour.push_back(arcElement(center, at_, to, sweep));
    at_ = to;
    return true;
  }

  IsoContext& c_;
  LinuxCncProfile& out_;
  Vec2 at_;
  double unit_ = 1.0, x_unit_ = 1.0;
  bool absolute_ = false, started_ = false;
  int motion_ = -1;
};

}  // namespace

bool readLinuxCncProfile(IsoContext& c, const BlockPlan& plan, std::int64_t number, const Vec2& from,
                         LinuxCncProfile& out) {
  const std::string open = fmt::format("o{}sub", number), close = fmt::format("o{}endsub", number);
  LcnProfileReader reader(c, plan, from, out);
  bool inside = false;
  constexpr std::size_t kMostElements = 20000;
  for (const std::string_view raw : c.calls.top().text->lines()) {
    std::string line = lcnPlain(raw);
    if (!inside) {
      inside = line == open;
      continue;
    }
    if (line == close) {
      if (!out.contour.empty()) return true;
      return lcnFail(c, "profile", fmt::format("the contour of o{} has no motions", number));
    }
    if (!line.empty() && line[0] == 'n')
      line.erase(0, std::min(line.size(), line.find_first_not_of("0123456789.", 1)));
    if (line.empty() || line[0] == '/' || line[0] == 'o') continue;
    if (!reader.take(line)) return false;
    if (out.contour.size() > kMostElements)
      return c.alarm(SharedAlarm::kOutOfRange, "Q", "more than 20000 motions in a contour");
  }
  return lcnFail(
      c, "profile",
      fmt::format("the contour is missing: o{} sub .. o{} endsub in this program", number, number));
}

}  // namespace proveout::nc
