// What could be wrong behind a deviation: words of the program, codes of their group, keys of the job. A
// suspect says how it would be put otherwise; whether that helps is for a trial (trial.h).
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/session/causes/cause_candidates.h"
#include "app/session/causes/trial.h"
#include "io/report.h"

namespace proveout {

struct Suspect {
  Cause cause;      ///< what and where; `along` and `off_mm` where the deviations say so
  std::string key;  ///< equal for all that put the same thing otherwise
  int rank = 0;     ///< of suspects that explain as much, the lower is told first
  std::uint32_t setup = 0;

  /// A number: its value, what to add to it first, and the trial with another value. Null function: it is no
  /// number.
  double value = 0.0, first_step = 0.0;
  double least = -std::numeric_limits<double>::infinity(),
         most = std::numeric_limits<double>::infinity();  ///< of it
  std::vector<double> usual;                              ///< values that it often should have, tried first
  int decimals = 3;                                       ///< that it is written with at most
  double per_mm = 1.0;  ///< by how much it changes where the cut moves by 1 mm, about; for rounding
  std::function<std::optional<Trial>(double value)> put;
  std::function<std::string(double value)> text;  ///< "Z-4", "offsets.radius.1 = 5"

  /// T, or D or H with the number of the tool, as people write them: data are likelier wrong than the word.
  bool conventional = false;
  /// Else others of its kind.
  struct Other {
    std::string text;
    Trial trial;
  };
  std::vector<Other> others;
};

/// What a suspect is looked for with.
struct SuspectScene {
  const Job& job;
  const RunResult& run;
  const RunSources& sources;
};

/// A word of a clamping's program as a suspect; none where its text is no plain number or code.
std::optional<Suspect> suspectWord(const SuspectScene& scene, std::uint32_t setup, const ResolvedOrigin& word,
                                   double off_mm);
/// A datum of the job by its key ("offsets.radius.1", "tools.2.diameter").
std::optional<Suspect> suspectDatum(const SuspectScene& scene, std::uint32_t setup, const std::string& key,
                                    double off_mm);
/// All of a motion: its words in force, counts of repeats, the keys of its tool, offsets, and the clamping's
/// move. `depth_mm`: of the deviation.
std::vector<Suspect> suspectsOf(const SuspectScene& scene, std::uint32_t setup, MotionId motion,
                                double depth_mm);

}  // namespace proveout
