// What a stage of the pipe asks of its channel behind an error.
#pragma once

namespace proveout::nc {

class StageRecovery {
 public:
  /// Forgets what waits in the pipe; the program goes on from where the tool is.
  virtual void recover() = 0;

 protected:
  ~StageRecovery() = default;
};

}  // namespace proveout::nc
