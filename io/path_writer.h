// Writes what a virtual control does as text while it runs: JSON Lines (schema proveout.path/1) or CSV.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/path/toolpath.h"
#include "io/text_buffer.h"

namespace proveout {

/// One JSON object a line: a header, then motions, events and diagnostics in program order. Lengths mm, feed
/// mm/min, angles degrees; numbers rounded to 1e-9 with no trailing zeros, -0 as 0. `block` is "" where the
/// block has no N. "axis_from" and "axis_to" stand where the tool is not along +z, "rotary" where the machine
/// has rotary axes: {"C":[from,to]}, degrees; "channel" of motions and events where the control has several:
/// motions are then in order of start times. Motions of a wire are of kind "cut" or "rapid" and have "z", the
/// heights of "lower" and "upper", each with "from", "to" and, on arcs, "center" and "sweep_deg";
/// "offset":true where an offset keeps the wire off the contour, "threaded":false where it is cut off,
/// "by_hand":true for rapids behind a stop, and "runs":false, "fluid":false, "condition":false for what
/// cutting lacks.
class JsonLinesPathWriter : public MotionSink {
 public:
  /// Writes the header at once. `out` must outlive the writer; its state tells of write errors.
  JsonLinesPathWriter(std::ostream& out, std::string_view control);
  ~JsonLinesPathWriter() override;
  void file(std::uint32_t index, const std::string& name) override;
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis = nullptr) override;
  void wireMotion(const Motion& motion, const WireSweep& wire) override;
  void event(const PathEvent& event) override;
  void diagnostic(const Diagnostic& diagnostic) override;
  void flush();

 private:
  void endLine();
  void point(const Vec3& p);
  void technology(const Motion& motion);
  void track(std::string_view name, const WireTrack& track);
  void wireState(const Motion& motion, const WireState& state);
  void source(const SourceRef& source);

  std::ostream& out_;
  TextBuffer buffer_;
  std::vector<std::string> files_;  ///< as JSON text
  // Most motions begin where the last one ended, with its feed, tool and spindle: their text is kept.
  Vec3 point_ = Vec3::Zero();
  Motion technology_;
  TextBuffer point_text_, technology_text_;
  MotionId next_id_ = 0;
};

/// A table of the motions, with a header line. Events and diagnostics have no row, rotary axes no column. The
/// last column is the channel where the control has several. A motion of a wire has a row for its lower point
/// and behind it one, of the same id, for its upper point: kind "cut" or "rapid".
class CsvPathWriter : public MotionSink {
 public:
  explicit CsvPathWriter(std::ostream& out);
  ~CsvPathWriter() override;
  void file(std::uint32_t index, const std::string& name) override;
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis = nullptr) override;
  void wireMotion(const Motion& motion, const WireSweep& wire) override;
  void event(const PathEvent& event) override;
  void diagnostic(const Diagnostic& diagnostic) override;
  void flush();

 private:
  void head();
  void row(const Motion& motion, std::string_view kind, const ArcGeometry* arc);

  std::ostream& out_;
  TextBuffer buffer_;
  bool headed_ = false, channels_ = false;
  std::vector<std::string> files_;  ///< quoted where CSV needs it
  MotionId next_id_ = 0;
};

/// `format` is "jsonl" or "csv". Error: another name.
Result<std::unique_ptr<MotionSink>> makePathWriter(std::string_view format, std::ostream& out,
                                                   std::string_view control);

}  // namespace proveout
