// Ends loops whose state changes in every round and that yet come no nearer to an end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace proveout::nc {

/// What ends a loop is a condition that has always come out the same way: a loop goes on as long as one of
/// those that it asks comes so much nearer to its other outcome that the loop will be done within its limits.
/// Loops that do little are let be. A call that is repeated is a loop whose condition is the count.
class LoopBudget {
 public:
  struct Work {
    double blocks = 0.0, motions = 0.0;
  };
  /// Where the run is.
  struct Place {
    std::size_t depth = 0;   ///< programs that are open
    std::size_t order = 0;   ///< of the block in the innermost of them
    std::size_t line = 0;    ///< that it stands on, index
    std::uint64_t call = 0;  ///< number of the call that opened it; no two programs open at once share one
    std::int64_t repetition = 0;  ///< of the call, from 0
    std::int64_t repetitions = 1;
  };
  /// A variable or an axis.
  struct Named {
    std::string name;
    double value = 0.0;
  };
  /// All that a loop could change; asked now and then, of short loops never.
  using State = std::function<std::vector<Named>()>;

  /// A loop may execute `block_limit` blocks and make a twentieth of it motions. Of a loop without a sign of
  /// its end a fiftieth of the blocks and a twenty-fifth of the motions are let be, 2,000 at least.
  LoopBudget(std::uint64_t block_limit, State state);

  /// A condition of the program came out as `holds`, and `gap` (above 0; else it tells nothing) away from
  /// the other outcome. `condition`: the same number for the same place in the text.
  void asked(std::uint64_t condition, double gap, bool holds);
  /// The next block is at `at`, `done` so far. True: the program is in a loop that is to be ended;
  /// message() says why.
  bool arrives(const Place& at, const Work& done);
  const std::string& message() const { return message_; }

 private:
  struct Condition {
    std::uint64_t place = 0;
    bool holds = false, both = false;     ///< the outcome; both have been seen
    std::optional<double> least, before;  ///< gap: least so far; the same when it was last looked at
  };
  struct Level {
    Place last;
    bool known = false;
  };
  struct Loop {
    Place at;                        ///< of its head
    bool repeats = false;            ///< a call is repeated; false: jumps back
    Place tail;                      ///< that it comes back from
    double rounds = 0.0;             ///< begun since the first time it came back
    double rounds_before = 0;        ///< when it was last looked at
    Work start, look;                ///< done before it; done in it when it is looked at next
    std::optional<double> promised;  ///< rounds in all, as first foretold
    std::vector<Condition> conditions;
    bool unclear = false;     ///< it asks more than can be kept
    std::vector<Named> seen;  ///< when it was last looked at
  };

  bool hasComeBack(const Place& at, Place& from, bool& repeats);
  Loop& enter(const Place& at, const Place& from, bool repeats, const Work& done);
  static void askCount(Loop& loop, const Place& at);
  bool goesRound(Loop& loop, const Place& at, const Work& done);
  std::string judge(Loop& loop, const Work& spent) const;
  double roundsLeft(const Loop& loop) const;
  double repeatedAround(const Loop& loop) const;
  void lookAgain(Loop& loop, const Work& spent) const;
  std::string nameOf(const Loop& loop) const;
  std::string changes(const Loop& loop) const;

  Work most_, patience_;
  State state_;
  std::vector<Level> levels_;  ///< by depth
  std::vector<Loop> loops_;    ///< outermost first
  std::string message_;
};

/// Of a place in a text that stays where it is.
inline std::uint64_t conditionAt(const char* text) { return reinterpret_cast<std::uintptr_t>(text); }

}  // namespace proveout::nc
