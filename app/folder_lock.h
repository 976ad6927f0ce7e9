// Locks on folders, which tell a run that lives from one that was killed.
#pragma once

#include <string>

namespace proveout {

/// A descriptor of a folder with the lock on it, which goes with the object or with the process.
class FolderLock {
 public:
  FolderLock() = default;
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;
  FolderLock(const FolderLock&) = delete;
  ~FolderLock();

  enum class Outcome { kTaken, kBusy, kUnknown };  ///< unknown: this file system has no locks
  /// How long a folder of results is waited for, s: moving files takes a moment; who takes longer hangs.
  static constexpr double kPatienceS = 30.0;
  /// Takes the lock of the folder that has this name when it is taken, if need be after waiting for another
  /// process for up to `wait_s`.
  Outcome take(const std::string& folder, double wait_s);
  void release() noexcept;

 private:
  Outcome wait(double until_s);

  int descriptor_ = -1;
};

}  // namespace proveout
