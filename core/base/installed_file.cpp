#include "core/base/installed_file.h"

#include <filesystem>
#include <system_error>

namespace proveout {

std::vector<std::string> installedFiles(std::string_view name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  std::vector<std::string> out;
  for (const fs::path& folder : {prefix / "lib" / "proveout", prefix / PROVEOUT_LIBDIR / "proveout",
                                 fs::path(PROVEOUT_FULL_LIBDIR) / "proveout"}) {
    const fs::path path = folder / name;
    if (fs::exists(path, ignored)) out.push_back(path.string());
  }
  return out;
}

}  // namespace proveout
