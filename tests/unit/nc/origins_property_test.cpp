// For random programs: the word of an axis is the last one with its letter that was executed.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "origin_run.h"

namespace proveout {
namespace {

using test::OriginRun;

/// A line of a program as the generator knows it.
struct Line {
  std::array<double, 3> value{};
  std::array<bool, 3> has{};
  bool incremental = false;
  int calls = 0, times = 0;    ///< number of a subprogram; 0: none
  int loop = 0, to_line = -1;  ///< a loop that begins here: rounds, and index of its last line
};
using Program = std::vector<Line>;

/// What was executed when a motion was made.
struct Executed {
  std::uint32_t program, line;
  std::array<std::pair<std::uint32_t, std::uint32_t>, 3> last;  ///< of X, Y, Z: program and line; 0: none
  bool moves;
};

class Generator {
 public:
  Generator(unsigned seed, bool wl4) : random_(seed), wl4_(wl4) {}

  std::vector<Program> programs() {
    std::vector<Program> all(3);
    for (std::size_t k = 0; k < all.size(); ++k) {
      for (int n = 12 + below(25); n > 0; --n) all[k].push_back(line(static_cast<int>(k)));
      if (!wl4_ && all[k].size() > 8 && below(2) == 0) addLoop(all[k]);
    }
    return all;
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  Line line(int program) {
    Line made;
    if (program < 2 && below(8) == 0) {
      made.calls = program + 1 + below(2 - program);
      made.times = 1 + below(3);
      return made;
    }
    made.incremental = below(4) == 0;
    const int first = below(3);
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>((first + k) % 3);
      if (k > 0 && below(3) != 0) continue;
      made.has[axis] = true;
      made.value[axis] = made.incremental ? below(100) * 0.125 - 6.0 : below(2000) * 0.125 - 100.0;
    }
    return made;
  }

  void addLoop(Program& program) {
    const int from = 1 + below(static_cast<int>(program.size()) - 4);
    program[static_cast<std::size_t>(from)].loop = 2 + below(3);
    program[static_cast<std::size_t>(from)].to_line = from + 1 + below(3);
  }

  std::mt19937 random_;
  bool wl4_;
};

/// Writes programs and executes them at the same time by itself.
class Model {
 public:
  Model(const std::vector<Program>& programs, bool wl4) : programs_(programs), wl4_(wl4) {
    for (std::size_t k = 0; k < programs.size(); ++k) texts.push_back(write(k));
    if (wl4_) {
      for (std::size_t k = 1; k < programs.size(); ++k) first_line_.push_back(lineCount(texts, k));
    }
    run(0);
  }

  std::vector<std::string> texts;
  std::vector<Executed> executed;

  std::string wholeText() const {
    std::string all;
    for (const std::string& text : texts) all += text;
    return all;
  }

 private:
  static std::uint32_t lineCount(const std::vector<std::string>& texts, std::size_t before) {
    std::uint32_t lines = 0;
    for (std::size_t k = 0; k < before; ++k)
      lines += static_cast<std::uint32_t>(std::count(texts[k].begin(), texts[k].end(), '\n'));
    return lines;
  }

  std::string write(std::size_t program) {
    std::string text = wl4_ ? fmt::format("%{:02}\n", program + 10) : "";
    if (program == 0) text += "G1 F1000\n";
    lines_.emplace_back();
    std::vector<std::string> ends;
    const Program& lines = programs_[program];
    std::size_t end = lines.size();
    for (std::size_t k = 0; k < lines.size(); ++k) {
      const Line& line = lines[k];
      if (line.loop > 0) {
        text += fmt::format("#{0}=0\nWHILE[#{0}LT{1}]DO{2}\n#{0}=#{0}+1\n", 110 + program, line.loop,
                            program + 1);
        end = static_cast<std::size_t>(line.to_line);
      }
      lines_.back().push_back(static_cast<std::uint32_t>(std::count(text.begin(), text.end(), '\n')) + 1);
      text += wordsOf(line) + "\n";
      if (k == end) text += fmt::format("END{}\n", program + 1);
    }
    text += program == 0 ? "M30\n" : "M99\n";
    return text + (wl4_ ? "%\n" : "");
  }

  std::string wordsOf(const Line& line) const {
    if (line.calls > 0 && wl4_) return fmt::format("L{:02}{:02}", line.calls + 10, line.times);
    if (line.calls > 0) return fmt::format("M98 P{} L{}", line.calls + 10, line.times);
    std::string text = line.incremental ? "G91 " : "G90 ";
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (line.has[axis]) text += fmt::format("{}{:.3f} ", "XYZ"[axis], line.value[axis]);
    }
    return text;
  }

  void run(std::size_t program) {
    const Program& lines = programs_[program];
    std::size_t from = lines.size();
    int rounds = 0;
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (lines[k].loop > 0 && from != k) {
        from = k;
        rounds = lines[k].loop;
      }
      step(program, k);
      if (from < lines.size() && k == static_cast<std::size_t>(lines[from].to_line)) {
        if (--rounds > 0) {
          k = from - 1;
        } else {
          from = lines.size();
        }
      }
    }
  }

  void step(std::size_t program, std::size_t index) {
    const Line& line = programs_[program][index];
    for (int k = 0; k < line.times; ++k) run(static_cast<std::size_t>(line.calls));
    if (line.calls > 0) return;
    const bool in_main = wl4_ || program == 0;
    const std::uint32_t above = wl4_ && program > 0 ? first_line_[program - 1] : 0;
    const std::pair<std::uint32_t, std::uint32_t> here{in_main ? 0u : static_cast<std::uint32_t>(program),
                                                       lines_[program][index] + above};
    bool moves = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!line.has[axis]) continue;
      last_[axis] = here;
      const double to = line.incremental ? at_[axis] + line.value[axis] : line.value[axis];
      moves = moves || std::abs(to - at_[axis]) > 1e-9;
      at_[axis] = to;
    }
    executed.push_back({here.first, here.second, last_, moves});
  }

  const std::vector<Program>& programs_;
  bool wl4_;
  std::vector<std::vector<std::uint32_t>> lines_;  ///< of the text, by program and line
  std::vector<std::uint32_t> first_line_;
  std::array<double, 3> at_{};
  std::array<std::pair<std::uint32_t, std::uint32_t>, 3> last_{};
};

void expectSame(const OriginRun& run, const Model& model, unsigned seed) {
  ASSERT_EQ(run.summary.errors, 0) << seed;
  MotionId m = 0;
  for (const Executed& done : model.executed) {
    if (!done.moves) continue;
    ASSERT_LT(m, run.path.motions.size()) << seed;
    const SourceRef& source = run.path.motions[m].source;
    ASSERT_EQ(source.line, done.line) << seed;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto origin = originOf(run.path, m, static_cast<OriginKind>(axis), run.text());
      if (done.last[axis].second == 0) {
        EXPECT_FALSE(origin) << seed << " motion " << m;
        continue;
      }
      ASSERT_TRUE(origin) << seed << " motion " << m;
      EXPECT_EQ(origin->line, done.last[axis].second) << seed << " motion " << m << " "
                                                      << "XYZ"[axis];
      const std::string file =
          done.last[axis].first == 0 ? "main.nc" : fmt::format("O00{}.nc", done.last[axis].first + 10);
      EXPECT_EQ(run.path.files[origin->file], file) << seed << " motion " << m;
      EXPECT_EQ(origin->text.substr(0, 1), std::string(1, "XYZ"[axis]));
    }
    ++m;
  }
  EXPECT_EQ(m, run.path.motions.size()) << seed;
}

TEST(OriginsProperty, AxesAreThoseOfTheLastWordExecuted) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const std::vector<Program> programs = Generator(seed, false).programs();
    const Model model(programs, false);
    const OriginRun run(model.texts[0], {}, {{"O0011.nc", model.texts[1]}, {"O0012.nc", model.texts[2]}});
    expectSame(run, model, seed);
  }
}

TEST(OriginsProperty, AxesOfWl4AreThoseOfTheLastWordExecuted) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const std::vector<Program> programs = Generator(seed, true).programs();
    const Model model(programs, true);
    const OriginRun run(model.wholeText(), {}, {}, ControlId::kWl4Mill);
    expectSame(run, model, seed);
  }
}

}  // namespace
}  // namespace proveout
