#include "io/program_reach.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <system_error>
#include <utility>

namespace proveout {

namespace fs = std::filesystem;

namespace {

/// Absolute, links followed, without "." and ".."; nothing: a folder on the way cannot be read, or links go
/// in a circle.
std::optional<fs::path> resolved(const fs::path& place) {
  std::error_code error;
  const fs::path absolute = fs::absolute(place.empty() ? fs::path(".") : place, error);
  if (error) return std::nullopt;
  fs::path real = fs::weakly_canonical(absolute, error);
  if (error) return std::nullopt;
  if (!real.has_filename()) real = real.parent_path();  // "a/" is a
  return real;
}

bool isBelow(const fs::path& place, const fs::path& root) {
  const auto [end, unused] = std::mismatch(root.begin(), root.end(), place.begin(), place.end());
  return end == root.end();
}

}  // namespace

void ProgramReach::addFolder(const fs::path& folder) {
  if (auto real = resolved(folder)) roots_.push_back(std::move(*real));
}

void ProgramReach::addFile(const fs::path& file) {
  if (auto real = resolved(file)) files_.push_back(std::move(*real));
}

void ProgramReach::addSibling(const fs::path& folder, const std::string& name) {
  if (const auto real = resolved(folder)) roots_.push_back(real->parent_path() / name);
}

bool ProgramReach::holds(const fs::path& place) const {
  const auto real = resolved(place);
  if (!real) return false;
  return std::find(files_.begin(), files_.end(), *real) != files_.end() ||
         std::any_of(roots_.begin(), roots_.end(),
                     [&](const fs::path& root) { return isBelow(*real, root); });
}

bool namesDrive(const std::string& path) {
  return path.size() >= 2 && std::isalpha(static_cast<unsigned char>(path[0])) && path[1] == ':';
}

}  // namespace proveout
