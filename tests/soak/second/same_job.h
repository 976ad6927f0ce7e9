// What two runs of one job, said in two ways, have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/soak/second/plan.h"
#include "tests/soak/second/plan_runner.h"

namespace proveout::soak::second {

/// A job that was run, and its files.
struct Ran {
  Plan plan;
  Files files;
  Result<RunResult> run = Error{};
};

/// What a law says of a job.
struct Answer {
  bool asked = false;  ///< false: the job has nothing of the kind
  std::string broken;  ///< why; empty: it holds
  std::string beyond;  ///< it holds only because `thin_feature` stands there in place of a bound
  std::optional<Ran> other;
};

bool tellsThin(const RunResult& run);
/// By how much volumes may be off, mm3, as the run says: in its figure, and in findings what a grid does not
/// hold.
double toldError(const RunResult& run);
/// Clampings that are to cut something; others are judged by the law of idle clampings.
std::vector<const SetupRun*> atWork(const Ran& job);
double removedIn(const SetupRun& setup);  ///< mm3
double blankOf(const Ran& job);           ///< mm3, as the run has it

/// Puts a difference of volumes, mm3, into the answer: broken where it is beyond what is told and rounding.
void judge(double off, double told, double blank, bool thin, const std::string& what, Answer& answer);
/// The blank, and what each clamping at work removes.
void sameVolumes(const Ran& a, const Ran& b, Answer& answer);
/// The same kinds in the same clampings; contacts by their tools. `depths`: the deepest agree, too.
void sameFindings(const Ran& a, const Ran& b, bool depths, Answer& answer);
/// Of parts with exact sections: each piece has its volume.
void samePieces(const Ran& a, const Ran& b, Answer& answer);

}  // namespace proveout::soak::second
