// Lines of a text that was made of several files, told as lines of these.
#pragma once

#include <map>
#include <vector>

#include "app/session/programs/interpretation.h"

namespace proveout {

/// Passes a path on with the places in its source that ProgramText::origins says.
class OriginSink : public MotionSink {
 public:
  /// Both must outlive this.
  OriginSink(MotionSink& next, const RecordingSource& source) : next_(next), source_(source) {}

  void file(std::uint32_t index, const std::string& name) override;
  void motion(const Motion& motion, const ArcGeometry* arc, const AxisSweep* axis) override;
  void wireMotion(const Motion& motion, const WireSweep& wire) override;
  void event(const PathEvent& event) override;
  void diagnostic(const Diagnostic& diagnostic) override;
  void originWord(const WordOrigin& word) override;
  void originData(const DataInForce& data) override { next_.originData(data); }
  void originModal(const ModalOrigins& modal) override { next_.originModal(modal); }
  void originSet(const OriginSet& set) override { next_.originSet(set); }

 private:
  /// A file of the sender: its number for the receiver, of the first of its files where it has several.
  struct File {
    std::uint32_t first = 0;
    const TextOrigins* origins = nullptr;
  };
  void place(std::uint32_t& file, std::uint32_t& line) const;

  MotionSink& next_;
  const RecordingSource& source_;
  std::vector<File> files_;
  std::uint32_t sent_ = 0;  ///< files that the receiver knows
};

}  // namespace proveout
