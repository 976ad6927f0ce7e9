// A file that appears whole or not at all, and the hash of its bytes.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "io/atomic_file.h"
#include "io/sha256.h"

namespace proveout {

class HashedFile {
 public:
  static Result<HashedFile> create(const std::string& path);

  /// Errors are kept and reported by commit().
  void write(std::string_view bytes) {
    hash_.update(bytes.data(), bytes.size());
    file_.write(bytes);
  }
  /// Closes and renames; the SHA-256 of the bytes, 64 hex digits. Call once.
  Result<std::string> commit();

 private:
  explicit HashedFile(AtomicFile&& file) : file_(std::move(file)) {}
  AtomicFile file_;
  Sha256 hash_;
};

/// Writes `bytes` whole or not at all; their SHA-256.
Result<std::string> writeHashed(const std::string& path, std::string_view bytes);

}  // namespace proveout
