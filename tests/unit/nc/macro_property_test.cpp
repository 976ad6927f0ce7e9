// Random formulas against a tree that computes their value, and loops against the blocks that they stand for.
// Proves nct-23.2.6-precedence nct-23.2-formula nct-23.2.11-WHILE
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "core/nc/macro/expression.h"
#include "core/nc/nct/alarms.h"
#include "core/nc/nct/formulas.h"
#include "core/nc/registry/interpreter.h"
#include "core/path/toolpath.h"

namespace proveout {
namespace {

using nc::LexError;
using nc::MacroEvaluator;
using nc::Value;
using nc::VariableStore;

class NoEnvironment : public nc::MacroEnvironment {
 public:
  int axisNumber(std::string_view) const override { return -1; }
  ParameterAnswer parameter(int, int, int) const override { return {nc::SharedAlarm::kOutOfRange, "N", 0.0}; }
};

/// A formula as text with the brackets that it needs and no more, and its value.
struct Formula {
  std::string text;
  double value = 0.0;
  int binding = 3;  ///< 1: sum, 2: product, 3: operand
};

class FormulaMaker {
 public:
  explicit FormulaMaker(unsigned seed) : random_(seed) {
    for (int n = 1; n <= 33; ++n) variables_[n] = number(-20, 20);
  }
  const double* variables() const { return variables_; }

  Formula make(int depth) {
    if (depth == 0 || pick(8) == 0) return operand();
    switch (pick(6)) {
      case 0:
        return binary(make(depth - 1), make(depth - 1), "+");
      case 1:
        return binary(make(depth - 1), make(depth - 1), "-");
      case 2:
        return binary(make(depth - 1), make(depth - 1), "*");
      case 3: {
        Formula right = make(depth - 1);
        if (std::abs(right.value) < 1e-3) return right;
        return binary(make(depth - 1), right, pick(2) ? "/" : "MOD");
      }
      case 4:
        return function(make(depth - 1));
      default:
        return {"[" + make(depth - 1).text + "]", last_, 3};
    }
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double number(int low, int high) { return low + pick((high - low) * 4) / 4.0; }
  std::string space() { return pick(4) == 0 ? " " : ""; }

  Formula keep(Formula f) {
    last_ = f.value;
    return f;
  }
  Formula operand() {
    if (pick(2)) {
      const int n = 1 + pick(33);
      return keep({fmt::format("#{}", n), variables_[n], 3});
    }
    const double value = std::abs(number(0, 9));
    return keep({fmt::format("{}", value), value, 3});
  }
  Formula binary(const Formula& a, const Formula& b, const std::string& op) {
    const int binding = op == "+" || op == "-" ? 1 : 2;
    const auto wrapped = [](const Formula& f, bool wrap) { return wrap ? "[" + f.text + "]" : f.text; };
    const double value = op == "+"   ? a.value + b.value
                         : op == "-" ? a.value - b.value
                         : op == "*" ? a.value * b.value
                         : op == "/" ? a.value / b.value
                                     : std::fmod(a.value, b.value);
    return keep({wrapped(a, a.binding < binding) + space() + op + space() + wrapped(b, b.binding <= binding),
                 value, binding});
  }
  Formula function(const Formula& a) {
    const std::string argument = a.binding == 3 ? a.text : "[" + a.text + "]";
    switch (pick(4)) {
      case 0:
        return keep({"ABS" + argument, std::abs(a.value), 3});
      case 1:
        return keep({"FIX" + argument, std::trunc(a.value), 3});
      case 2:
        return keep({"FUP" + space() + argument, a.value < 0 ? std::floor(a.value) : std::ceil(a.value), 3});
      default:
        return keep({"-" + argument, -a.value, 3});
    }
  }

  std::mt19937 random_;
  double variables_[34] = {};
  double last_ = 0.0;
};

TEST(MacroProperties, RandomFormulasHaveTheirValue) {
  FormulaMaker maker(20);
  VariableStore store;
  for (int n = 1; n <= 33; ++n) ASSERT_EQ(store.write(n, {maker.variables()[n]}), nc::VariableStatus::kDone);
  const NoEnvironment environment;
  MacroEvaluator macro(store, environment, nc::nctAlarms(), nc::nctFormulas());
  for (int k = 0; k < 20000; ++k) {
    const Formula formula = maker.make(5);
    Value value;
    LexError error;
    std::size_t pos = 0;
    ASSERT_TRUE(macro.formula(formula.text, pos, value, error)) << formula.text << ": " << error.message;
    ASSERT_EQ(pos, formula.text.size()) << formula.text;
    ASSERT_EQ(value.number, formula.value) << formula.text;
  }
}

Toolpath pathOf(const MemoryProgramSource& source) {
  Toolpath path;
  ToolpathBuilder builder(path);
  const InterpretSummary summary = interpret(ControlId::kNct, source, {}, builder);
  EXPECT_TRUE(summary.ok());
  return path;
}

/// A grid of moves by nested loops, by a macro for each row, by a repeated macro, and written out.
TEST(MacroProperties, LoopsAndCallsAreTheBlocksThatTheyStandFor) {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    const int rows = 1 + static_cast<int>(random() % 5), columns = 1 + static_cast<int>(random() % 6);
    const std::string head = "G0 G90 X0 Y0 Z10\nG1 G91 F500\n", tail = "G0 G90 Z50\nM30\n";
    std::string blocks;
    for (int r = 0; r < rows; ++r) {
      for (int k = 0; k < columns; ++k) blocks += fmt::format("X{} Z-0.5\n", 2.5);
      blocks += "Y3\n";
    }
    const MemoryProgramSource plain("main.nc", head + blocks + tail);
    const MemoryProgramSource loops(
        "main.nc",
        head +
            fmt::format("#1=0\nWHILE[#1LT{}]DO1\n#2={}\nDO2\nIF[#2LE0] GOTO10\nX2.5 Z-0.5\n#2=#2-1\nEND2\n"
                        "N10 Y3\n#1=#1+1\nEND1\n",
                        rows, columns) +
            tail);
    MemoryProgramSource calls("main.nc", head + fmt::format("G65 P11 L{} I{}\n", rows, columns) + tail);
    calls.add("O0011", "N1 X[10/4] Z-0.5\n#4=#4-1\nIF[#4GT0]GOTO1\nY3\nM99\n");
    const Toolpath expected = pathOf(plain);
    for (const MemoryProgramSource* source : {&loops, static_cast<const MemoryProgramSource*>(&calls)}) {
      const Toolpath path = pathOf(*source);
      ASSERT_EQ(path.motions.size(), expected.motions.size());
      for (std::size_t k = 0; k < path.motions.size(); ++k) {
        EXPECT_EQ(path.motions[k].to, expected.motions[k].to) << k;
        EXPECT_EQ(path.motions[k].time_s, expected.motions[k].time_s) << k;
      }
    }
  }
}

}  // namespace
}  // namespace proveout
