#include <fmt/format.h>

#include "tests/study/cause_parts.h"

namespace proveout::study {
namespace {

/// A rectangle with round corners, cut out of a plate: a die with walls that lean.
struct Die {
  double half_x, half_y, radius, lean, height, wire, gap;
  bool wider_below;

  explicit Die(std::uint32_t seed) {
    std::mt19937 random(seed * 2246822519U + 3U);
    const auto in = [&](double least, double most, double step) { return stepped(random, least, most, step); };
    half_x = in(8, 14, 0.5), half_y = in(6, 10, 0.5), radius = in(2, 3.5, 0.5);
    lean = in(0.5, 3, 0.5), height = in(10, 30, 5);
    wire = in(0, 1, 1) == 0 ? 0.2 : 0.25, gap = in(0.01, 0.03, 0.005);
    wider_below = random() % 2 == 0;
  }
  /// In thousandths.
  double row() const { return std::round(1000.0 * (wire / 2 + gap)); }
};

std::string wordOf(const char* letter, double value) {
  const std::string text = Writer::number(value);
  return letter + text + (text.find('.') == std::string::npos ? "." : "");
}

/// Once around from the middle of the upper side, with the clock.
Writer program(const Die& d, const Plan& plan) {
  Writer w(plan);
  const double x = d.half_x, y = d.half_y, r = d.radius;
  const std::string lean = d.wider_below ? "G51" : "G52";
  w.text("row", fmt::format("H001={:.0f};", plan.of("row", d.row()))).end();
  w.block("T84 T86;");
  w.block("G92 X0 Y0;");
  w.block("C001;");
  w.put("G52 A0").text("side", "G42").put("H001 G01 " + wordOf("Y", y) + ";").end();
  w.text("lean", lean)
      .text("angle", wordOf("A", plan.of("angle", d.lean)))
      .text("x1", wordOf("X", plan.of("x1", x - r)) + ";")
      .end();
  w.text("corner_1", "G02")
      .put(wordOf("X", x) + " " + wordOf("Y", y - r) + " I0 " + wordOf("J", -r) + ";")
      .end();
  w.put("G01").text("y1", wordOf("Y", plan.of("y1", -y + r)) + ";").end();
  w.text("corner_2", "G02")
      .put(wordOf("X", x - r) + " " + wordOf("Y", -y) + " " + wordOf("I", -r) + " J0;")
      .end();
  w.block("G01 " + wordOf("X", -x + r) + ";");
  w.text("corner_3", "G02")
      .put(wordOf("X", -x) + " " + wordOf("Y", -y + r) + " I0 " + wordOf("J", r) + ";")
      .end();
  w.block("G01 " + wordOf("Y", y - r) + ";");
  w.text("corner_4", "G02")
      .put(wordOf("X", -x + r) + " " + wordOf("Y", y) + " " + wordOf("I", r) + " J0;")
      .end();
  w.block("G01 X0;");
  w.block("G40 G50 A0 Y0;");
  w.block("T85 T87;");
  w.block("M02;");
  return w;
}

std::string job(const Die& d, const Plan& plan) {
  const auto number = [&](const char* key, double right) { return Writer::number(plan.of(key, right)); };
  const double x = d.half_x + 8, y = d.half_y + 8;
  std::string out =
      "schema = \"proveout.job/1\"\nname = \"die\"\nprogram = \"die.nc\"\n[control]\nname = \"wedm\"\n";
  out += fmt::format("[control.wedm]\nZM = {}\nZS = 0\n", number("control.wedm.ZM", d.height));
  out += fmt::format("[stock]\nshape = \"box\"\nmin = [{:g}, {:g}, 0]\nmax = [{:g}, {:g}, {:g}]\n", -x, -y, x,
                     y, d.height);
  out += "start_hole = [{ at = [0, 0], diameter = 3 }]\npart_point = [" + Writer::number(x - 1) + ", 0, 1]\n";
  out += fmt::format("[[tool]]\nnumber = 1\ntype = \"wire\"\ndiameter = {}\nspark_gap = {}\n",
                     number("tools.1.diameter", d.wire), number("tools.1.spark_gap", d.gap));
  return out + "[nominal]\nmesh = \"nominal.stl\"\ngouge = 0.01\nexcess = 0.01\n";
}

Mistake word(const char* kind, const char* name, const Plan& plan, const std::string& what) {
  Mistake m{kind, std::string(name) + " = " + what, plan, {std::string("die.nc:") + name}, {}};
  return m;
}
Mistake value(const char* kind, const char* name, double wrong) {
  Plan plan;
  plan.values[name] = wrong;
  return word(kind, name, plan, Writer::number(wrong));
}
Mistake text(const char* kind, const char* name, const std::string& wrong) {
  Plan plan;
  plan.texts[name] = wrong;
  return word(kind, name, plan, wrong);
}

}  // namespace

StudyJob wireJob(std::uint32_t seed, const Plan& plan) {
  const Die die(seed);
  const Writer w = program(die, plan);
  StudyJob out;
  out.files = {{"die.nc", w.program()}, {"job.toml", job(die, plan)}};
  for (const char* const name :
       {"row", "side", "lean", "angle", "x1", "y1", "corner_1", "corner_2", "corner_3", "corner_4"})
    out.lines[std::string("die.nc:") + name] = w.lineOf(name);
  return out;
}

Mistake wireMistake(std::uint32_t seed) {
  const Die d(seed);
  std::mt19937 random(seed * 40503U + 5U);
  switch (random() % 8) {
    case 0:
      return text("wire: side", "side", "G41");
    case 1:
      return text("wire: sign of the taper", "lean", d.wider_below ? "G52" : "G51");
    case 2:
      return value("wire: taper", "angle", d.lean + (random() % 2 == 0 ? 0.5 : -0.4));
    case 3: {
      Mistake m = value("wire: H", "row",
                        d.row() + (random() % 2 == 0 ? 1 : -1) * (15.0 + static_cast<double>(random() % 60)));
      m.words.insert("die.nc:side");
      return m;
    }
    case 4: {
      Mistake m = value("wire: datum", "tools.1.diameter", d.wire == 0.2 ? 0.25 : 0.2);
      m.words = {};
      m.data = {"tools.1.diameter"};
      return m;
    }
    case 5: {
      Mistake m = value("wire: plane", "control.wedm.ZM", d.height + (random() % 2 == 0 ? 5 : -5));
      m.words = {};
      m.data = {"control.wedm.ZM"};
      return m;
    }
    case 6: {
      const char* const names[] = {"corner_1", "corner_2", "corner_3", "corner_4"};
      return text("wire: direction", names[random() % 4], "G03");
    }
    default:
      return random() % 2 == 0
                 ? value("wire: X, Y", "x1", d.half_x - d.radius + signedSize(random, 0.05, 0.5))
                 : value("wire: X, Y", "y1", -d.half_y + d.radius + signedSize(random, 0.05, 0.5));
  }
}

}  // namespace proveout::study
