#include "golden_case.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "core/base/printable.h"
#include "core/nc/text/source_text.h"
#include "io/job/job.h"
#include "wedm_path.h"

namespace proveout::test {
namespace {

std::string number(double value) {
  std::string text = fmt::format("{:.4f}", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string point(const Vec3& p) { return number(p.x()) + " " + number(p.y()) + " " + number(p.z()); }

/// The path as text, one line each; motions are kept as well.
class TextSink : public MotionSink {
 public:
  explicit TextSink(std::vector<GoldenMotion>& motions) : motions_(motions) {}
  void file(std::uint32_t index, const std::string& name) override {
    text += fmt::format("file {} {}\n", index, name);
  }
  void motion(const Motion& m, const ArcGeometry* arc, const AxisSweep* axis) override {
    motions_.push_back({m, arc ? *arc : ArcGeometry{}, arc != nullptr, axis ? *axis : AxisSweep{}, {}});
    text +=
        channel(m.channel) + place(m.source) + std::string(motionKindName(m.kind)) + (arc ? " arc " : " ");
    std::optional<Vec3>& last = last_.at(m.channel);
    if (!last || (*last - m.from).norm() > 1e-9) text += "from " + point(m.from) + " ";
    last = m.to;
    text += "to " + point(m.to);
    if (arc) {
      text += " center " + point(arc->center) + " normal " + point(arc->normal) + " sweep " +
              number(radToDeg(arc->sweep_rad));
    }
    if (axis && !axis->alongZ()) text += " axis " + point(axis->from) + " to " + point(axis->to);
    for (int k = 0; axis && k < axis->rotary_count; ++k) {
      const RotaryPosition& r = axis->rotary[static_cast<std::size_t>(k)];
      text += fmt::format(" {} {} to {}", r.name.data(), number(r.from), number(r.to));
    }
    if (m.kind != MotionKind::kRapid) text += " F" + number(m.feed);
    text += " t" + number(m.time_s);
    if (m.thread_start_deg != 0.0F) text += " start " + number(m.thread_start_deg);
    if (m.thread_pitch_change != 0.0F) text += " change " + number(m.thread_pitch_change);
    text += "\n";
  }
  void wireMotion(const Motion& m, const WireSweep& wire) override {
    motions_.push_back({m, {}, false, {}, wire});
    text += place(m.source) + (m.kind == MotionKind::kRapid ? "rapid wire" : "cut wire");
    track(" lower", wire.lower, wire.z_low);
    track(" upper", wire.upper, wire.z_high);
    text += " F" + number(m.feed) + " t" + number(m.time_s) + "\n";
  }
  void event(const PathEvent& event) override {
    text += channel(event.channel) + place(event.source) + "event " + std::string(eventName(event.what));
    forEachField(event.what, [&](const char* key, const auto& value) {
      text += fmt::format(" {}=", key);
      if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
        text += jsonQuoted(value);
      } else {
        text += fmt::format("{}", value);
      }
    });
    if (event.as<event::Wait>() != nullptr) text += " t" + number(event.time_s);
    text += "\n";
  }
  void diagnostic(const Diagnostic& diagnostic) override { text += formatDiagnostic(diagnostic); }

  std::string text;

 private:
  void track(const char* name, const WireTrack& t, double z) {
    text += name;
    text += t.sweep_rad == 0.0 ? " to " : " arc to ";
    text += point({t.to.x(), t.to.y(), z});
    if (t.sweep_rad == 0.0) return;
    text += " center " + number(t.center.x()) + " " + number(t.center.y()) + " sweep " +
            number(radToDeg(t.sweep_rad));
  }
  static std::string channel(int number) { return number == 0 ? "" : fmt::format("[{}] ", number); }
  static std::string place(const SourceRef& s) {
    std::string out = s.file == 0 ? "" : fmt::format("{}/", s.file);
    out += fmt::format("{}", s.line);
    if (s.block >= 0) out += fmt::format(" N{}", s.block);
    if (s.depth > 0) out += fmt::format(" depth {}", s.depth);
    return out + ": ";
  }
  std::vector<GoldenMotion>& motions_;
  std::array<std::optional<Vec3>, 9> last_;  ///< by channel
};

Vec3 vectorOf(std::istringstream& in, const std::string& line) {
  Vec3 v;
  if (!(in >> v.x() >> v.y() >> v.z())) throw std::runtime_error("three numbers expected: " + line);
  return v;
}

const char* endName(ProgramEnd end) {
  switch (end) {
    case ProgramEnd::kEndOfProgram:
      return "end of program";
    case ProgramEnd::kUntil:
      return "until";
    case ProgramEnd::kAlarm:
      return "alarm";
    case ProgramEnd::kBlockLimit:
      return "block limit";
    case ProgramEnd::kCancelled:
      return "cancelled";
  }
  return "?";
}

/// axis = NAME NUMBER linear|rotary [parallel X] [rapid 5000] [start 0] [reference 0] [limit -10 10]
AxisSettings axisOf(std::istringstream& in, const std::string& line) {
  AxisSettings axis;
  std::string kind, key, word;
  if (!(in >> axis.name >> axis.number >> kind)) throw std::runtime_error("axis expected: " + line);
  axis.kind = kind == "linear" ? AxisKind::kLinear : AxisKind::kRotary;
  while (in >> key) {
    AxisLimit limit;
    if (key == "parallel") in >> axis.parallel;
    if (key == "rapid") in >> axis.rapid;
    if (key == "acceleration") in >> axis.acceleration;
    if (key == "start") in >> axis.start;
    if (key == "reference") in >> axis.reference;
    if (key == "carries" && in >> word) {
      axis.carries = word == "part" ? RotaryCarries::kPart : RotaryCarries::kNothing;
    }
    if (key == "direction") axis.direction = vectorOf(in, line);
    if (key == "center") axis.center = vectorOf(in, line);
    if (key == "limit" && in >> limit.min >> limit.max) axis.limit = limit;
    if (!in) throw std::runtime_error("bad axis: " + line);
  }
  return axis;
}

/// spindle = NUMBER [name S2] [range 50 1000]... [acceleration 500] [top 3000] [positioning 60] [position
/// CS2]
///           [axis C] [main 31] [sync 21] [shift 22] [axis_code 20]
SpindleSettings spindleOf(std::istringstream& in, const std::string& line) {
  SpindleSettings spindle;
  std::string key;
  if (!(in >> spindle.number)) throw std::runtime_error("number of a spindle expected: " + line);
  while (in >> key) {
    SpindleRange range;
    if (key == "name") in >> spindle.name;
    if (key == "acceleration") in >> spindle.acceleration;
    if (key == "top") in >> spindle.top_rpm;
    if (key == "positioning") in >> spindle.positioning_rpm;
    if (key == "position") in >> spindle.position_name;
    if (key == "axis") in >> spindle.axis;
    if (key == "main") in >> spindle.main_code;
    if (key == "sync") in >> spindle.sync_code;
    if (key == "shift") in >> spindle.shift_code;
    if (key == "axis_code") in >> spindle.axis_code;
    if (key == "range" && in >> range.min >> range.max) spindle.ranges.push_back(range);
    if (!in) throw std::runtime_error("bad spindle: " + line);
  }
  return spindle;
}

/// machine = FILE, seen from the project's folder: what a job with that file gives the control.
void setMachine(ControlSettings& s, std::istringstream& in, const std::string& line) {
  std::string file;
  if (!(in >> file)) throw std::runtime_error("file expected: " + line);
  Job job;
  job.settings = s;
  Diagnostics diagnostics;
  loadMachine(std::string(PROVEOUT_SOURCE_DIR) + "/" + file, job, diagnostics);
  if (diagnostics.hasErrors()) throw std::runtime_error(formatDiagnostic(diagnostics.all().front()));
  s = job.settings;
}

void setLine(ControlSettings& s, const std::string& line) {
  std::istringstream in(line);
  std::string key, equals;
  if (!(in >> key >> equals) || equals != "=") throw std::runtime_error("KEY = VALUE expected: " + line);
  const auto value = [&] {
    double v = 0;
    if (!(in >> v)) throw std::runtime_error("number expected: " + line);
    return v;
  };
  const int row =
      key.size() > 1 && std::isdigit(static_cast<unsigned char>(key[1])) ? std::stoi(key.substr(1)) : 0;
  if (key[0] == 'H' && row > 0) {
    s.length_offsets[row] = {value(), 0.0};
  } else if (key[0] == 'D' && row > 0) {
    s.radius_offsets[row] = {value(), 0.0};
  } else if (key[0] == 'G' && row >= 54 && row <= 59) {
    s.work_offsets[static_cast<std::size_t>(row - 54)] = vectorOf(in, line);
  } else if (key.starts_with("insert")) {
    InsertMount mount;
    in >> mount.nose_center.x() >> mount.nose_center.y();
    if (Vec2 gauge; in >> gauge.x() >> gauge.y()) mount.gauge = gauge;
    s.inserts[std::stoi(key.substr(6))] = mount;
  } else if (key.starts_with("gauge")) {
    s.gauge_lengths[std::stoi(key.substr(5))] = value();
  } else if (key.starts_with("reference")) {
    s.reference_points.at(static_cast<std::size_t>(std::stoi(key.substr(9)) - 1)) = vectorOf(in, line);
  } else if (key[0] == 'N' && row > 0) {
    s.parameters[key] = value();
  } else if (key.starts_with("BUF.") || key.starts_with("CLR.")) {
    s.parameters[key] = value();
  } else if (key.starts_with("param.")) {
    s.parameters[key.substr(6)] = value();
  } else if (key == "machine") {
    setMachine(s, in, line);
  } else if (key == "axis") {
    s.axes.push_back(axisOf(in, line));
  } else if (key == "spindle") {
    s.spindles.push_back(spindleOf(in, line));
  } else if (key == "start") {
    s.start = vectorOf(in, line);
  } else if (key == "tool") {
    s.tool = static_cast<int>(value());
  } else if (key == "rapid") {
    s.rapid_mm_min = vectorOf(in, line);
    s.rapid_by_default = false;
  } else if (key == "acceleration") {
    s.acceleration_mm_s2 = vectorOf(in, line);
  } else if (key == "bell") {
    s.bell_time_s = value();
  } else if (key == "skip") {
    s.skip_switches.at(static_cast<std::size_t>(value() - 1)) = true;
  } else if (key.starts_with("limit_")) {
    const double low = value();
    s.limits.at(static_cast<std::size_t>(key[6] - 'X')) = AxisLimit{low, value()};
  } else if (key == "range_b") {
    s.stroke_range_b.emplace_back();
    in >> s.stroke_range_b.back();
  } else if (key == "block_limit") {
    s.block_limit = static_cast<std::uint64_t>(value());
  } else if (key == "max_errors") {
    s.max_errors = static_cast<int>(value());
  } else if (key == "lenient") {
    s.lenient = value() != 0;
  } else if (key == "optional_stop") {
    s.optional_stop = value() != 0;
  } else if (key == "inch") {
    s.units = value() != 0 ? LengthUnit::kInch : LengthUnit::kMillimetre;
  } else if (key == "interrupt") {
    s.interrupt_blocks.push_back(static_cast<std::int64_t>(value()));
  } else if (key == "until_line") {
    s.until = UntilBlock{static_cast<int>(value()), {}};
  } else if (key == "until_block") {
    s.until = UntilBlock{{}, static_cast<std::int64_t>(value())};
  } else {
    throw std::runtime_error("unknown setting: " + line);
  }
}

/// probe = plane NX NY NZ D: material where N.p >= D; probe = box X0 Y0 Z0 X1 Y1 Z1: material inside.
/// Workpiece frame; the tool is a point. Several lines are one body.
class SolidProbe : public Probe {
 public:
  bool setLine(const std::string& line) {
    std::istringstream in(line);
    std::string key, equals, kind;
    if (!(in >> key >> equals >> kind) || key != "probe") return false;
    std::vector<Half> solid;
    if (kind == "plane") {
      const Vec3 n = vectorOf(in, line);
      solid.push_back({n, 0.0});
      in >> solid.back().d;
    } else if (kind == "box") {
      const Vec3 low = vectorOf(in, line), high = vectorOf(in, line);
      for (int k = 0; k < 3; ++k) {
        solid.push_back({Vec3::Unit(k), low[k]});
        solid.push_back({-Vec3::Unit(k), -high[k]});
      }
    }
    if (solid.empty() || !in) throw std::runtime_error("bad probe: " + line);
    solids_.push_back(solid);
    return true;
  }
  bool any() const { return !solids_.empty(); }

  Result<std::optional<double>> firstContact(const Motion& move, const ArcGeometry*,
                                             const AxisSweep*) override {
    std::optional<double> first;
    for (const std::vector<Half>& solid : solids_) {
      double enter = 0.0, leave = 1.0;
      for (const Half& half : solid) {
        const double gap = half.d - half.n.dot(move.from), way = half.n.dot(move.to - move.from);
        if (way > 0.0) enter = std::max(enter, gap / way);
        if (way < 0.0) leave = std::min(leave, gap / way);
        if (way == 0.0 && gap > 0.0) leave = -1.0;
      }
      if (enter <= leave && (!first || enter < *first)) first = enter;
    }
    return first;
  }

 private:
  struct Half {
    Vec3 n;
    double d;
  };
  std::vector<std::vector<Half>> solids_;
};

/// What the person at the machine answers, the name of the main program, the control. False: a line of the
/// control.
bool setHostLine(Operator& person, std::string& main_name, ControlId& control, const std::string& line) {
  std::istringstream in(line);
  std::string key, equals, name;
  if (!(in >> key >> equals)) return false;
  const auto row = [&](std::size_t prefix) {
    return static_cast<std::size_t>(std::stoi(key.substr(prefix)));
  };
  if (key == "main_name") {
    in >> main_name;
  } else if (key == "control" && in >> name) {
    control = findControl(name).value();
  } else if (key.starts_with("answer")) {
    in >> person.message_answers[static_cast<int>(row(6))];
  } else if (key.starts_with("plc_bit")) {
    in >> person.plc_bits.at(row(7));
  } else if (key.starts_with("plc_number")) {
    in >> person.plc_numbers.at(row(10) - 1);
  } else if (key == "date") {
    in >> person.date;
  } else if (key == "time") {
    in >> person.time;
  } else if (key == "test_mode") {
    in >> person.test_mode;
  } else {
    return false;
  }
  if (!in) throw std::runtime_error("bad setting: " + line);
  return true;
}

const WireTrack& trackOf(const WireSweep& wire, bool upper) { return upper ? wire.upper : wire.lower; }

/// Whether a motion, or that track of a wire, is an arc.
bool isArc(const GoldenMotion& m, bool upper) {
  return m.wire ? trackOf(*m.wire, upper).sweep_rad != 0.0 : m.is_arc;
}

/// Point of a motion, or of that track of a wire, after `part` (0 to 1) of its angle or length.
Vec3 pointAt(const GoldenMotion& m, bool upper, double part) {
  const Motion& motion = m.motion;
  if (m.wire) {
    const Vec2 p = wireTrackPoint(trackOf(*m.wire, upper), part);
    return {p.x(), p.y(), upper ? m.wire->z_high : m.wire->z_low};
  }
  if (!m.is_arc) return motion.from + (motion.to - motion.from) * part;
  return arcPoint(arcFrame(motion.from, motion.to, m.arc), m.arc, part);
}

/// Centre or sweep of an arc.
std::vector<double> arcFigure(const std::string& word, const GoldenMotion& m, bool upper) {
  if (!m.wire) {
    const Vec3& c = m.arc.center;
    if (word == "sweep") return {radToDeg(m.arc.sweep_rad)};
    return {c.x(), c.y(), c.z()};
  }
  const WireTrack& track = trackOf(*m.wire, upper);
  if (word == "sweep") return {radToDeg(track.sweep_rad)};
  return {track.center.x(), track.center.y()};
}

/// What the words of a line of truth compare; `words` gives what a figure needs beside its name, `upper`
/// tells of which track of a wire the line speaks.
std::vector<double> figuresOf(const std::string& word, std::istringstream& words, const GoldenMotion& m,
                              bool upper) {
  const Motion& motion = m.motion;
  if (word == "F") return {motion.feed};
  if (word == "t") return {motion.time_s};
  if (word == "S") return {motion.spindle};
  if (word == "start") return {m.motion.thread_start_deg};
  if (word == "change") return {m.motion.thread_pitch_change};
  if (word == "T") return {static_cast<double>(motion.tool)};
  if (word == "axis") return {m.axis.to.x(), m.axis.to.y(), m.axis.to.z()};
  if (word == "ch") return {static_cast<double>(motion.channel)};
  if (word == "center" || word == "sweep") return arcFigure(word, m, upper);
  std::vector<double> figures;
  if (word == "rotary") {
    for (const RotaryPosition& r : m.axis.rotary) figures.push_back(r.to);
  } else if (word == "at" || (word == "upper" && m.wire)) {
    double part = 1.0;
    if (word == "at" && !(words >> part)) throw std::runtime_error("part of the way expected behind at");
    const Vec3 p = pointAt(m, upper, part);
    figures = {p.x(), p.y(), p.z()};
  }
  return figures;
}

/// Empty if a line of truth tells of each track of a wire and of each of its arcs.
std::string untoldOf(const GoldenMotion& m, bool upper, const std::array<bool, 2>& swept) {
  if (!m.wire) return "";
  std::string problems = upper ? "" : " the upper track is not told;";
  if (isArc(m, false) && !swept[0]) problems += " the lower track is an arc;";
  if (isArc(m, true) && !swept[1]) problems += " the upper track is an arc;";
  return problems;
}

/// Compares one motion with its line of truth; what differs is added to `problems`.
void compareLine(const std::string& line, const GoldenMotion& m, const std::string& name,
                 std::string& problems) {
  constexpr double kTolerance = 1.01e-4;  // the manual's numbers have four decimals
  std::istringstream words(line);
  std::vector<double> actual{m.motion.to.x(), m.motion.to.y(), m.motion.to.z()};
  std::size_t k = 0;
  bool upper = false;           // the line speaks of the upper track of a wire
  std::array<bool, 2> swept{};  // tracks whose sweep it tells
  for (std::string word; words >> word;) {
    if (word == "rapid" || word == "feed" || word == "thread" || word == "probe") {
      if (motionKindName(m.motion.kind) != word) problems += name + ": not " + word + "\n";
      continue;
    }
    upper = upper || word == "upper";
    if (word == "sweep") swept.at(upper ? 1 : 0) = true;
    if ((word == "center" || word == "sweep") && !isArc(m, upper)) problems += name + ": no arc\n";
    if (std::vector<double> figures = figuresOf(word, words, m, upper); !figures.empty()) {
      actual = std::move(figures);
      k = 0;
      continue;
    }
    const double got = actual.at(k++);
    if (word != "*" && !(std::abs(got - std::stod(word)) <= kTolerance)) {
      problems += fmt::format("{}: {} instead of {} in: {}\n", name, got, word, line);
    }
  }
  if (const std::string untold = untoldOf(m, upper, swept); !untold.empty())
    problems += name + ":" + untold + "\n";
}

/// Way of a motion, mm; of a wire that of one of its tracks.
double wayOf(const GoldenMotion& m, bool upper) {
  if (m.wire) return wireTrackLength(trackOf(*m.wire, upper));
  if (m.is_arc) throw std::runtime_error("length knows no arcs but those of a wire");
  return (m.motion.to - m.motion.from).norm();
}

/// Compares the way of all cuts with `length lower [upper]`.
void compareLength(const std::string& line, const std::vector<GoldenMotion>& motions, std::string& problems) {
  constexpr double kTolerance = 1.01e-4;
  std::istringstream words(line.substr(std::string("length").size()));
  bool upper = false;
  for (double told = 0; words >> told; upper = true) {
    double way = 0.0;
    for (const GoldenMotion& m : motions) way += m.motion.kind == MotionKind::kRapid ? 0.0 : wayOf(m, upper);
    if (!(std::abs(way - told) <= kTolerance))
      problems += fmt::format("length {} instead of {} in: {}\n", way, told, line);
  }
}

/// Bytes as they can stand in a text.
std::string escaped(const std::string& bytes) {
  std::string out;
  for (const char c : bytes) {
    const auto code = static_cast<unsigned char>(c);
    out += code < 0x20 || code >= 0x7F || c == '\\' ? fmt::format("\\{:02X}", code) : std::string(1, c);
  }
  return out;
}

}  // namespace

GoldenCase readGolden(const std::string& path) {
  GoldenCase golden;
  golden.path = path;
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::string line;
  std::string* section = &golden.main_text;
  while (std::getline(in, line)) {
    if (line.starts_with("=== ")) {
      const std::string name = line.substr(4);
      if (name == "about") section = &golden.about;
      if (name == "settings") section = &golden.settings_text;
      if (name == "main") section = &golden.main_text;
      if (name == "truth") section = &golden.truth;
      if (name == "says") section = &golden.says;
      if (name == "characterisation") section = &golden.characterisation;
      if (name == "expect") section = &golden.expect;
      if (name.starts_with("sub ")) {
        golden.subprograms.reserve(64);
        golden.subprograms.push_back({name.substr(4), ""});
        section = &golden.subprograms.back().second;
      }
      if (name.starts_with("channel ")) {
        golden.channels.reserve(8);
        golden.channels.push_back({std::stoi(name.substr(8)), "", ""});
        for (const char letter : name.substr(9))
          golden.channels.back().settings_text += letter == ';' ? '\n' : letter;
        section = &golden.channels.back().text;
      }
      if (section != &golden.expect) golden.head += line + "\n";
      continue;
    }
    *section += line + "\n";
    if (section != &golden.expect) golden.head += line + "\n";
  }
  return golden;
}

void writeGolden(const GoldenCase& golden, const std::string& expect) {
  std::ofstream out(golden.path, std::ios::binary);
  out << golden.head << "=== expect\n" << expect;
}

ControlSettings settingsOf(const std::string& text) {
  ControlSettings settings;
  settings.start = Vec3(0, 0, 0);
  std::istringstream in(text);
  Operator person;
  std::string main_name;
  SolidProbe probe;
  ControlId control = ControlId::kNct;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || setHostLine(person, main_name, control, line) || probe.setLine(line)) continue;
    setLine(settings, line);
  }
  return settings;
}

namespace {

InterpretSummary runChannels(const GoldenCase& golden, const ProgramSource& first,
                             const ControlSettings& settings, MotionSink& sink, const ControlHost& host) {
  std::vector<ChannelProgram> programs{{&first, settings}};
  programs.front().settings.channel = 1;
  std::vector<std::unique_ptr<MemoryProgramSource>> sources;
  for (const GoldenCase::Channel& channel : golden.channels) {
    const std::string name = fmt::format("channel{}.nc", channel.number);
    sources.push_back(std::make_unique<MemoryProgramSource>(name, channel.text));
    for (const auto& [sub, text] : golden.subprograms) sources.back()->add(sub, text);
    ControlSettings own = settings;
    std::istringstream in(channel.settings_text);
    for (std::string line; std::getline(in, line);) {
      if (line.find('=') != std::string::npos) setLine(own, line);
    }
    own.channel = channel.number;
    programs.push_back({sources.back().get(), own});
  }
  return interpretChannels(ControlId::kNct, programs, sink, nullptr, host);
}

/// Name of the main program of a case.
std::string mainNameOf(const GoldenCase& golden) {
  Operator person;
  std::string main_name = "main.nc";
  ControlId control = ControlId::kNct;
  std::istringstream in(golden.settings_text);
  for (std::string line; std::getline(in, line);) setHostLine(person, main_name, control, line);
  return main_name;
}

InterpretSummary runInto(MotionSink& sink, MemoryOutput& output, const GoldenCase& golden, bool as_channel) {
  ControlHost host;
  std::string main_name = "main.nc";
  ControlId control = ControlId::kNct;
  std::istringstream in(golden.settings_text);
  SolidProbe probe;
  for (std::string line; std::getline(in, line);) {
    setHostLine(host.person, main_name, control, line);
    probe.setLine(line);
  }
  if (probe.any()) host.probe = &probe;
  MemoryProgramSource source(main_name, golden.main_text);
  for (const auto& [name, text] : golden.subprograms) source.add(name, text);
  host.output = &output;
  const ControlSettings settings = settingsOf(golden.settings_text);
  return golden.channels.empty() && !as_channel ? interpret(control, source, settings, sink, nullptr, host)
                                                : runChannels(golden, source, settings, sink, host);
}

}  // namespace

GoldenPath pathOfGolden(const GoldenCase& golden) {
  GoldenPath result;
  const auto keep = [&](const std::string& name, const std::string& bytes) {
    const Result<std::string> utf8 = nc::decodeText(bytes, TextEncoding::kAuto);
    if (!utf8) return;
    const nc::SourceText text(name, name, *utf8);
    result.texts[name].assign(text.lines().begin(), text.lines().end());
  };
  keep(mainNameOf(golden), golden.main_text);
  for (const auto& [name, text] : golden.subprograms) keep(name.substr(name.rfind('/') + 1), text);
  for (const GoldenCase::Channel& channel : golden.channels)
    keep(fmt::format("channel{}.nc", channel.number), channel.text);
  ToolpathBuilder sink(result.path);
  MemoryOutput output;
  runInto(sink, output, golden, false);
  return result;
}

std::string GoldenPath::line(std::uint32_t file, std::uint32_t number) const {
  const std::string& name = path.files.at(file);
  const auto lines = texts.find(name.substr(name.rfind('/') + 1));
  if (lines == texts.end() || number < 1 || number > lines->second.size()) return {};
  return lines->second[number - 1];
}

namespace {

/// The text without its motions: of chords the truth tells the ends, and their number is not promised.
std::string withoutMotions(const std::string& text) {
  std::istringstream in(text);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    const bool motion = colon != std::string::npos && line.find_first_not_of("0123456789 Ndepth/") == colon &&
                        line.find(" event ") == std::string::npos;
    if (!motion) out += line + "\n";
  }
  return out;
}

}  // namespace

std::string runGolden(const GoldenCase& golden, std::vector<GoldenMotion>& motions, bool as_channel) {
  TextSink sink(motions);
  MemoryOutput output;
  const InterpretSummary s = runInto(sink, output, golden, as_channel);
  for (const auto& [name, bytes] : output.files()) sink.text += "file " + name + ": " + escaped(bytes) + "\n";
  if (!golden.channels.empty()) sink.text += "cycle " + number(s.cycle_s) + " s\n";
  if (golden.truth.starts_with("line "))
    return withoutMotions(sink.text) + fmt::format("{}: {} blocks, {} errors, {} warnings\n", endName(s.end),
                                                   s.blocks, s.errors, s.warnings);
  return sink.text + fmt::format("{}: {} blocks, {} motions, {} errors, {} warnings\n", endName(s.end),
                                 s.blocks, s.motions, s.errors, s.warnings);
}

GoldenProof proofOf(const GoldenCase& golden) {
  const auto told = [](const std::string& text) {
    return text.find_first_not_of(" \n") != std::string::npos;
  };
  if (told(golden.characterisation)) return GoldenProof::kCharacterisation;
  if (told(golden.truth)) return GoldenProof::kTruth;
  return told(golden.says) ? GoldenProof::kSays : GoldenProof::kNone;
}

std::string missingIn(const std::string& text, const std::string& says) {
  std::istringstream wanted(says), in(text);
  std::string line;
  for (std::string want; std::getline(wanted, want);) {
    do {
      if (!std::getline(in, line)) return "not said in its place: " + want + "\n";
    } while (line.find(want) == std::string::npos);
  }
  return "";
}

namespace {

/// Compares `line N ...` with the last motion of line N of the main program. Lines with motions that the
/// truth leaves out are problems.
std::string compareLineEnds(const std::string& truth, const std::vector<GoldenMotion>& motions) {
  std::map<std::uint32_t, const GoldenMotion*> ends;
  for (const GoldenMotion& m : motions) ends[m.motion.source.line] = &m;
  std::istringstream in(truth);
  std::string problems;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    std::istringstream words(line);
    std::string word, rest;
    std::uint32_t number = 0;
    if (!(words >> word >> number) || word != "line" || !std::getline(words, rest))
      throw std::runtime_error("line N expected: " + line);
    if (const auto end = ends.find(number); end == ends.end()) {
      problems += fmt::format("line {} does not move\n", number);
    } else {
      compareLine(rest, *end->second, fmt::format("end of line {}", number), problems);
      ends.erase(end);
    }
  }
  for (const auto& [number, motion] : ends) problems += fmt::format("line {} is not told\n", number);
  return problems;
}

}  // namespace

std::string compareWithTruth(const std::string& truth, const std::vector<GoldenMotion>& motions) {
  if (truth.starts_with("line ")) return compareLineEnds(truth, motions);
  std::istringstream in(truth);
  std::string problems;
  std::size_t index = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line.starts_with("length ")) {
      compareLength(line, motions, problems);
      continue;
    }
    if (index >= motions.size()) return problems + "truth has more motions: " + line + "\n";
    const GoldenMotion& m = motions[index++];
    compareLine(line, m, fmt::format("motion {} (line {})", index, m.motion.source.line), problems);
  }
  if (!truth.empty() && index < motions.size()) {
    problems += fmt::format("{} motions instead of {}\n", motions.size(), index);
  }
  return problems;
}

}  // namespace proveout::test
