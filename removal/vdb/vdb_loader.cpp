// Loads the module with everything that needs OpenVDB.
#include <dlfcn.h>
#include <fmt/format.h>

#include "core/base/installed_file.h"
#include "core/base/memory.h"
#include "core/base/startable_threads.h"
#include "removal/vdb/vdb_support.h"

namespace proveout {

namespace {

/// OpenVDB's logger starts five threads when it is loaded, and ends the process where it cannot.
constexpr int kModuleThreads = 8;

Result<const VdbSupport*> loadModule() {
  if (startableThreads(kModuleThreads) < kModuleThreads) {
    return outOfMemory(
        "no threads may be started, and what reads and writes .vdb files and mesh blanks needs some",
        "allow more processes (ulimit -u), or do without .vdb files and meshes as blank or fixture");
  }
  const char* kName = "libproveout_vdb.so";
  std::string reason = "no such file";
  for (const std::string& path : installedFiles(kName)) {
    if (void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) {
      using Entry = const VdbSupport* (*)();
      if (const auto entry = reinterpret_cast<Entry>(dlsym(module, "proveoutVdbSupport"))) return entry();
    }
    if (const char* error = dlerror()) reason = error;
  }
  return inputError(fmt::format(
      "{}, which reads and writes .vdb files and mesh blanks, cannot be loaded ({}); install proveout "
      "with its lib/proveout folder",
      kName, reason));
}

}  // namespace

Result<const VdbSupport*> vdbSupport() {
  static const Result<const VdbSupport*> support = loadModule();
  return support;
}

Status checkStockFiles() {
  const Result<const VdbSupport*> support = vdbSupport();
  if (!support) return support.error();
  return Done{};
}

Status loadStock(Stock::Impl& impl, const std::string& path, const RemovalOptions& options) {
  const Result<const VdbSupport*> support = vdbSupport();
  if (!support) return support.error();
  return (*support)->load(impl, path, options);
}

Status buildMeshBlank(Stock::Impl& impl, const MeshShape& shape, const RemovalOptions& options) {
  const Result<const VdbSupport*> support = vdbSupport();
  if (!support) return support.error();
  return (*support)->mesh_blank(impl, shape, options);
}

Status Stock::save(const std::string& path) const {
  const Result<const VdbSupport*> support = vdbSupport();
  if (!support) return support.error();
  return (*support)->save(*impl_, path);
}

}  // namespace proveout
