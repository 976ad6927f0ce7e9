// Keeps what a command writes away from what it reads.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "core/base/result.h"

namespace proveout {

/// Knows the inputs of a command by the files that they are, whatever way leads to them: links, hard links,
/// `..`, another spelling of the case. Not thread-safe while inputs are added.
class OutputGuard {
 public:
  /// `role` names the input in messages: "nominal", "subprogram". Where no file can be reached at `path`, its
  /// name alone is protected.
  void protect(const std::string& role, const std::string& path);

  /// Error: a file written at `path` would take the place of an input, or would be found in its place by the
  /// next run (names are compared without regard to case, as controls do; names both), or its name is too long
  /// for one. `path` and the folders above it need not exist.
  Status check(const std::string& path) const;

  /// The same for standard output, where it goes into a file.
  Status checkStandardOutput() const;

 private:
  struct Identity {
    dev_t device = 0;
    ino_t inode = 0;
    bool operator==(const Identity&) const = default;
  };
  struct Input {
    std::string role, path;
    bool there = false;
    Identity file;      ///< with links followed
    std::string place;  ///< canonical folder, and the name in lower case
  };
  static std::string placeOf(const std::string& path);
  const Input* find(const Identity& file) const;
  Error refusal(const std::string& output, const Input& input) const;

  std::vector<Input> inputs_;
};

}  // namespace proveout
