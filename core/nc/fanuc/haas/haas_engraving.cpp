// Engraving: G47 of Haas mills.
#include <fmt/core.h>

#include <cmath>
#include <string>

#include "core/nc/fanuc/haas/haas.h"
#include "core/nc/iso/context/words.h"
#include "core/nc/iso/cycles/path_steps.h"
#include "core/nc/iso/motion/feed.h"
#include "core/nc/services/stroke_font.h"

namespace proveout::nc {
namespace {

constexpr double kUsualHeightMm = 25.4;
constexpr std::int64_t kText = 0, kSerial = 1, kFirstSign = 32, kLastSign = 126;
constexpr std::size_t kMostLetters = 500;

/// The comment behind G47.
std::string commentOf(const IsoContext& c) {
  const Word* code = c.block.find('G');
  const std::string_view text = c.block.text;
  const std::size_t from = code != nullptr ? static_cast<std::size_t>(code->columns.begin - 1) : 0;
  const std::size_t open = text.find('(', from);
  if (open == std::string_view::npos) return {};
  const std::size_t close = text.find(')', open);
  return std::string(text.substr(open + 1, close == std::string_view::npos ? close : close - open - 1));
}

/// What P asks for. False: reported.
bool engravedText(IsoContext& c, std::string& text) {
  std::int64_t kind = kText;
  const Word* p = c.word('P');
  if (p != nullptr && !integerWord(c, *p, 0, kLastSign, kind)) return false;
  text = commentOf(c);
  if (kind >= kFirstSign) {
    text = std::string(1, static_cast<char>(kind));
  } else if (kind == kSerial) {
    std::erase_if(text, [](char letter) { return letter < '0' || letter > '9'; });
    c.warnOnce("g47-serial", "engraving",
               "G47 P1: the number is engraved as it stands, it is not counted up");
  } else if (kind != kText) {
    return c.alarm(SharedAlarm::kOutOfRange, *p, "0 is a text, 1 a number, 32 to 126 a sign");
  }
  if (text.empty()) return c.fail("engraving", "G47 has no text: write it as a comment in its block");
  return text.size() <= kMostLetters || c.fail("engraving", "G47: the text is too long");
}

struct Lettering {
  double angle_rad = 0.0, height = 0.0, r = 0.0, depth = 0.0, plunge = 1.0;
};

bool readLettering(IsoContext& c, BlockPlan& plan, Lettering& out) {
  const WorkPlane plane = planeOf(plan.next);
  const Word* r = c.word('R');
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "G47 needs the level R between its lines");
  if (!plan.motion.named[static_cast<std::size_t>(plane.w)])
    return c.alarm(SharedAlarm::kMissingData, "Z", "G47 needs the depth of its lines");
  const bool steps = plan.next.incremental();
  out.r = (steps ? plane.of(plan.start).z() : 0.0) + lengthOf(plan, *r);
  out.depth = plane.of(plan.motion.target).z();
  const Word* j = c.word('J');
  out.height = j != nullptr ? lengthOf(plan, *j) : kUsualHeightMm;
  if (!(out.height > 0.0)) return c.alarm(SharedAlarm::kOutOfRange, *j, "a height above 0");
  if (const Word* i = c.word('I')) out.angle_rad = degToRad(std::remainder(i->value, 360.0));
  if (!feedStyle(c, plan, plan.motion.feed)) return false;
  const Word* e = c.word('E');
  if (e == nullptr) return true;
  if (!(e->value > 0.0)) return c.alarm(SharedAlarm::kOutOfRange, *e, "a feed above 0");
  out.plunge = e->value / plan.next.feed;
  return true;
}

}  // namespace

bool planHaasEngraving(IsoContext& c, BlockPlan& plan) {
  if (plan.next.plane() != Plane::kXY) return c.alarm(SharedAlarm::kPlane, "", "G47 engraves in G17");
  if (plan.next.compOn()) return c.fail("engraving", "G47 runs in G40");
  Lettering letters;
  std::string text;
  if (!axisTarget(c, plan, plan.motion.target) || !readLettering(c, plan, letters) || !engravedText(c, text))
    return false;
  char unknown = '\0';
  const std::vector<Stroke> strokes = strokesOf(text, &unknown);
  if (unknown != '\0') {
    c.warn("engraving", fmt::format("G47: the sign {} is not in the font used here and is left blank",
                                    unknown >= ' ' && unknown <= '~' ? std::string(1, unknown) : "?"));
  }
  const WorkPlane plane = planeOf(plan.next);
  const Vec2 origin = plane.of(plan.motion.target).head<2>();
  const Vec2 along = letters.height * Vec2(std::cos(letters.angle_rad), std::sin(letters.angle_rad));
  const auto place = [&](const Vec2& p, double w) {
    const Vec2 at = origin + p.x() * along + p.y() * Vec2(-along.y(), along.x());
    return Vec3(at.x(), at.y(), w);
  };
  c.path_steps.clear();
  const auto add = [&](PathStep::Kind kind, const Vec3& to, double factor) {
    c.path_steps.push_back({kind, to, Vec2::Zero(), 0.0, factor});
  };
  const Vec3 start = plane.of(plan.start);
  add(PathStep::Kind::kRapid, place(Vec2::Zero(), start.z()), 1.0);
  add(PathStep::Kind::kRapid, place(Vec2::Zero(), letters.r), 1.0);
  for (const Stroke& stroke : strokes) {
    add(PathStep::Kind::kRapid, place(stroke.front(), letters.r), 1.0);
    add(PathStep::Kind::kFeed, place(stroke.front(), letters.depth), letters.plunge);
    for (std::size_t k = 1; k < stroke.size(); ++k)
      add(PathStep::Kind::kFeed, place(stroke[k], letters.depth), 1.0);
    add(PathStep::Kind::kRapid, place(stroke.back(), letters.r), 1.0);
  }
  const Vec3 end = c.path_steps.back().to;
  plan.motion.target[plane.u] = end.x();
  plan.motion.target[plane.v] = end.y();
  plan.motion.target[plane.w] = end.z();
  noteHaasPath(c, "G47",
               "the letters have another form on the machine, their place, height and depth are these");
  plan.perform = performSteps;
  return true;
}

}  // namespace proveout::nc
