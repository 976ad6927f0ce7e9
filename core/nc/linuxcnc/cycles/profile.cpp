#include "core/nc/linuxcnc/cycles/profile.h"

#include <fmt/core.h>

#include "core/geometry/plane.h"
#include "core/nc/linuxcnc/model/block.h"
#include "core/nc/linuxcnc/text/lcn_groups.h"
#include "core/nc/services/contour/contour_shift.h"

namespace proveout::nc {
namespace {

constexpr std::size_t kLcnMostElements = 20000;
constexpr double kLcnNoWay = 1e-9;  ///< mm

/// Makes elements of the lines.
class LcnProfileReader {
 public:
  LcnProfileReader(IsoContext& c, const BlockPlan& plan, const Vec2& from, LinuxCncProfile& out)
      : c_(c), plan_(plan), out_(out), at_(from), unit_(plan.next.unitScale()) {
    x_unit_ = plan.next.active[kGroupLathe] == lcn::kDiameterMode ? 0.5 * unit_ : unit_;
    steps_ = plan.next.incremental();
    absolute_ = plan.next.active[kGroupArcCentre] == lcn::kCentreAbsolute;
  }

  bool take(const LinuxCncContourLine& line) {
    line_ = &line;
    bool idle = false;
    for (const Word& w : line.words) {
      if (w.address != 'G') {
        idle = idle || AddressSet("MFST").has(w.address);
        continue;
      }
      const int code10 = code10Of(w);
      if (lcnGroupOfG(code10) == 1) {
        motion_ = code10;
      } else {
        idle = true;
      }
    }
    if (idle)
      c_.warnOnce("contour codes", "profile",
                  "codes beside G0 to G3, and F, S, T, M, have no effect in the contour of G70, G71, G72", {},
                  Severity::kNote);
    Vec2 to;
    if (!target(to)) return false;
    const Word* a = word('A');
    const Word* c = word('C');
    if ((to - at_).norm() <= kLcnNoWay)
      return (a == nullptr && c == nullptr) || fails("A and C (fillet, chamfer) need a motion in their line");
    if (motion_ == gcode::kArcClockwise || motion_ == gcode::kArcCounterClockwise) {
      if (!arc(to)) return false;
    } else if (motion_ == gcode::kRapid || motion_ == gcode::kLine) {
      out_.add(lineElement(at_, to));
    } else {
      return fails(fmt::format("{}: a contour has G0 to G3 alone", gName(motion_)));
    }
    at_ = to;
    return corner(a, c);
  }

 private:
  const Word* word(Address letter) const {
    for (const Word& w : line_->words)
      if (w.address == letter) return &w;
    return nullptr;
  }
  bool fails(const std::string& why) {
    return lcnFail(c_, "profile", fmt::format("G7X error: line {} of the contour: {}", line_->line + 1, why));
  }

  bool target(Vec2& to) {
    to = at_;
    for (const auto& [letter, by, axis, unit] :
         {std::tuple{'Z', 'W', 0, unit_}, std::tuple{'X', 'U', 1, x_unit_}}) {
      const Word* w = word(letter);
      const Word* step = word(by);
      if (step != nullptr && steps_)
        return fails(fmt::format("Cannot use {} in incremental mode (G91)", addressText(step->address)));
      if (step != nullptr && w != nullptr)
        return fails(fmt::format("Cannot use {} and {} in the same block", addressText(step->address),
                                 addressText(w->address)));
      if (step != nullptr) to[axis] += step->value * unit;
      if (w != nullptr) to[axis] = w->value * unit + (steps_ ? at_[axis] : 0.0);
    }
    return true;
  }

  bool centre(const Vec2& to, bool ccw, Vec2& center) {
    const Word* r = word('R');
    const Word* i = word('I');
    const Word* k = word('K');
    if (r != nullptr) {
      if (i != nullptr || k != nullptr) return fails("both R and I or K flag used for arc");
      const double radius = r->value * unit_;
      if (!(radius > 0.0))
        return fails("an arc of a contour has R above 0: it turns by less than 180 degrees");
      const Vec2 chord = to - at_;
      const double half = 0.5 * chord.norm();
      if (half > radius + kLcnReachMm) return fails("Arc radius too small to reach end point");
      const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
      center = 0.5 * (at_ + to) + leftOf(chord) * ((ccw ? height : -height) / (2.0 * half));
      return true;
    }
    if (i == nullptr && k == nullptr) return fails("either I or K must be present for arc");
    center = absolute_ ? Vec2(Vec2::Zero()) : at_;
    if (k != nullptr) center.x() += k->value * unit_;
    if (i != nullptr) center.y() += i->value * unit_;
    return true;
  }

  bool arc(const Vec2& to) {
    const bool ccw = motion_ == gcode::kArcCounterClockwise;
    Vec2 center;
    if (!centre(to, ccw, center)) return false;
    const Vec2 a = at_ - center, b = to - center;
    if (!lcnRadiiAgree(c_, plan_, a.norm(), b.norm()) || !(a.norm() > 1e-6 && b.norm() > 1e-6))
      return fails("Radius to end of arc differs from radius to start");
    double sweep = std::atan2(cross2(a, b), a.dot(b));
    if (ccw && sweep <= 0.0) sweep += 2.0 * kPi;
    if (!ccw && sweep >= 0.0) sweep -= 2.0 * kPi;
    out_.add(arcElement(center, at_, to, sweep));
    return true;
  }

  bool corner(const Word* a, const Word* c) {
    if (a != nullptr && c != nullptr) return fails("Both A and C parameters on a corner");
    for (const Word* w : {a, c})
      if (w != nullptr && !(w->value > 0.0))
        return fails(fmt::format("{} must be above 0", addressText(w->address)));
    if (a != nullptr) out_.fillets.back() = a->value * unit_;
    if (c != nullptr) out_.chamfers.back() = c->value * unit_;
    return true;
  }

  IsoContext& c_;
  const BlockPlan& plan_;
  LinuxCncProfile& out_;
  const LinuxCncContourLine* line_ = nullptr;
  Vec2 at_;
  double unit_ = 1.0, x_unit_ = 1.0;
  bool absolute_ = false, steps_ = false;
  std::int32_t motion_ = gcode::kRapid;
};

}  // namespace

void LinuxCncProfile::add(const ContourElement& e) {
  elements.push_back(e);
  fillets.push_back(0.0);
  chamfers.push_back(0.0);
}

bool readLinuxCncProfile(IsoContext& c, const BlockPlan& plan, const std::vector<LinuxCncContourLine>& lines,
                         const Vec2& start, LinuxCncProfile& out) {
  LcnProfileReader reader(c, plan, start, out);
  for (const LinuxCncContourLine& line : lines) {
    if (!reader.take(line)) return false;
    if (out.elements.size() > kLcnMostElements)
      return c.alarm(SharedAlarm::kOutOfRange, "Q", "more than 20000 motions in a contour");
  }
  if (out.elements.size() < 2) return lcnFail(c, "profile", "the contour has no motions behind its begin");
  return !out.elements.front().arc ||
         lcnFail(c, "profile", "the first motion of the contour leads to its begin: G0 or G1");
}

bool cutLinuxCncCorners(IsoContext& c, LinuxCncProfile& profile) {
  PlaneContour cut;
  const PlaneContour& all = profile.elements;
  cut.push_back(all.front());
  for (std::size_t k = 1; k < all.size(); ++k) {
    ContourElement next = all[k];
    const double fillet = profile.fillets[k - 1], chamfer = profile.chamfers[k - 1];
    std::optional<ContourElement> arc;
    if (fillet > 0.0 || chamfer > 0.0) {
      if (roundBetween(cut.back(), next, fillet + chamfer, arc) != CornerError::kNone)
        return lcnFail(
            c, "profile",
            fmt::format("G7X error: Corner finish failed: {}{:g} mm does not fit between its motions",
                        fillet > 0.0 ? 'A' : 'C', fillet + chamfer));
      if (arc && chamfer > 0.0) arc = lineElement(arc->from, arc->to);
    }
    if (arc) cut.push_back(*arc);
    cut.push_back(next);
  }
  std::erase_if(cut, [](const ContourElement& e) { return (e.to - e.from).norm() < kLcnNoWay; });
  profile.elements = std::move(cut);
  profile.fillets.assign(profile.elements.size(), 0.0);
  profile.chamfers = profile.fillets;
  return true;
}

}  // namespace proveout::nc
