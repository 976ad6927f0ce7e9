#include "tests/soak/second/same_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace proveout::soak::second {
namespace {

/// Rounding of a program's numbers and of sums, by the blank's volume; and of sections, whose points are
/// whole nanometres, by the walls that a blank may have.
constexpr double kRounding = 2e-7, kWallRounding_mm = 2e-6;
/// Where `thin_feature` stands in place of a bound: by the blank's volume. And what integrals over a grid are
/// good to.
constexpr double kEstimate = 0.02, kOfGrid = 1e-5;
/// Two depths of one contact, mm: what the key `contact` leaves untold.
constexpr double kDepth = 0.01;

const char* kindName(FindingKind kind) { return findingKindInfo(kind).name.data(); }

bool isContact(FindingKind kind) {
  constexpr FindingKind kContacts[] = {FindingKind::kRapidContact,  FindingKind::kShankContact,
                                       FindingKind::kHolderContact, FindingKind::kFixtureContact,
                                       FindingKind::kInsertContact, FindingKind::kCutOffPiece};
  return std::find(std::begin(kContacts), std::end(kContacts), kind) != std::end(kContacts);
}

/// Kinds that are told of the way in which a job is said, or of the grid.
bool isOfTheWay(FindingKind kind) {
  constexpr FindingKind kOthers[] = {FindingKind::kThinFeature, FindingKind::kNothingCut,
                                     FindingKind::kCycleTime, FindingKind::kMesh};
  return std::find(std::begin(kOthers), std::end(kOthers), kind) != std::end(kOthers);
}

/// What rounding may move: a cube has the least walls.
double rounding(double blank) {
  return kRounding * blank + kWallRounding_mm * 8 * std::pow(blank, 2.0 / 3.0);
}

/// Of all contacts of one kind, clamping and tool the largest depth and the largest volume.
struct DeepestContact {
  double depth_mm = 0, volume_mm3 = 0;
};
using Contacts = std::map<std::string, DeepestContact>;
struct Told {
  Contacts contacts;
  std::set<std::string> kinds;
};

/// The number of a clamping among those at work.
std::string workName(const Ran& job, const std::string& setup) {
  if (setup.empty()) return "1";
  int number = 0;
  for (std::size_t k = 0; k < job.run->setups.size(); ++k) {
    if (k < job.plan.clampings.size() && !job.plan.clampings[k].idle) ++number;
    if (job.run->setups[k].name == setup) break;
  }
  return fmt::format("{}", number);
}

Told toldBy(const Ran& job) {
  Told told;
  for (const Finding& f : job.run->findings) {
    if (isOfTheWay(f.kind)) continue;
    const std::string name = fmt::format("{} in clamping {}", kindName(f.kind), workName(job, f.setup));
    if (!isContact(f.kind) || !f.depth_mm) {
      told.kinds.insert(name);
      continue;
    }
    DeepestContact& deepest = told.contacts[name + (f.tool ? fmt::format(" by T{}", *f.tool) : "")];
    deepest.depth_mm = std::max(deepest.depth_mm, *f.depth_mm);
    deepest.volume_mm3 = std::max(deepest.volume_mm3, f.volume_mm3.value_or(0));
  }
  return told;
}

/// `depths`: those of contacts have to agree, not only that they are told. `unheld_mm3`: so much of the
/// material may be too thin for the grids, and what touches that is not looked for.
void sameContacts(const Contacts& a, const Contacts& b, bool depths, double unheld_mm3, Answer& answer) {
  for (const auto& [name, deepest] : a) {
    const auto other = b.find(name);
    const double depth = deepest.depth_mm, there = other == b.end() ? 0.0 : other->second.depth_mm;
    std::string differs;
    if (other == b.end()) {
      if (depth > 2 * kDepth)
        differs = fmt::format("{} of {:.4f} mm is told in one of both only", name, depth);
    } else if (depths && depth - there > kDepth) {
      differs = fmt::format("{} is {:.4f} or {:.4f} mm deep", name, depth, there);
    }
    if (!differs.empty()) (deepest.volume_mm3 <= unheld_mm3 ? answer.beyond : answer.broken) = differs;
  }
}

double ofGrid(double blank) { return kOfGrid * blank; }
double looseOf(const SetupRun& setup) {
  double sum = 0;
  for (std::size_t k = 1; k < setup.bodies.size(); ++k) sum += setup.bodies[k].volume_mm3;
  return sum;
}
bool isOnGrid(const Ran& job) {
  return std::any_of(job.run->setups.begin(), job.run->setups.end(), [](const SetupRun& setup) {
    return setup.form->profile() == nullptr && setup.facet_error_mm == 0.0;
  });
}

}  // namespace

bool tellsThin(const RunResult& run) {
  return std::any_of(run.findings.begin(), run.findings.end(),
                     [](const Finding& f) { return f.kind == FindingKind::kThinFeature; });
}

double toldError(const RunResult& run) {
  double sum = run.setups.front().initial_error_mm3;
  for (const SetupRun& setup : run.setups) sum += setup.surface.volume_error_mm3;
  for (const Finding& f : run.findings)
    if (f.kind == FindingKind::kThinFeature) sum += f.volume_mm3.value_or(0);
  return sum;
}

std::vector<const SetupRun*> atWork(const Ran& job) {
  std::vector<const SetupRun*> out;
  for (std::size_t k = 0; k < job.run->setups.size() && k < job.plan.clampings.size(); ++k)
    if (!job.plan.clampings[k].idle) out.push_back(&job.run->setups[k]);
  return out;
}

double removedIn(const SetupRun& setup) { return setup.initial_mm3 - setup.surface.volume_mm3; }
double blankOf(const Ran& job) { return job.run->setups.front().initial_mm3; }

void judge(double off, double told, double blank, bool thin, const std::string& what, Answer& answer) {
  if (std::abs(off) <= told + rounding(blank)) return;
  const std::string text = fmt::format("{} differs by {:.6g} of {:.6g} mm3, told {:.3g}{}", what,
                                       std::abs(off), blank, told, thin ? ", thin_feature" : "");
  if (thin && std::abs(off) <= kEstimate * blank) {
    answer.beyond = text;
  } else if (answer.broken.empty()) {
    answer.broken = text;
  }
}

void sameVolumes(const Ran& a, const Ran& b, Answer& answer) {
  const bool thin = tellsThin(*a.run) || tellsThin(*b.run);
  const double blank = blankOf(a),
               told = toldError(*a.run) + toldError(*b.run) + (isOnGrid(a) ? ofGrid(blank) : 0.0);
  judge(blank - blankOf(b), ofGrid(blank), blank, thin, "the blank", answer);
  const auto one = atWork(a), two = atWork(b);
  double sum = 0, loose = 0;
  for (std::size_t k = 0; k < std::min(one.size(), two.size()); ++k) {
    const double off = removedIn(*one[k]) - removedIn(*two[k]);
    // What hangs on by less than the grid holds is loose in one of both, and not clamped again.
    if (thin && k > 0) loose += std::abs(looseOf(*one[k - 1]) - looseOf(*two[k - 1]));
    judge(off, told + loose, blank, thin, fmt::format("what clamping {} removes", k + 1), answer);
    sum += off;
  }
  // A clamping behind one that leaves nothing is not run.
  if (one.size() == two.size()) judge(sum, told + loose, blank, thin, "what is removed", answer);
}

void sameFindings(const Ran& a, const Ran& b, bool depths, Answer& answer) {
  if (!answer.broken.empty()) return;
  const bool thin = tellsThin(*a.run) || tellsThin(*b.run);
  const Told one = toldBy(a), two = toldBy(b);
  const double unheld = thin ? toldError(*a.run) + toldError(*b.run) : 0.0;
  sameContacts(one.contacts, two.contacts, depths, unheld, answer);
  sameContacts(two.contacts, one.contacts, depths, unheld, answer);
  std::vector<std::string> differ;
  std::set_symmetric_difference(one.kinds.begin(), one.kinds.end(), two.kinds.begin(), two.kinds.end(),
                                std::back_inserter(differ));
  for (const std::string& name : differ) {
    (thin ? answer.beyond : answer.broken) =
        name + " is told in one of both only" + (thin ? ", thin_feature" : "");
  }
}

void samePieces(const Ran& a, const Ran& b, Answer& answer) {
  // What is loose stays behind when the part is clamped again.
  if (!answer.broken.empty() || a.run->setups.size() != a.plan.clampings.size() ||
      b.plan.clampings.back().idle)
    return;
  std::vector<double> one, two;
  for (const StockBody& body : a.run->setups.back().bodies) one.push_back(body.volume_mm3);
  for (const StockBody& body : b.run->setups.back().bodies) two.push_back(body.volume_mm3);
  std::sort(one.rbegin(), one.rend());
  std::sort(two.rbegin(), two.rend());
  if (one.size() != two.size()) {
    answer.broken = fmt::format("{} or {} pieces are left", one.size(), two.size());
    return;
  }
  const double told = toldError(*a.run) + toldError(*b.run);
  for (std::size_t i = 0; i < one.size(); ++i)
    judge(one[i] - two[i], told, blankOf(a), false, fmt::format("piece {}", i + 1), answer);
}

}  // namespace proveout::soak::second
