// ZIP archives in memory, as 3MF packages are (APPNOTE.TXT 6.3; ISO/IEC 21320-1), by minizip.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace proveout {

/// An archive in the making. The bytes depend on names and contents alone: all times are 1 January 1980.
class ZipWriter {
 public:
  ZipWriter();
  ~ZipWriter();
  ZipWriter(const ZipWriter&) = delete;

  /// Opens the next file. `large`: more than 4 GB may come.
  void begin(const std::string& name, bool large = false);
  void write(std::string_view bytes);
  /// The archive. Error: the library failed. Call once.
  Result<std::string> finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Reads files of an archive in memory.
class ZipReader {
 public:
  /// `bytes` must outlive it. Errors: no archive, or a damaged one.
  static Result<ZipReader> open(std::string_view bytes);
  ZipReader(ZipReader&&) noexcept;
  ~ZipReader();

  /// Size of a file when it is unpacked; -1: there is none of that name (compared without regard to case, as
  /// names of parts are).
  std::int64_t sizeOf(const std::string& name);
  /// Unpacks a file piece by piece. Errors: none of that name, encrypted, packed in a way that is not known,
  /// longer than its head says, a wrong check sum; and what `take` returns.
  Status read(const std::string& name, const std::function<Status(std::string_view piece)>& take);

 private:
  struct State;
  explicit ZipReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace proveout
