// The files of a run are made in a folder aside and moved into place together at the end, so that a run that
// fails, is interrupted or killed leaves earlier results alone.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/folder_lock.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "io/atomic_file.h"
#include "io/output_guard.h"

namespace proveout {

/// A folder inside the target that is removed with what is left in it when the object goes; so are folders
/// that were made for it and are empty. What killed runs left aside in the target is removed when it is made.
class StagingFolder {
 public:
  /// Makes `target` and a new folder in it. `guard`: nothing is written over its files; `progress`: once it
  /// is cancelled nothing is written any more and commit() does nothing. Both may be null, and must outlive
  /// this.
  static Result<StagingFolder> create(const std::string& target, const OutputGuard* guard = nullptr,
                                      const Progress* progress = nullptr);
  StagingFolder(StagingFolder&& other) noexcept;
  StagingFolder(const StagingFolder&) = delete;
  ~StagingFolder();

  /// Lets `make` write the file that will be called `name` to a path aside. A file that fails is left out.
  /// Errors: those of `make`; a folder stands in the target under that name; the guard forbids it.
  Status write(const std::string& name, const std::function<Status(const std::string& path)>& make);
  /// Puts all files into the target at once, by a swap of folders or behind a journal (result_moves.h): a
  /// command that is killed meanwhile leaves the old set or the new one. Waits for another run that is at it.
  /// Of files that could not be made, those of an earlier run are removed; if report.json is one of them
  /// nothing is moved. Call once, when all are complete. The error is that of the first file that cannot be
  /// moved; the others are, but for report.json.
  Status commit();

 private:
  StagingFolder() = default;
  std::string asTarget(std::string message) const;

  std::string target_, aside_;
  std::vector<std::string> names_;
  struct Missing {
    std::string name, why;
  };
  std::vector<Missing> missing_;   ///< what could not be made
  std::vector<std::string> made_;  ///< folders that were not there, the innermost first
  FolderLock in_use_;              ///< says that the folder aside belongs to a process that lives
  const OutputGuard* guard_ = nullptr;
  const Progress* progress_ = nullptr;
  UnfinishedFile unfinished_;
};

}  // namespace proveout
