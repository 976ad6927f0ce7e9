#include "tests/soak/second/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <utility>

#include "tests/soak/second/moved.h"

namespace proveout::soak::second {
namespace {

double holesOf(const Plan& plan) {
  double sum = 0;
  for (const StartHole& hole : plan.start_holes)
    sum += 0.25 * std::numbers::pi * hole.diameter * hole.diameter * plan.blank.bounds().sizes().z();
  return sum;
}

/// What a wire cuts behind another clamping is on a grid, too.
bool cutsWithoutGrid(const Plan& plan) {
  const std::vector<Clamping>& all = plan.clampings;
  if (all.size() == 1) return !mills(all.front().control);
  return std::all_of(all.begin(), all.end(), [](const Clamping& c) { return turns(c.control); });
}

/// Runs the other job and compares it.
Answer compared(const Ran& job, const Plan& plan, bool depths) {
  Answer answer;
  answer.asked = true;
  answer.other = runPlan(plan);
  if (!answer.other->run) {
    answer.broken = "the other job is refused: " + answer.other->run.error().message;
    return answer;
  }
  sameVolumes(job, *answer.other, answer);
  sameFindings(job, *answer.other, depths, answer);
  if (cutsWithoutGrid(plan)) samePieces(job, *answer.other, answer);
  return answer;
}

std::size_t anyClamping(const Plan& plan, Dice& dice) {
  return static_cast<std::size_t>(dice.below(static_cast<int>(plan.clampings.size())));
}

Answer turned(const Ran& job, Dice& dice) {
  const std::size_t k = anyClamping(job.plan, dice);
  if (turns(job.plan.clampings[k].control)) return {};
  return compared(job, moved(job.plan, k, turnedBy(0, dice.of({90, 180, 270}))), true);
}

Answer turnedFreely(const Ran& job, Dice& dice) {
  if (!canTurnFreely(job.plan)) return {};
  return compared(job, moved(job.plan, 0, turnedBy(0, dice.of({33.7, 45.0, -12.3, 128.9}))), true);
}

Answer seenInAMirror(const Ran& job, Dice& /*dice*/) {
  if (job.plan.clampings.size() > 1 || turns(job.plan.clampings.front().control)) return {};
  return compared(job, mirrored(job.plan), true);
}

Answer shifted(const Ran& job, Dice& dice) {
  const std::size_t k = anyClamping(job.plan, dice);
  Move move;
  for (int axis = 0; axis < 3; ++axis) move.shift[axis] = dice.mm(-9, 9);
  if (turns(job.plan.clampings[k].control)) move.shift.head<2>().setZero();
  return compared(job, moved(job.plan, k, move), true);
}

Answer parted(const Ran& job, Dice& /*dice*/) {
  Answer answer = compared(job, split(job.plan), false);
  // What the motion that frees a slug does behind that moment is not held against the slug; another's is.
  const bool freed = answer.broken.starts_with("free_slug");
  // A control refuses elements of a contour that are shorter than their offset.
  const bool overcut = answer.broken.find("alarm: overcut") != std::string::npos;
  if (freed || overcut) answer.beyond = std::exchange(answer.broken, {});
  return answer;
}

void idleRemovesNothing(const Ran& other, Answer& answer) {
  for (std::size_t k = 0; k < other.run->setups.size() && k < other.plan.clampings.size(); ++k) {
    const SetupRun& setup = other.run->setups[k];
    if (other.plan.clampings[k].idle && removedIn(setup) != 0)
      answer.broken = fmt::format("clamping {} cuts nothing and removes {:.6g} mm3", k + 1, removedIn(setup));
  }
}

/// A control that can have a clamping there.
Control idleControl(const Plan& plan, std::size_t k, Dice& dice) {
  if (k == 0 && !plan.start_holes.empty()) return Control::kWedm;
  const bool before_lathe = k < plan.clampings.size() && turns(plan.clampings[k].control);
  if (before_lathe) return dice.of({Control::kWl4Lathe, Control::kFlexnc});
  const bool behind_lathe = k > 0 && turns(plan.clampings[k - 1].control);
  if (behind_lathe && dice.oneIn(3)) return dice.of({Control::kWl4Lathe, Control::kFlexnc});
  if (k == 0 && plan.blank.shape == Solid::Shape::kMesh) return Control::kNct;
  return dice.of({Control::kNct, Control::kWl4Mill, Control::kWedm});
}

Answer idle(const Ran& job, Dice& dice) {
  const std::size_t k = static_cast<std::size_t>(dice.below(static_cast<int>(job.plan.clampings.size()) + 1));
  if (k > 0 && job.run->setups.size() < k) return {};
  const Control control = idleControl(job.plan, k, dice);
  // Moves that are not exact build the stock anew: what is cut behind them is another law's.
  const bool last = k == job.plan.clampings.size();
  Move move = turns(control)
                  ? Move{}
                  : turnedBy(dice.of({0.0, 90.0, 180.0}), dice.of({0.0, 90.0, last ? 33.7 : 180.0}));
  move.shift = {0, 0, dice.mm(-5, 5)};
  Answer answer = compared(job, withIdle(job.plan, k, control, move, dice), true);
  if (answer.other->run) idleRemovesNothing(*answer.other, answer);
  return answer;
}

/// A job in two; the second one begins with what the first one leaves.
struct Halves {
  Plan first, second;
};

/// Parted where a tool changes.
std::optional<Halves> atAToolChange(const Plan& plan) {
  Halves halves{plan, plan};
  std::vector<Step>& steps = halves.second.clampings[0].steps;
  const auto begins = [](const Step& s) { return s.kind == Step::Kind::kTool; };
  const auto change = std::find_if(steps.begin() + 1, steps.end(), begins);
  if (!mills(plan.clampings[0].control) || change == steps.end()) return std::nullopt;
  halves.first.clampings[0].steps.assign(steps.begin(), change);
  steps.erase(steps.begin(), change);
  return halves;
}

/// Parted between two clampings. The saved stock is as the first one left it: the move stands behind a
/// clamping that cuts nothing.
std::optional<Halves> betweenClampings(const Plan& plan, Dice& dice) {
  if (plan.clampings[0].control == Control::kWedm || !mills(plan.clampings[1].control)) return std::nullopt;
  Halves halves{plan, plan};
  halves.first.clampings.resize(1);
  Plan& second = halves.second;
  second.clampings.erase(second.clampings.begin());
  const Move move = second.clampings[0].move;
  second.clampings[0].move = {};
  second = withIdle(second, 0, Control::kNct, {}, dice);
  second.clampings[1].move = move;
  return halves;
}

/// What is left but for pieces that a lathe has cut off: those are not saved, and not clamped again.
double partOf(const SetupRun& setup) {
  double part = setup.surface.volume_mm3;
  if (setup.form->profile() != nullptr)
    for (const StockBody& body : setup.bodies) part -= body.role == "part" ? 0 : body.volume_mm3;
  return part;
}

double removedBy(const Ran& job) {
  double sum = 0;
  for (const SetupRun* setup : atWork(job)) sum += removedIn(*setup);
  return sum;
}

void sameInHalves(const Ran& job, const Ran& first, const Ran& second, Answer& answer) {
  const bool thin = tellsThin(*first.run) || tellsThin(*second.run) || tellsThin(*job.run);
  const double told = toldError(*first.run) + toldError(*second.run) + toldError(*job.run),
               blank = blankOf(job);
  judge(removedBy(first) + removedBy(second) - removedBy(job), told, blank, thin, "what both halves remove",
        answer);
  judge(partOf(first.run->setups.back()) - blankOf(second), told, blank, thin,
        "what was saved and what was read", answer);
}

/// In two jobs, the stock saved between them.
Answer saved(const Ran& job, Dice& dice) {
  const std::size_t clampings = job.plan.clampings.size();
  auto halves = clampings > 1 ? betweenClampings(job.plan, dice) : atAToolChange(job.plan);
  if (!halves || job.run->setups.size() != clampings) return {};
  halves->first.keeps_stock = true;
  halves->second.stock_file = "before.vdb";
  halves->second.start_holes.clear();
  Answer answer;
  answer.asked = true;
  const test::Workbench folder;
  Ran first{halves->first, filesOf(halves->first)}, second{halves->second, filesOf(halves->second)};
  first.run = runFolder(folder, first.files, folder.path("before.vdb"));
  if (first.run) second.run = runFolder(folder, second.files);
  if (!first.run || !second.run) {
    answer.broken = "a half is refused: " + (first.run ? second : first).run.error().message;
  } else {
    sameInHalves(job, first, second, answer);
  }
  for (const auto& [name, text] : first.files) second.files["before/" + name] = text;
  answer.other = std::move(second);
  return answer;
}

Answer halfTheGrid(const Ran& job, Dice& /*dice*/) { return compared(job, finer(job.plan), false); }

void pieceSums(const Ran& job, Answer& answer) {
  const double blank = blankOf(job), told = toldError(*job.run);
  const bool thin = tellsThin(*job.run);
  for (const SetupRun& setup : job.run->setups) {
    double motions = 0, bodies = 0;
    for (const float volume : setup.removal.removed_mm3) motions += static_cast<double>(volume);
    for (const StockBody& body : setup.bodies) bodies += body.volume_mm3;
    if (removedIn(setup) < 0) answer.broken = fmt::format("{:.6g} mm3 are removed", removedIn(setup));
    if (!setup.bodies.empty())
      judge(bodies - setup.surface.volume_mm3, told, blank, thin, "the sum of the pieces and what is left",
            answer);
    judge(motions - removedIn(setup), told + 1e-5 * blank, blank, thin,
          "the sum of the motions and what is removed", answer);
  }
}

/// What is removed and what is left is the blank, whose volume is known in closed form.
Answer balance(const Ran& job, Dice& /*dice*/) {
  Answer answer;
  answer.asked = true;
  const double blank = job.plan.blank.volume() - holesOf(job.plan);
  judge(blank - blankOf(job), 0, blank, tellsThin(*job.run), "the blank", answer);
  double sum = job.run->setups.back().surface.volume_mm3;
  for (const SetupRun& setup : job.run->setups) sum += removedIn(setup);
  judge(sum - blankOf(job), 0, blankOf(job), false, "what is removed and left, and the blank,", answer);
  pieceSums(job, answer);
  return answer;
}

}  // namespace

Ran runPlan(const Plan& plan) {
  Ran ran{plan, filesOf(plan)};
  const test::Workbench folder;
  ran.run = runFolder(folder, ran.files);
  return ran;
}

const std::vector<Relation>& relations() {
  static const std::vector<Relation> kRelations = {
      {"turned", "turned by quarters about Z, volumes, kinds and depths are the same", turned},
      {"turned freely", "the same by any angle, where the blank is a mesh or stands upright", turnedFreely},
      {"mirrored", "the same for x for -x", seenInAMirror},
      {"shifted", "the same by any shift", shifted},
      {"split", "motions parted in two take the same volumes and leave the same pieces", parted},
      {"idle", "a clamping that cuts nothing removes 0, and what is cut beside it stays", idle},
      {"saved", "a job that goes on from a saved stock removes what it does in one", saved},
      {"half the grid", "half the grid and half the facets change volumes by what is told", halfTheGrid},
      {"balance", "what is removed and left is the blank, and the sum of pieces and motions", balance},
  };
  return kRelations;
}

}  // namespace proveout::soak::second
