// Steps as program text of each control.
#include <fmt/format.h>

#include <cmath>

#include "tests/soak/second/plan.h"

namespace proveout::soak::second {
namespace {

/// As short as it goes, a millionth at most.
std::string number(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

class Writer {
 public:
  explicit Writer(const Clamping& clamping) : c_(clamping) {}
  virtual ~Writer() = default;

  std::string write() {
    begin();
    for (const Step& step : c_.steps) {
      add(step);
      if (step.kind != Step::Kind::kTool && step.kind != Step::Kind::kSide &&
          step.kind != Step::Kind::kLean && step.kind != Step::Kind::kWords)
        at_ = endOf(step);
    }
    end();
    return std::move(text_);
  }

 protected:
  virtual void begin() = 0;
  virtual void end() = 0;
  virtual void add(const Step& step) = 0;
  virtual Spot endOf(const Step& step) const { return step.to; }
  void line(const std::string& words) { text_ += words + "\n"; }

  const Clamping& c_;
  Spot at_ = Spot::Zero();
  std::string text_;
};

/// nct and wl4-mill: what they have in common.
class Mill : public Writer {
 public:
  using Writer::Writer;

 protected:
  void add(const Step& s) override {
    using Kind = Step::Kind;
    if (s.kind == Kind::kTool) {
      line(fmt::format("T{} M6", s.number));
      line("S1200 M3");
    } else if (s.kind == Kind::kRapid || s.kind == Kind::kLine) {
      line(fmt::format("{}{} {}{}", side_, s.kind == Kind::kRapid ? "G0" : "G1", place(s.to),
                       s.kind == Kind::kRapid ? "" : " F400"));
      side_.clear();
    } else if (s.kind == Kind::kArc) {
      arc(s);
    } else if (s.kind == Kind::kHole) {
      hole(s);
    } else if (s.kind == Kind::kWeave) {
      weave(s);
    } else if (s.kind == Kind::kSide) {
      side_ = s.number == 40 ? "G40 " : fmt::format("G{} D{} ", s.number, side_number_);
    } else {
      line(s.words);
    }
  }
  Spot endOf(const Step& s) const override {
    if (s.kind == Step::Kind::kWeave) return s.center + (s.number - 1) * s.stride;
    if (s.kind == Step::Kind::kHole) return {s.to.x(), s.to.y(), at_.z()};
    return s.to;
  }
  virtual void hole(const Step& s) = 0;
  virtual void weave(const Step& s) {
    for (int k = 0; k < s.number; ++k) {
      line("G1 " + place(s.to + k * s.stride) + " F400");
      line("G1 " + place(s.center + k * s.stride));
    }
  }
  static std::string place(const Spot& p) {
    return fmt::format("X{} Y{} Z{}", number(p.x()), number(p.y()), number(p.z()));
  }
  std::string arms(const Step& s) const {
    return fmt::format(" I{} J{}", number(s.center.x() - at_.x()), number(s.center.y() - at_.y()));
  }
  bool isFull(const Step& s) const { return (s.to - at_).head<2>().norm() < 1e-9; }
  virtual void arc(const Step& s) {
    line(fmt::format("G{} {}{} F300", s.sense > 0 ? 3 : 2, place(s.to), arms(s)));
    line("G1");
  }

  std::string side_;
  int side_number_ = 1;
};

class Nct final : public Mill {
 public:
  using Mill::Mill;

 private:
  void begin() override { line("G21 G90 G17 G40 G94"); }
  void end() override { line("M30"); }
  void hole(const Step& s) override {
    line(fmt::format("G98 G{} X{} Y{} Z{} R{}{} F200", s.number, number(s.to.x()), number(s.to.y()),
                     number(s.to.z()), number(s.level),
                     s.number == 83 || s.number == 73 ? " Q" + number(s.peck) : ""));
    line("G80");
  }
  static std::string counted(char axis, double from, double stride) {
    if (stride == 0.0) return fmt::format("{}{}", axis, number(from));
    return fmt::format("{}[{}{}{}*#1]", axis, number(from), stride < 0 ? "-" : "+", number(std::abs(stride)));
  }
  void weave(const Step& s) override {
    line("#1=0");
    line(fmt::format("WHILE[#1 LT {}] DO1", s.number));
    for (const Spot& from : {s.to, s.center})
      line(fmt::format("G1 {} {} {} F400", counted('X', from.x(), s.stride.x()),
                       counted('Y', from.y(), s.stride.y()), counted('Z', from.z(), s.stride.z())));
    line("#1=#1+1");
    line("END1");
  }
};

class Wl4Mill final : public Mill {
 public:
  using Mill::Mill;

 private:
  void begin() override {
    line("%PLAN");
    line("G54 G17 G90 G94");
  }
  void end() override {
    line("M2");
    line("%");
  }
  void arc(const Step& s) override {
    const std::string to = isFull(s) ? "" : fmt::format("X{} Y{}", number(s.to.x()), number(s.to.y()));
    const std::string height = s.to.z() == at_.z() ? "" : " Z" + number(s.to.z());
    line(fmt::format("G{} {}{}{} F300", s.sense > 0 ? 3 : 2, to, height, arms(s)));
    line("G1");
  }
  void hole(const Step& s) override {
    line(fmt::format("G0 Z{}", number(at_.z())));
    line(fmt::format("G{} #2={} #3={} #4=1 #5={} F150", s.number == 73 ? 83 : s.number, number(s.level),
                     number(s.to.z()), number(s.peck)));
    line(fmt::format("G0 X{} Y{}", number(s.to.x()), number(s.to.y())));
    line("G80");
    line(fmt::format("G0 Z{}", number(at_.z())));
  }
};

/// Both lathes; x is a radius.
class Lathe final : public Writer {
 public:
  using Writer::Writer;

 private:
  bool flex() const { return c_.control == Control::kFlexnc; }
  void begin() override {
    if (flex()) {
      line("G90");
    } else {
      line("%PLAN");
      line("G54 G90 G95");
    }
  }
  void end() override {
    if (flex()) {
      line("M02");
    } else {
      line("M5");
      line("M2");
      line("%");
    }
  }
  std::string place(const Spot& p) const {
    return fmt::format("X{} Z{}", number(flex() ? p.x() : 2 * p.x()), number(p.z()));
  }
  void add(const Step& s) override {
    using Kind = Step::Kind;
    if (s.kind == Kind::kTool) {
      line(flex() ? fmt::format("T{0}M06D{0}", s.number) : fmt::format("T{} M6", s.number));
      line(flex() ? "S700M03" : "G97 S700 M3");
      if (flex()) line("G99F0.15");
    } else if (s.kind == Kind::kWords) {
      line(s.words);
    } else if (s.kind == Kind::kArc) {
      line(fmt::format("{} {} I{} K{} F0.1", s.sense > 0 ? "G03" : "G02", place(s.to),
                       number(s.center.x() - at_.x()), number(s.center.z() - at_.z())));
    } else {
      line(fmt::format("{} {}{}", s.kind == Kind::kRapid ? "G00" : "G01", place(s.to),
                       s.kind == Kind::kRapid ? "" : " F0.15"));
    }
  }
};

class Wire final : public Writer {
 public:
  using Writer::Writer;

 private:
  void begin() override {
    for (const auto& [row, radius] : c_.radii) line(fmt::format("H{:03}={:.3f};", row, radius));
    line("T84 T86;");
    line("C001;");
  }
  void end() override {
    line("T85 T87;");
    line("M02;");
  }
  static std::string place(const Spot& p) { return fmt::format("X{:.3f} Y{:.3f}", p.x(), p.y()); }
  void add(const Step& s) override {
    using Kind = Step::Kind;
    if (s.kind == Kind::kRapid) {
      line((begun_ ? "G00 " : "G90 G92 ") + place(s.to) + ";");
      begun_ = true;
    } else if (s.kind == Kind::kCut) {
      line("M50;");
      line("G00 " + place(s.to) + ";");
      line("M60;");
    } else if (s.kind == Kind::kSide) {
      before_ += s.number == 40 ? "G40 " : fmt::format("G{} H{:03} ", s.number, static_cast<int>(s.level));
    } else if (s.kind == Kind::kLean) {
      before_ += s.number == 50 ? "G50 A0 " : fmt::format("G{} A{:.3f} ", s.number, s.angle);
    } else if (s.kind == Kind::kWords) {
      line(s.words);
    } else {
      way(s);
    }
  }
  void way(const Step& s) {
    std::string words = before_ +
                        (s.kind == Step::Kind::kLine ? "G01 "
                         : s.sense > 0               ? "G03 "
                                                     : "G02 ") +
                        place(s.to);
    if (s.kind == Step::Kind::kArc)
      words += fmt::format(" I{:.3f} J{:.3f}", s.center.x() - at_.x(), s.center.y() - at_.y());
    if (s.round > 0) words += fmt::format(" R{:.3f}", s.round);
    line(words + ";");
    before_.clear();
  }

  std::string before_;
  bool begun_ = false;
};

}  // namespace

const char* nameOf(Control control) {
  constexpr const char* kNames[] = {"nct", "wl4-mill", "wl4-lathe", "flexnc", "wedm"};
  return kNames[static_cast<int>(control)];
}

std::string programOf(const Clamping& clamping) {
  switch (clamping.control) {
    case Control::kNct:
      return Nct(clamping).write();
    case Control::kWl4Mill:
      return Wl4Mill(clamping).write();
    case Control::kWedm:
      return Wire(clamping).write();
    default:
      return Lathe(clamping).write();
  }
}

}  // namespace proveout::soak::second
