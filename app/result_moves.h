// How a complete set of files comes into the folder of results, so that a command that is killed at any
// moment leaves the old set or the new one. Where the folder can be replaced by another one, it is, by one
// call of the system. Where it cannot, files are moved one by one behind a journal, which the next command
// that writes or reads there carries out.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"

namespace proveout {

/// Moved last and taken away first: it vouches for the others.
inline constexpr const char* kReportName = "report.json";

/// What is to come into a folder. The caller has the folder's lock, and has settled it.
struct ResultChange {
  std::string target;
  std::string aside;                 ///< folder inside the target, with the new files
  std::vector<std::string> files;    ///< below `aside`, and below the target when they are there
  std::vector<std::string> removed;  ///< files below the target that must go
};

/// Puts a folder with the new files, and with what else stands in the target, in the target's place. False,
/// with nothing changed, where that cannot be done: the system or the file system cannot exchange folders,
/// the folder is mounted, is what the process works in, belongs to somebody else, has lists of rights or much
/// besides results in it, or its own folder cannot be written.
bool swapResults(const ResultChange& change);

/// Moves the files one by one behind a journal. The error is that of the first file that cannot be moved; the
/// others are, but for report.json.
Status moveResults(const ResultChange& change);

/// Carries out what a killed command left half done in a folder of results. Done where there is nothing to
/// do, which takes a look at one name. Waits for a command that is at it. Errors: names what cannot be moved.
Status settleResults(const std::string& folder);

/// The same with the folder's lock in the caller's hand; takes away what a killed swap left beside the
/// folder, too.
Status settleLocked(const std::string& folder);

}  // namespace proveout
