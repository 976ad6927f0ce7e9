#include "removal/contact/contacts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel_for.h"
#include "core/path/posed_way.h"
#include "removal/contact/contact_depth.h"
#include "removal/sweep/tool_frame.h"

namespace proveout {
namespace {

/// The samples of one contact.
struct Met {
  Contact contact;
  std::vector<ContactSample> samples;  ///< by pass
};

ContactKind kindOf(const ContactScene& scene, const Pass& pass) {
  if (pass.part == ToolPart::kShank) return ContactKind::kShank;
  if (pass.part == ToolPart::kHolder) return ContactKind::kHolder;
  if (scene.fixture) return ContactKind::kFixture;
  const bool rapid = scene.path.motions[pass.motion].kind == MotionKind::kRapid;
  return rapid ? ContactKind::kRapid : ContactKind::kSpindleOff;
}

bool sameBlock(const Motion& a, const Motion& b) {
  return a.source.file == b.source.file && a.source.line == b.source.line;
}

std::vector<Met> groups(const ContactScene& scene, const std::vector<ContactSample>& samples) {
  PROVEOUT_ASSERT_DEAR(std::is_sorted(samples.begin(), samples.end(),
                                      [](const auto& a, const auto& b) { return a.pass < b.pass; }));
  const bool every_cut = !startsSpindle(scene.path);  // then one block stands for all
  bool cut_told = false;
  const double h = scene.stock.h, unit = kVolumeUnit * h * h * h;
  std::vector<Met> groups;
  for (const ContactSample& sample : samples) {
    const Pass& pass = scene.record.table.passes[sample.pass];
    const Motion& motion = scene.path.motions[pass.motion];
    const ContactKind kind = kindOf(scene, pass);
    Met* met = nullptr;
    for (auto it = groups.rbegin(); it != groups.rend() && met == nullptr; ++it) {
      const Motion& other = scene.path.motions[it->contact.motion];
      if (it->contact.kind == kind && other.tool == motion.tool && sameBlock(other, motion)) met = &*it;
      if (other.source.line != motion.source.line) break;
    }
    if (met == nullptr && kind == ContactKind::kSpindleOff) {
      if (every_cut && cut_told) continue;
      cut_told = true;
    }
    if (met == nullptr) {
      groups.push_back({{kind, pass.motion, pass.motion, Vec3::Zero(), 0.0, 0.0}, {}});
      met = &groups.back();
    }
    met->contact.last = std::max(met->contact.last, pass.motion);
    met->contact.volume_mm3 += static_cast<double>(sample.volume) * unit;
    met->samples.push_back(sample);
  }
  return groups;
}

/// Samples of one body that searches set out from: half of them the deepest, the others spread over the rest.
constexpr std::size_t kLeastStarts = 4, kMostStarts = 64;
/// Share of the effort that looking at them may take, as a divisor; a start takes two depths.
constexpr int kStartShare = 16;

std::vector<Vec3> thinned(const std::vector<Vec3>& points, std::size_t most) {
  if (points.size() <= most) return points;
  const std::size_t first = most / 2, rest = points.size() - first;
  std::vector<Vec3> kept(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = 0; i < first; ++i) kept.push_back(points[first + i * rest / first]);
  return kept;
}

/// The samples of one part of the tool on one motion.
struct Body {
  const Pass* pass = nullptr;
  double depth = 0.0;        ///< largest of a sample, mm
  std::vector<Vec3> points;  ///< the deepest of each pass first
};

std::vector<Body> bodiesOf(const ContactScene& scene, const Met& met) {
  std::map<std::pair<MotionId, const ConvexProfile*>, Body> bodies;
  for (const ContactSample& sample : met.samples) {
    const Pass& pass = scene.record.table.passes[sample.pass];
    Body& body = bodies[{pass.motion, &pass.body.profile()}];
    if (body.pass == nullptr) body.pass = &pass;
    body.depth = std::max(body.depth, sample.depth);
    body.points.push_back(sample.where);
  }
  std::vector<Body> list;
  for (auto& [key, body] : bodies) list.push_back(std::move(body));
  std::stable_sort(list.begin(), list.end(), [](const Body& a, const Body& b) {
    return a.depth != b.depth ? a.depth > b.depth : a.pass < b.pass;
  });
  return list;
}

/// Depths that are asked for all contacts of a path together, and for one at most: a program that cuts in
/// rapid throughout is told in seconds, and nobody reads how deep each of its blocks is to the micrometre.
constexpr std::size_t kAllDepths = 2'000'000, kMostDepths = 100'000;

void measure(const ContactScene& scene, int effort, Met& met) {
  const std::size_t starts =
      std::clamp(static_cast<std::size_t>(effort / kStartShare), kLeastStarts, kMostStarts);
  for (const Body& body : bodiesOf(scene, met)) {
    DeepestPoint deepest(scene.depth, *body.pass, metBefore(*body.pass), scene.stock.h);
    const DeepPoint found = deepest.find(thinned(body.points, starts), met.contact.depth_mm, effort);
    if (found.depth <= met.contact.depth_mm) continue;
    met.contact.depth_mm = found.depth;
    met.contact.where = found.where;
  }
}

/// Whether the lowest end of a part is so narrow that it may pass between the grid's vertical lines.
bool isPointed(const ConvexProfile& profile, double h) {
  const ConvexProfile::Element& lowest = profile.element(0);
  return lowest.arc || lowest.dz != 0.0 || lowest.br < h;
}

/// The way of the lowest end of a part.
class EndWay {
 public:
  EndWay(const Toolpath& path, const Pass& pass)
      : path_(path), motion_(path.motions[pass.motion]), up_(pass.body.profile().zMin()) {
    if (wayOf(path, motion_).turns()) {
      posed_.emplace(posedWayOf(path, motion_));
      const PosedWay::Bounds bounds = posed_->boundsOn(0.0, 1.0);
      length_ = bounds.tip.velocity + std::abs(up_) * bounds.axis.velocity;
    } else {
      end_ = up_ * pass.body.axis();
      length_ = path.length(motion_);
    }
  }

  Vec3 at(double share) const {
    if (!posed_) return path_.pointAt(motion_, share) + end_;
    const ToolPose pose = posed_->at(share);
    return pose.tip + up_ * pose.axis;
  }
  /// No share of the motion is longer than that of this, mm.
  double length() const { return length_; }
  Box3 bounds() const {
    const Box3 tip = path_.bounds(motion_);
    return posed_ ? tip.inflated(std::abs(up_)) : Box3{tip.min + end_, tip.max + end_};
  }

 private:
  const Toolpath& path_;
  const Motion& motion_;
  double up_;                ///< from the control point along the axis, mm
  Vec3 end_ = Vec3::Zero();  ///< the same where the axis stands still
  double length_ = 0.0;
  std::optional<PosedWay> posed_;
};

/// Follows the tips of pointed cutters on their watched motions: what they meet between the samples.
class TipTracer {
 public:
  explicit TipTracer(const ContactScene& scene) : scene_(scene), reach_(scene.stock.blank) {}

  /// Numbers of the passes to be followed, one a motion and part.
  std::vector<std::uint32_t> passes() const;
  /// The deepest place of each piece of the way that lies in the stock.
  void follow(std::uint32_t number, std::vector<ContactSample>& samples) const;

 private:
  const ContactScene& scene_;
  Box3 reach_;
};

std::vector<std::uint32_t> TipTracer::passes() const {
  const auto& motions = scene_.path.motions;
  const bool spindle_used = startsSpindle(scene_.path);
  std::vector<std::uint32_t> numbers;
  const auto& passes = scene_.record.table.passes;
  for (std::uint32_t i = 0; i < passes.size(); ++i) {
    const Pass& pass = passes[i];
    if (!pass.watched || !pass.cuts() || !isPointed(pass.body.profile(), scene_.stock.h)) continue;
    if (scene_.record.table.goesOn(i)) continue;  // another chord
    const Motion& motion = motions[pass.motion];
    // A spindle that the program never starts is told once, from the samples.
    if (motion.kind != MotionKind::kRapid && !scene_.fixture && !spindle_used) continue;
    if (EndWay(scene_.path, pass).bounds().overlaps(reach_)) numbers.push_back(i);
  }
  return numbers;
}

void TipTracer::follow(std::uint32_t number, std::vector<ContactSample>& samples) const {
  const Pass& pass = scene_.record.table.passes[number];
  const EndWay end(scene_.path, pass);
  const double length = end.length();
  const SweptCutter* hint = nullptr;
  ContactSample deepest{number, 0.0, Vec3::Zero(), 0};
  const auto leave = [&] {
    if (deepest.depth > kContactToleranceMm) samples.push_back(deepest);
    deepest.depth = 0.0;
  };
  for (double way = 0.0;; way = std::min(way, length)) {
    const Vec3 tip = end.at(length > 0.0 ? way / length : 0.0);
    const double depth = scene_.depth.at(tip, pass.motion, hint).value;
    if (depth > deepest.depth) {
      deepest.depth = depth;
      deepest.where = tip;
    }
    if (depth <= 0.0) leave();
    if (way >= length) break;
    way += std::max(std::abs(depth), 0.5 * scene_.stock.h);  // the depth changes no faster than the way
  }
  leave();
}

bool isPlaceBefore(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

}  // namespace

bool startsSpindle(const Toolpath& path) {
  return std::any_of(path.motions.begin(), path.motions.end(),
                     [](const Motion& m) { return m.spindle != 0.0; });
}

std::vector<Contact> gatherContacts(const ContactScene& scene, std::vector<ContactSample> samples,
                                    Progress& progress) {
  const TipTracer tips(scene);
  const std::vector<std::uint32_t> pointed = tips.passes();
  if (samples.empty() && pointed.empty()) return {};
  std::vector<std::vector<ContactSample>> met_by_tips(pointed.size());
  parallelFor(std::size_t{0}, pointed.size(), [&](std::size_t i) {
    if (!progress.cancelled()) tips.follow(pointed[i], met_by_tips[i]);
  });
  for (const auto& list : met_by_tips) samples.insert(samples.end(), list.begin(), list.end());
  std::sort(samples.begin(), samples.end(), [](const ContactSample& a, const ContactSample& b) {
    if (a.pass != b.pass) return a.pass < b.pass;
    return a.depth != b.depth ? a.depth > b.depth : isPlaceBefore(a.where, b.where);
  });
  std::vector<Met> met = groups(scene, samples);
  const int effort =
      static_cast<int>(std::min(kAllDepths / std::max<std::size_t>(1, met.size()), kMostDepths));
  parallelFor(std::size_t{0}, met.size(), [&](std::size_t i) {
    if (!progress.cancelled()) measure(scene, effort, met[i]);
  });
  std::vector<Contact> contacts;
  for (const Met& m : met) {
    PROVEOUT_ASSERT(m.contact.motion <= m.contact.last);
    if (m.contact.depth_mm > kContactToleranceMm) contacts.push_back(m.contact);
  }
  return contacts;
}

}  // namespace proveout
