#include "io/path_writer.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "core/base/printable.h"
#include "core/path/pose_sweep.h"

namespace proveout {
namespace {

using Buffer = TextBuffer;

/// Text goes to the stream in pieces of this size.
constexpr std::size_t kFlushBytes = 1 << 16;
constexpr double kTick = 1e9;       ///< numbers are rounded to 1e-9
constexpr double kMaxTicked = 9e9;  ///< larger numbers do not fit the 64-bit tick count

[[gnu::always_inline]] inline void put(Buffer& b, std::string_view text) {
  b.append(text.data(), text.size());
}

void putInteger(Buffer& b, std::int64_t value) {
  constexpr std::size_t kMost = 20;
  char* from = b.room(kMost);
  b.advance(static_cast<std::size_t>(std::to_chars(from, from + kMost, value).ptr - from));
}

/// The decimals of `fraction` (in ticks, above 0) without trailing zeros, behind a point.
void putFraction(Buffer& b, std::int64_t fraction) {
  int width = 9;
  if (fraction % 100000 == 0) {  // most programs have four decimals at most
    fraction /= 100000;
    width = 4;
  }
  char digits[10] = {'.'};
  for (int i = width; i >= 1; --i) {
    digits[i] = static_cast<char>('0' + fraction % 10);
    fraction /= 10;
  }
  while (digits[width] == '0') --width;
  b.append(digits, static_cast<std::size_t>(width) + 1);
}

/// Rounded to 1e-9, no trailing zeros, no -0.
void putNumber(Buffer& b, double value) {
  if (!(std::abs(value) < kMaxTicked)) {
    fmt::format_to(std::back_inserter(b), "{}", value);
    return;
  }
  std::int64_t ticks = std::llround(value * kTick);
  if (ticks < 0) {
    b.push_back('-');
    ticks = -ticks;
  }
  constexpr std::int64_t kPerUnit = 1000000000;
  putInteger(b, ticks / kPerUnit);
  if (ticks % kPerUnit != 0) putFraction(b, ticks % kPerUnit);
}

void putVector(Buffer& b, const Vec3& v) {
  b.push_back('[');
  putNumber(b, v.x());
  b.push_back(',');
  putNumber(b, v.y());
  b.push_back(',');
  putNumber(b, v.z());
  b.push_back(']');
}

void putString(Buffer& b, std::string_view text) { put(b, jsonQuoted(text)); }

/// A value of an event; -0 is 0.
template <typename Value>
void putValue(Buffer& b, const Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    putString(b, value);
  } else if constexpr (std::is_same_v<Value, double>) {
    put(b, fmt::format("{}", value == 0.0 ? 0.0 : value));
  } else {
    put(b, fmt::format("{}", value));
  }
}

void send(Buffer& b, std::ostream& out) {
  out.write(b.view().data(), static_cast<std::streamsize>(b.size()));
  b.clear();
}

}  // namespace

JsonLinesPathWriter::JsonLinesPathWriter(std::ostream& out, std::string_view control) : out_(out) {
  put(buffer_, R"({"type":"header","schema":"proveout.path/1","control":)");
  putString(buffer_, control);
  put(buffer_, R"(,"frame":"workpiece"})");
  endLine();
}

JsonLinesPathWriter::~JsonLinesPathWriter() { flush(); }

void JsonLinesPathWriter::flush() {
  send(buffer_, out_);
  out_.flush();
}

void JsonLinesPathWriter::endLine() {
  buffer_.push_back('\n');
  if (buffer_.size() >= kFlushBytes) send(buffer_, out_);
}

void JsonLinesPathWriter::file(std::uint32_t index, const std::string& name) {
  if (files_.size() <= index) files_.resize(index + 1, "\"\"");
  Buffer quoted;
  putString(quoted, name);
  files_[index] = quoted.view();
}

void JsonLinesPathWriter::source(const SourceRef& source) {
  put(buffer_, R"(,"source":{"file":)");
  put(buffer_, source.file < files_.size() ? std::string_view(files_[source.file]) : "\"\"");
  put(buffer_, R"(,"line":)");
  putInteger(buffer_, source.line);
  put(buffer_, source.block >= 0 ? R"(,"block":"N)" : R"(,"block":")");
  if (source.block >= 0) putInteger(buffer_, source.block);
  put(buffer_, R"(","depth":)");
  putInteger(buffer_, source.depth);
  put(buffer_, "}}");
  endLine();
}

void JsonLinesPathWriter::point(const Vec3& p) {
  if (point_text_.size() == 0 || !(point_ == p)) {
    point_ = p;
    point_text_.clear();
    putVector(point_text_, p);
  }
  put(buffer_, point_text_.view());
}

void JsonLinesPathWriter::technology(const Motion& motion) {
  if (technology_text_.size() == 0 || !(technology_.feed == motion.feed && technology_.tool == motion.tool &&
                                        technology_.spindle == motion.spindle)) {
    technology_ = motion;
    Buffer& b = technology_text_;
    b.clear();
    put(b, R"(,"feed":)");
    putNumber(b, motion.feed);
    put(b, R"(,"tool":)");
    putInteger(b, motion.tool);
    put(b, R"(,"spindle":)");
    putNumber(b, motion.spindle);
  }
  put(buffer_, technology_text_.view());
}

namespace {

void putChannel(Buffer& b, int channel) {
  if (channel == 0) return;
  put(b, R"(,"channel":)");
  putInteger(b, channel);
}

/// Numbers of single precision: angles are good to 3e-5 degrees.
void putThread(Buffer& b, const Motion& motion) {
  const auto rounded = [](double value, double steps) { return std::round(steps * value) / steps; };
  const double start = rounded(motion.thread_start_deg, 1e4);
  const double change = rounded(motion.thread_pitch_change, 1e6);
  if (start != 0.0) {
    put(b, R"(,"start_deg":)");
    putNumber(b, start < 360.0 ? start : 0.0);
  }
  if (change != 0.0) {
    put(b, R"(,"pitch_change":)");
    putNumber(b, change);
  }
}

/// X, Y, Z of the machine at both ends; the rotary axes are told apart from them.
void putPose(Buffer& b, const PoseSweep& pose) {
  put(b, R"(,"machine_from":)");
  putVector(b, pose.axes_from.xyz);
  put(b, R"(,"machine_to":)");
  putVector(b, pose.axes_to.xyz);
  if (pose.beyond == 0.0) return;
  put(b, R"(,"beyond":)");
  putNumber(b, pose.beyond);
}

void putAxis(Buffer& b, const AxisSweep& axis) {
  if (!axis.alongZ()) {
    put(b, R"(,"axis_from":)");
    putVector(b, axis.from);
    put(b, R"(,"axis_to":)");
    putVector(b, axis.to);
  }
  if (axis.pose != nullptr || axis.from != axis.to) {
    put(b, R"(,"law":")");
    put(b, poseLawName(axis.law));
    b.push_back('"');
  }
  if (axis.pose != nullptr) putPose(b, *axis.pose);
  for (int k = 0; k < axis.rotary_count; ++k) {
    const RotaryPosition& rotary = axis.rotary[static_cast<std::size_t>(k)];
    put(b, k == 0 ? R"(,"rotary":{")" : R"(,")");
    put(b, rotary.name.data());
    put(b, R"(":[)");
    putNumber(b, rotary.from);
    b.push_back(',');
    putNumber(b, rotary.to);
    put(b, k + 1 == axis.rotary_count ? "]}" : "]");
  }
}

}  // namespace

void JsonLinesPathWriter::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) {
  Buffer& b = buffer_;
  put(b, R"({"type":"motion","id":)");
  putInteger(b, next_id_++);
  put(b, R"(,"kind":")");
  put(b, motionKindName(motion.kind));
  put(b, arc ? R"(","shape":"arc","from":)" : R"(","shape":"line","from":)");
  point(motion.from);
  put(b, R"(,"to":)");
  point(motion.to);
  if (arc) {
    put(b, R"(,"center":)");
    putVector(b, arc->center);
    put(b, R"(,"normal":)");
    putVector(b, arc->normal);
    put(b, R"(,"sweep_deg":)");
    putNumber(b, radToDeg(arc->sweep_rad));
  }
  if (axis != nullptr) putAxis(b, *axis);
  technology(motion);
  if (motion.kind == MotionKind::kThread) putThread(b, motion);
  put(b, R"(,"time_s":)");
  putNumber(b, motion.time_s);
  putChannel(b, motion.channel);
  source(motion.source);
}

namespace {

const char* wireKind(const Motion& motion) { return motion.kind == MotionKind::kRapid ? "rapid" : "cut"; }

void putPlanePoint(Buffer& b, const Vec2& p) {
  b.push_back('[');
  putNumber(b, p.x());
  b.push_back(',');
  putNumber(b, p.y());
  b.push_back(']');
}

}  // namespace

void JsonLinesPathWriter::track(std::string_view name, const WireTrack& track) {
  Buffer& b = buffer_;
  put(b, R"(,")");
  put(b, name);
  put(b, R"(":{"from":)");
  putPlanePoint(b, track.from);
  put(b, R"(,"to":)");
  putPlanePoint(b, track.to);
  if (track.sweep_rad != 0.0) {
    put(b, R"(,"center":)");
    putPlanePoint(b, track.center);
    put(b, R"(,"sweep_deg":)");
    putNumber(b, radToDeg(track.sweep_rad));
  }
  b.push_back('}');
}

/// What is as usual is not told: a threaded wire that can cut, without an offset.
void JsonLinesPathWriter::wireState(const Motion& motion, const WireState& state) {
  const auto tell = [&](bool unusual, std::string_view text) {
    if (unusual) put(buffer_, text);
  };
  tell(motion.compensated, R"(,"offset":true)");
  tell(!state.threaded, R"(,"threaded":false)");
  tell(state.by_hand, R"(,"by_hand":true)");
  tell(!state.runs, R"(,"runs":false)");
  tell(!state.fluid, R"(,"fluid":false)");
  tell(!state.condition, R"(,"condition":false)");
}

void JsonLinesPathWriter::wireMotion(const Motion& motion, const WireSweep& wire) {
  Buffer& b = buffer_;
  put(b, R"({"type":"motion","id":)");
  putInteger(b, next_id_++);
  put(b, R"(,"kind":")");
  put(b, wireKind(motion));
  put(b, R"(","z":)");
  putPlanePoint(b, {wire.z_low, wire.z_high});
  track("lower", wire.lower);
  track("upper", wire.upper);
  wireState(motion, wire.state);
  put(b, R"(,"feed":)");
  putNumber(b, motion.feed);
  put(b, R"(,"time_s":)");
  putNumber(b, motion.time_s);
  putChannel(b, motion.channel);
  source(motion.source);
}

void JsonLinesPathWriter::event(const PathEvent& event) {
  put(buffer_, R"({"type":"event","event":)");
  putString(buffer_, eventName(event.what));
  put(buffer_, R"(,"data":{)");
  bool first = true;
  forEachField(event.what, [&](std::string_view key, const auto& value) {
    if (!first) buffer_.push_back(',');
    first = false;
    putString(buffer_, key);
    buffer_.push_back(':');
    putValue(buffer_, value);
  });
  buffer_.push_back('}');
  if (event.time_s > 0.0) {
    put(buffer_, R"(,"time_s":)");
    putNumber(buffer_, event.time_s);
  }
  putChannel(buffer_, event.channel);
  source(event.source);
}

void JsonLinesPathWriter::diagnostic(const Diagnostic& diagnostic) {
  Buffer& b = buffer_;
  put(b, R"({"type":"diagnostic","severity":")");
  put(b, severityName(diagnostic.severity));
  put(b, R"(","code":)");
  putString(b, diagnostic.code);
  put(b, R"(,"message":)");
  putString(b, diagnostic.message);
  put(b, R"(,"source":{"file":)");
  putString(b, diagnostic.where.file);
  put(b, R"(,"line":)");
  putInteger(b, diagnostic.where.line);
  put(b, R"(,"column":)");
  putInteger(b, diagnostic.where.column);
  if (!diagnostic.source_line.empty()) {
    put(b, R"(,"text":)");
    putString(b, diagnostic.source_line);
  }
  put(b, "}");
  for (std::size_t k = 0; k < diagnostic.notes.size(); ++k) {
    put(b, k == 0 ? R"(,"notes":[)" : ",");
    putString(b, diagnostic.notes[k]);
  }
  put(b, diagnostic.notes.empty() ? "}" : "]}");
  endLine();
}

CsvPathWriter::CsvPathWriter(std::ostream& out) : out_(out) {}

CsvPathWriter::~CsvPathWriter() { flush(); }

void CsvPathWriter::head() {
  if (headed_) return;
  headed_ = true;
  put(buffer_,
      "id,kind,shape,from_x,from_y,from_z,to_x,to_y,to_z,feed,tool,spindle,time_s,"
      "center_x,center_y,center_z,normal_x,normal_y,normal_z,sweep_deg,file,line,block,depth");
  put(buffer_, channels_ ? ",channel\n" : "\n");
}

void CsvPathWriter::flush() {
  head();
  send(buffer_, out_);
  out_.flush();
}

void CsvPathWriter::file(std::uint32_t index, const std::string& name) {
  if (files_.size() <= index) files_.resize(index + 1);
  files_[index] = csvField(name);
}

void CsvPathWriter::motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep*) {
  row(motion, motionKindName(motion.kind), arc);
  ++next_id_;
}

void CsvPathWriter::wireMotion(const Motion& motion, const WireSweep& wire) {
  const auto track = [&](const WireTrack& t, double z) {
    const auto at = [z](const Vec2& p) { return Vec3(p.x(), p.y(), z); };
    Motion point = motion;
    point.from = at(t.from);
    point.to = at(t.to);
    const ArcGeometry arc{at(t.center), Vec3::UnitZ(), t.sweep_rad};
    row(point, wireKind(motion), t.sweep_rad != 0.0 ? &arc : nullptr);
  };
  track(wire.lower, wire.z_low);
  track(wire.upper, wire.z_high);
  ++next_id_;
}

void CsvPathWriter::row(const Motion& motion, std::string_view kind, const ArcGeometry* arc) {
  Buffer& b = buffer_;
  const auto number = [&](double value) {
    putNumber(b, value);
    b.push_back(',');
  };
  const auto vector = [&](const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) number(v[axis]);
  };
  channels_ = channels_ || (!headed_ && motion.channel > 0);
  head();
  putInteger(b, next_id_);
  b.push_back(',');
  put(b, kind);
  put(b, arc ? ",arc," : ",line,");
  vector(motion.from);
  vector(motion.to);
  number(motion.feed);
  putInteger(b, motion.tool);
  b.push_back(',');
  number(motion.spindle);
  number(motion.time_s);
  if (arc) {
    vector(arc->center);
    vector(arc->normal);
    number(radToDeg(arc->sweep_rad));
  } else {
    put(b, ",,,,,,,");
  }
  const SourceRef& s = motion.source;
  if (s.file < files_.size()) put(b, files_[s.file]);
  b.push_back(',');
  putInteger(b, s.line);
  put(b, s.block >= 0 ? ",N" : ",");
  if (s.block >= 0) putInteger(b, s.block);
  b.push_back(',');
  putInteger(b, s.depth);
  if (channels_) {
    b.push_back(',');
    putInteger(b, motion.channel);
  }
  b.push_back('\n');
  if (b.size() >= kFlushBytes) send(b, out_);
}

void CsvPathWriter::event(const PathEvent& event) { (void)event; }

void CsvPathWriter::diagnostic(const Diagnostic& diagnostic) { (void)diagnostic; }

Result<std::unique_ptr<MotionSink>> makePathWriter(std::string_view format, std::ostream& out,
                                                   std::string_view control) {
  if (format == "jsonl")
    return std::unique_ptr<MotionSink>(std::make_unique<JsonLinesPathWriter>(out, control));
  if (format == "csv") return std::unique_ptr<MotionSink>(std::make_unique<CsvPathWriter>(out));
  return inputError(fmt::format("unknown path format {} (known: jsonl, csv)", format));
}

}  // namespace proveout
