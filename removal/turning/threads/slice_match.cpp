#include "removal/turning/threads/slice_match.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "core/geometry/plane.h"

namespace proveout::thread_detail {

namespace {

struct Named {
  EdgeName in, out;
  std::size_t loop, corner;
  auto key() const { return std::tie(in, out); }
};

EdgeName shifted(EdgeName name, std::int32_t turns) {
  if (name.sweep != EdgeName::kSection) name.turn += turns;
  return name;
}

std::vector<Named> byName(const Slice& slice) {
  std::vector<Named> all;
  for (std::size_t l = 0; l < slice.loops.size(); ++l) {
    for (std::size_t i = 0; i < slice.loops[l].size(); ++i)
      all.push_back({slice.loops[l][i].in, slice.loops[l][i].out, l, i});
  }
  std::sort(all.begin(), all.end(), [](const Named& a, const Named& b) {
    return std::tie(a.in, a.out, a.loop, a.corner) < std::tie(b.in, b.out, b.loop, b.corner);
  });
  return all;
}

/// For each corner of each loop of `a` the one of the same name in `b`, the nearest of several.
using Partner = std::pair<std::size_t, std::size_t>;  // loop, corner
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::vector<std::vector<Partner>> partners(const Slice& a, const Slice& b, std::int32_t turns) {
  const std::vector<Named> named = byName(b);
  std::vector<std::vector<Partner>> out;
  for (const CornerLoop& loop : a.loops) {
    std::vector<Partner>& of = out.emplace_back();
    for (const Corner& corner : loop) {
      const Named wanted{shifted(corner.in, turns), shifted(corner.out, turns), 0, 0};
      const auto [first, last] =
          std::equal_range(named.begin(), named.end(), wanted,
                           [](const Named& x, const Named& y) { return x.key() < y.key(); });
      Partner best{kNone, kNone};
      double least = std::numeric_limits<double>::infinity();
      for (auto it = first; it != last; ++it) {
        const double distance = (b.loops[it->loop][it->corner].at - corner.at).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = {it->loop, it->corner};
      }
      of.push_back(best);
    }
  }
  return out;
}

/// The loop of `b` that most corners of a loop of `a` are found in.
std::size_t partnerLoop(const std::vector<Partner>& of, std::size_t loops) {
  std::vector<std::size_t> votes(loops);
  for (const Partner& p : of) {
    if (p.first != kNone) ++votes[p.first];
  }
  const auto most = std::max_element(votes.begin(), votes.end());
  return most == votes.end() || *most == 0 ? kNone : static_cast<std::size_t>(most - votes.begin());
}

/// The longest run of pairs whose second numbers rise, as seen from the first pair on round the loop of n.
void keepOrdered(std::vector<std::pair<std::size_t, std::size_t>>& pairs, std::size_t n) {
  if (pairs.size() < 2) return;
  // A pair whose follower comes next in both loops is surely right.
  std::size_t anchor = 0;
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
    if (pairs[k + 1].first != pairs[k].first + 1 || pairs[k + 1].second != (pairs[k].second + 1) % n)
      continue;
    anchor = k;
    break;
  }
  std::rotate(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(anchor), pairs.end());
  const std::size_t base = pairs.front().second;
  const auto order = [&](std::size_t k) { return (pairs[k].second + n - base) % n; };
  std::vector<std::size_t> tail, before(pairs.size(), kNone);  // of the best run of each length its last pair
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto place = std::lower_bound(tail.begin(), tail.end(), order(k),
                                        [&](std::size_t t, std::size_t value) { return order(t) < value; });
    if (place != tail.begin()) before[k] = *(place - 1);
    if (place == tail.end())
      tail.push_back(k);
    else
      *place = k;
  }
  std::vector<std::pair<std::size_t, std::size_t>> kept;
  for (std::size_t k = tail.back(); k != kNone; k = before[k]) kept.push_back(pairs[k]);
  std::reverse(kept.begin(), kept.end());
  pairs = std::move(kept);
}

}  // namespace

std::optional<std::vector<LoopMatch>> matchSlices(const Slice& a, const Slice& b, std::int32_t turns) {
  if (a.loops.size() != b.loops.size() || !a.sound || !b.sound) return std::nullopt;
  const std::vector<std::vector<Partner>> of = partners(a, b, turns);
  std::vector<LoopMatch> matches;
  std::vector<bool> taken(b.loops.size());
  for (std::size_t l = 0; l < a.loops.size(); ++l) {
    const std::size_t other = partnerLoop(of[l], b.loops.size());
    if (other == kNone || taken[other]) return std::nullopt;
    taken[other] = true;
    LoopMatch match{l, other, {}};
    for (std::size_t i = 0; i < of[l].size(); ++i) {
      if (of[l][i].first == other) match.corners.emplace_back(i, of[l][i].second);
    }
    keepOrdered(match.corners, b.loops[other].size());
    if (match.corners.size() < 2) return std::nullopt;
    matches.push_back(std::move(match));
  }
  return matches;
}

namespace {

/// Distance of the inner corners of one stretch from the other.
double off(const CornerLoop& a, std::size_t a0, std::size_t a1, const CornerLoop& b, std::size_t b0,
           std::size_t b1) {
  double most = 0.0;
  for (std::size_t i = (a0 + 1) % a.size(); i != a1; i = (i + 1) % a.size()) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = b0; k != b1; k = (k + 1) % b.size())
      least = std::min(least, distanceToSegment(a[i].at, b[k].at, b[(k + 1) % b.size()].at));
    most = std::max(most, least);
  }
  return most;
}

}  // namespace

Stretch::Stretch(const CornerLoop& loop, std::size_t first, std::size_t last) {
  for (std::size_t i = first;; i = (i + 1) % loop.size()) {
    const double step = corners.empty() ? 0.0 : (loop[i].at - corners.back()->at).norm();
    along.push_back(along.empty() ? 0.0 : along.back() + step);
    corners.push_back(&loop[i]);
    if (i == last) break;
  }
  for (double& a : along) a /= std::max(along.back(), 1e-12);
  along.back() = 1.0;
}

namespace {

/// Whether both loops go straight from one common corner to the next.
bool joined(const CornerLoop& a, const CornerLoop& b, const std::pair<std::size_t, std::size_t>& from,
            const std::pair<std::size_t, std::size_t>& to) {
  return (from.first + 1) % a.size() == to.first && (from.second + 1) % b.size() == to.second;
}

double distanceTo(const std::vector<Vec2>& chain, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    least = std::min(least, distanceToSegment(p, chain[i], chain[i + 1]));
  return least;
}

/// The largest distance of the corners of each chain from the other.
double apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0.0;
  for (const Vec2& p : a) most = std::max(most, distanceTo(b, p));
  for (const Vec2& p : b) most = std::max(most, distanceTo(a, p));
  return most;
}

/// Where the triangles between two stretches are half way.
std::vector<Vec2> halfWay(const Stretch& a, const Stretch& b) {
  const auto half = [&](std::size_t i, std::size_t j) {
    return Vec2(0.5 * (a.corners[i]->at + b.corners[j]->at));
  };
  std::vector<Vec2> chain{half(0, 0)};
  zigzag(
      a, b, [](std::size_t, std::size_t) { return true; },
      [&](std::size_t i, std::size_t j, bool of_b) {
        chain.push_back(of_b ? half(i, j + 1) : half(i + 1, j));
      });
  return chain;
}

}  // namespace

double offMiddle(const Slice& a, const Slice& b, const std::vector<LoopMatch>& matches, const Slice& middle,
                 std::int32_t turns) {
  constexpr double kUnknown = std::numeric_limits<double>::infinity();
  const auto to_middle = matchSlices(a, middle, turns);
  if (!to_middle) return kUnknown;
  double most = 0.0;
  for (std::size_t l = 0; l < matches.size(); ++l) {  // both have the loops of `a` in their order
    const LoopMatch &match = matches[l], &known = (*to_middle)[l];
    const CornerLoop &la = a.loops[match.a], &lb = b.loops[match.b], &lm = middle.loops[known.b];
    std::vector<std::size_t> in_middle(la.size(), kNone);
    for (const auto& [corner, other] : known.corners) in_middle[corner] = other;
    const std::size_t n = match.corners.size();
    for (std::size_t k = 0; k < n; ++k) {
      const auto &from = match.corners[k], &to = match.corners[(k + 1) % n];
      if (joined(la, lb, from, to)) continue;
      const std::size_t m0 = in_middle[from.first], m1 = in_middle[to.first];
      if (m0 == kNone || m1 == kNone) return kUnknown;
      const Stretch exact(lm, m0, m1);
      std::vector<Vec2> chain;
      for (const Corner* corner : exact.corners) chain.push_back(corner->at);
      most = std::max(most, apart(halfWay({la, from.first, to.first}, {lb, from.second, to.second}), chain));
    }
  }
  return most;
}

double thickness(const CornerLoop& a, const CornerLoop& b, const LoopMatch& match) {
  double most = 0.0;
  const std::size_t n = match.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto &from = match.corners[k], &to = match.corners[(k + 1) % n];
    if (joined(a, b, from, to)) continue;
    const Stretch sa(a, from.first, to.first), sb(b, from.second, to.second);
    double area = 0.0, around = 0.0;
    zigzag(
        sa, sb, [](std::size_t, std::size_t) { return true; },
        [&](std::size_t i, std::size_t j, bool of_b) {
          const Vec2 &p = sa.corners[i]->at, &q = sb.corners[j]->at,
                     &next = of_b ? sb.corners[j + 1]->at : sa.corners[i + 1]->at;
          area += 0.5 * std::abs((q - p).x() * (next - p).y() - (q - p).y() * (next - p).x());
          around += (next - (of_b ? q : p)).norm();
        });
    most = std::max(most, 2.0 * area / std::max(around, 1e-12));
  }
  return most;
}

double mismatch(const CornerLoop& a, const CornerLoop& b, const LoopMatch& match) {
  double most = 0.0;
  const std::size_t n = match.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const auto &from = match.corners[k], &to = match.corners[(k + 1) % n];
    if (joined(a, b, from, to)) continue;
    most = std::max({most, off(a, from.first, to.first, b, from.second, to.second),
                     off(b, from.second, to.second, a, from.first, to.first)});
  }
  return most;
}

}  // namespace proveout::thread_detail
