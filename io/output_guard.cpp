#include "io/output_guard.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "io/atomic_file.h"
#include "io/mesh_formats.h"

namespace proveout {

namespace fs = std::filesystem;

/// The folder as it is without links, "." and ".."; folders that are not there yet count as they will be
/// made.
std::string OutputGuard::placeOf(const std::string& path) {
  const fs::path given(path);
  const fs::path folder = given.has_parent_path() ? given.parent_path() : fs::path(".");
  std::error_code error;
  fs::path real = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) real = fs::absolute(folder, error).lexically_normal();
  return (real / mesh_formats::lowerCase(given.filename().string())).string();
}

void OutputGuard::protect(const std::string& role, const std::string& path) {
  Input input{role, path, false, {}, placeOf(path)};
  struct stat info {};
  input.there = ::stat(path.c_str(), &info) == 0;
  input.file = {info.st_dev, info.st_ino};
  inputs_.push_back(std::move(input));
}

const OutputGuard::Input* OutputGuard::find(const Identity& file) const {
  const auto same = [&](const Input& input) { return input.there && input.file == file; };
  const auto found = std::find_if(inputs_.begin(), inputs_.end(), same);
  return found == inputs_.end() ? nullptr : &*found;
}

Error OutputGuard::refusal(const std::string& output, const Input& input) const {
  return inputError(fmt::format("{}: would be written over the {}, {}: write to another folder or name",
                                output, input.role, input.path));
}

Status OutputGuard::check(const std::string& path) const {
  if (Status fits = checkNameLength(path); !fits) return fits;
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0) {
    if (const Input* input = find({info.st_dev, info.st_ino})) return refusal(path, *input);
  }
  const std::string place = placeOf(path);
  for (const Input& input : inputs_) {
    if (input.place == place) return refusal(path, input);
  }
  return Done{};
}

Status OutputGuard::checkStandardOutput() const {
  struct stat info {};
  if (::fstat(STDOUT_FILENO, &info) != 0 || !S_ISREG(info.st_mode)) return Done{};
  const Input* const input = find({info.st_dev, info.st_ino});
  return input != nullptr ? Status(refusal("standard output", *input)) : Status(Done{});
}

}  // namespace proveout
