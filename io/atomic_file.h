// Files that appear whole or not at all.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace proveout {

/// Lives while a file is in the making that must be finished or removed before the process may end itself.
class UnfinishedFile {
 public:
  UnfinishedFile() noexcept;
  UnfinishedFile(const UnfinishedFile&) noexcept : UnfinishedFile() {}
  UnfinishedFile& operator=(const UnfinishedFile&) = default;
  ~UnfinishedFile();
  static bool any() noexcept;  ///< of any thread; async-signal-safe
};

/// Writes aside, to a new file in the folder of `path`, and renames on commit(). Without a commit the file
/// aside is removed and what stood at `path` is left alone. A symbolic link at `path` is followed; a device
/// (/dev/null) or pipe is written directly. Not thread-safe.
class AtomicFile {
 public:
  static Result<AtomicFile> create(const std::string& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Errors (disk full, ...) are kept and reported by commit(); writing after one does nothing.
  void write(const void* data, std::size_t size);
  void write(std::string_view text) { write(text.data(), text.size()); }

  /// Closes and renames. Error: names the file and the system's reason. Call once.
  Status commit();

 private:
  AtomicFile() = default;
  void discard() noexcept;

  std::FILE* file_ = nullptr;
  std::string path_;    ///< as asked for, for messages
  std::string target_;  ///< what is replaced
  std::string aside_;   ///< empty: writing to the target directly
  int error_ = 0;       ///< errno of the first failed write
  UnfinishedFile unfinished_;
};

/// Errors: a name on the way to the file, or the whole path, is longer than the file system takes. What is made on the
/// way to a file (a name aside, a folder aside) takes no more room than is counted here.
Status checkNameLength(const std::string& path);

/// Writes `bytes` to `path`, whole or not at all.
Status writeFileAtomically(const std::string& path, std::string_view bytes);

/// Done if `path` is a regular file that can be read; else names what it is.
Status checkRegularFile(const std::string& path);

/// Reads a whole regular file. Errors: missing, a folder or device, unreadable, larger than `max_bytes`.
Result<std::string> readWholeFile(const std::string& path, std::size_t max_bytes);

/// "PATH: WHAT: the system's reason"; a full disk is a limit of the machine. `error`: errno.
Error folderError(const std::string& path, const std::string& what, int error);

/// Makes `path` and the folders above it, where they do not exist. Error: names the one that cannot be made.
Status makeFolders(const std::string& path);

}  // namespace proveout
