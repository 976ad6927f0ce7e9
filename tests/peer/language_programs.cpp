#include "tests/peer/language_programs.h"

#include <fmt/core.h>

#include <random>

namespace proveout::peer {
namespace {

using Text = std::vector<std::string>;

class LanguageWriter {
 public:
  explicit LanguageWriter(std::uint64_t seed) : random_(seed) {}

  Text program() {
    lines_ = {"G21 G90 F100", "G0 X0 Y0 Z0"};
    for (int k = 1; k <= 9; ++k) add(fmt::format("#{} = {}", k, number(-9, 9)));
    for (const char* const name : {"#<a>", "#<_b>", "#<long name>"})
      add(fmt::format("{} = {}", name, number(-9, 9)));
    const int subs = upTo(2);
    for (int k = 0; k < subs; ++k) sub(k);
    defined_ = subs;
    for (int k = 0; k < 12; ++k) statement(0);
    add("M2");
    return lines_;
  }

 private:
  int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < p; }
  std::string number(double low, double high) {
    return fmt::format("{:.{}f}", std::uniform_real_distribution<double>(low, high)(random_), upTo(3));
  }
  std::string one(const Text& of) {
    return of[static_cast<std::size_t>(upTo(static_cast<int>(of.size()) - 1))];
  }
  void add(std::string line) { lines_.push_back(std::move(line)); }

  std::string parameter() {
    return chance(0.7) ? fmt::format("#{}", 1 + upTo(8)) : one({"#<a>", "#<_b>", "#<long name>"});
  }
  std::string value(int depth) {
    if (depth > 2 || chance(0.35)) return chance(0.5) ? number(-9, 9) : parameter();
    switch (upTo(5)) {
      case 0:
        return fmt::format("{}[{}]", one({"ABS", "ROUND", "FIX", "FUP", "SIN", "COS"}), sum(depth + 1));
      case 1:
        return fmt::format("SQRT[ABS[{}]]", sum(depth + 1));
      case 2:
        return fmt::format("ATAN[{}]/[{}]", sum(depth + 1), sum(depth + 1));
      case 3:
        return fmt::format("{}[{}]", one({"ACOS", "ASIN", "EXP", "LN", "TAN"}), number(0, 1));
      default:
        return '[' + sum(depth + 1) + ']';
    }
  }
  std::string sum(int depth) {
    std::string text = value(depth);
    for (int k = upTo(2); k > 0; --k) text += operation(depth);
    return text;
  }
  /// No results that are infinite or no number, and no numbers that are nearly the same: see the document on
  /// differences.
  std::string operation(int depth) {
    if (chance(0.1)) return fmt::format(" MOD {}", number(1, 9));
    if (chance(0.05)) return fmt::format(" ** {}", upTo(3));
    if (chance(0.2))
      return ' ' + one({"EQ", "NE", "LE", "GE"}) + fmt::format(" [ROUND[{}] + 0.37]", value(depth + 1));
    return ' ' + one({"+", "-", "*", "+", "-", "/", "GT", "LT", "AND", "OR", "XOR"}) + ' ' + value(depth);
  }
  /// Kept in reach of a machine.
  std::string coordinate() { return '[' + fmt::format("[{}] MOD 50", sum(1)) + ']'; }

  void motion() {
    std::string line = one({"G0 ", "G1 ", "G1 "});
    for (const char axis : {'X', 'Y', 'Z'})
      if (chance(0.6)) line += axis + coordinate() + ' ';
    if (line.size() > 4) add(line);
  }
  void assignment() {
    std::string line = parameter() + " = [" + sum(0) + ']';
    if (chance(0.3)) line += ' ' + parameter() + '=' + value(1);
    add(line);
  }
  /// Numbers of O-words are spent once; names, too.
  std::string label() { return chance(0.6) ? fmt::format("o{}", ++label_) : fmt::format("o<l{}>", ++label_); }

  void statement(int depth) {
    const int kind = upTo(depth > 2 ? 3 : 9);
    if (kind < 2) return motion();
    if (kind < 4) return assignment();
    if (kind == 4) return branch(depth);
    if (kind == 5) return repeat(depth);
    if (kind == 6) return loop(depth);
    if (kind == 7) return call();
    if (kind == 8) return add(fmt::format("({})", one({"a comment", "debug, #1", "print, #<a>"})));
    add(one({"G91", "G90", "; told", "/G1 X5", "N10 G1 X1", "g1x 1 y-0 2", "G20", "G21", "G90.1",
             "(a) G1 Y3 (b)"}));
  }
  void block(int depth, int most) {
    for (int k = upTo(most); k >= 0; --k) statement(depth + 1);
  }
  void branch(int depth) {
    const std::string name = label();
    add(fmt::format("{} if [{}]", name, sum(0)));
    block(depth, 1);
    if (chance(0.4)) {
      add(fmt::format("{} elseif [{}]", name, sum(0)));
      block(depth, 1);
    }
    if (chance(0.5)) {
      add(name + " else");
      block(depth, 1);
    }
    add(name + " endif");
  }
  void repeat(int depth) {
    const std::string name = label();
    add(fmt::format("{} repeat [{}]", name, upTo(3)));
    block(depth, 1);
    add(name + " endrepeat");
  }
  void leave(const std::string& name) {
    if (!chance(0.4)) return;
    const std::string inner = label();
    add(fmt::format("{} if [{}]", inner, sum(0)));
    add(name + (chance(0.5) ? " break" : " continue"));
    add(inner + " endif");
  }
  void loop(int depth) {
    const std::string name = label();
    const int counter = 100 + ++loops_;
    add(fmt::format("#{} = 0", counter));
    const bool late = chance(0.3);
    add(late ? name + " do" : fmt::format("{} while [#{} LT {}]", name, counter, 1 + upTo(3)));
    add(fmt::format("#{0} = [#{0} + 1]", counter));
    block(depth, 1);
    leave(name);
    block(depth, 0);
    add(late ? fmt::format("{} while [#{} LT {}]", name, counter, upTo(3)) : name + " endwhile");
  }
  void sub(int number) {
    const std::string name = number == 0 ? "o<first>" : "o900";
    add(name + " sub");
    motion();
    add(one({"#1 = [#1 + 1]", "#<a> = [#2]", "#<_b> = #3", "(nothing)"}));
    if (chance(0.4)) {
      const std::string inner = label();
      add(fmt::format("{} if [#1 GT {}]", inner, this->number(-3, 3)));
      add(fmt::format("{} return{}", name, chance(0.5) ? " [#2 + 1]" : ""));
      add(inner + " endif");
    }
    motion();
    add(name + " endsub" + (chance(0.4) ? " [#1]" : ""));
  }
  void call() {
    if (defined_ == 0) return motion();
    std::string line = defined_ > 1 && chance(0.5) ? "o900 call" : "o<first> call";
    for (int k = upTo(3); k > 0; --k) line += " [" + sum(1) + ']';
    add(line);
    if (chance(0.4)) add("#4 = [#<_value> + #<_value_returned>]");
  }

  std::mt19937_64 random_;
  Text lines_;
  int label_ = 100, loops_ = 0, defined_ = 0;
};

}  // namespace

Text randomLanguageProgram(std::uint64_t seed) { return LanguageWriter(seed).program(); }

}  // namespace proveout::peer
