// Which DO belongs to which END, found once for a program text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Length of WHILE, or of the WH[...] of some controls, at text[pos]; 0: it is neither.
std::size_t whileLength(std::string_view text, std::size_t pos);

/// Pairs of DO (also behind WHILE) and END by line. Pairs are found by nesting, as the text stands: where a
/// jump enters a loop, its END still knows its DO (manual 23.2.11).
class LoopIndex {
 public:
  enum class Fault : std::uint8_t {
    kNone,
    kDoubled,  ///< DOm inside DOm
    kNoEnd,    ///< DOm without an ENDm that fits
    kNoDo      ///< ENDm without a DOm that fits
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Mark {
    std::size_t line = 0;     ///< index
    std::size_t partner = 0;  ///< index of the line of the END or the DO
    int number = 0;           ///< m
    bool is_end = false;
    Fault fault = Fault::kNone;
    std::size_t outer = kNone;  ///< index of the DO around it
  };

  /// `comments_end_in_line`: a comment that nobody closes ends with its line.
  explicit LoopIndex(const std::vector<std::string_view>& lines, bool comments_end_in_line = false);
  /// The DO or END of a line, or null.
  const Mark* find(std::size_t line) const;
  /// The outermost loop that a jump from one line to another enters behind its DO, or null.
  const Mark* entered(std::size_t from, std::size_t to) const;

 private:
  void add(std::size_t line, int number, bool is_end);
  std::vector<Mark> marks_;        ///< by line
  std::vector<std::size_t> open_;  ///< marks of DOs whose END is still to come
};

/// Where the loop number stands in "DOm", "ENDm" or "WHILE[...]DOm" at text[pos]; npos: there is no DO.
std::size_t loopNumberAt(std::string_view text, std::size_t pos);
/// A loop number of 1 to 3, or -1.
int loopNumber(std::string_view text, std::size_t pos);

}  // namespace proveout::nc
