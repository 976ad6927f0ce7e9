// Why the spindle stands while a tool cuts.
#pragma once

#include <string>

#include "app/session/programs/interpretation.h"

namespace proveout {

/// Looks for what the program says of its spindle.
class StandingSpindle {
 public:
  /// Both must outlive this.
  StandingSpindle(const Toolpath& path, const RecordingSource& texts) : path_(path), texts_(texts) {}

  /// The program says nothing that makes a spindle turn or stop (M3, M4, M5, M19): a person starts it. Of a
  /// program with several channels: none of them does.
  bool isOperators() const;

  /// Since when or why it stands during the motion, as the end of a sentence: ", since M5 (O0100:12)".
  std::string reason(MotionId motion) const;

 private:
  std::string place(const PathEvent& event) const;

  const Toolpath& path_;
  const RecordingSource& texts_;
};

}  // namespace proveout
