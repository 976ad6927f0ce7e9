#include "core/base/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <new>
#include <string>

namespace proveout {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kMega = 1e6;

/// The number behind a key of a file of lines "key number", as files of /proc and of control groups are;
/// below 0: none.
double numberIn(const std::string& file, std::string_view wanted) {
  std::ifstream in(file);
  std::string key, rest;
  double number = -1.0;
  while (in >> key >> number) {
    if (key == wanted) return number;
    std::getline(in, rest);
  }
  return -1.0;
}

/// As above, of files of lines whose values are not all numbers.
double kilobytesOfProcess(std::string_view wanted) {
  std::ifstream in("/proc/self/status");
  std::string key, rest;
  while (in >> key && key != wanted) std::getline(in, rest);
  double kilobytes = 0.0;
  return in >> kilobytes ? kilobytes : 0.0;
}

double freeBytes() {
  const double kilobytes = numberIn("/proc/meminfo", "MemAvailable:");
  if (kilobytes >= 0.0) return kilobytes * 1024.0;
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// What the process has left of one of its limits.
MemoryBound leftOf(int resource, std::string_view taken, const char* what, const char* way) {
  rlimit limit{};
  if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return {kInfinite, {}};
  const double allowed = static_cast<double>(limit.rlim_cur);
  return {std::max(0.0, allowed - 1024.0 * kilobytesOfProcess(taken)),
          fmt::format("this process may have {:.0f} MB of {} ({})", allowed / kMega, what, way)};
}

/// The folder of the process's control group (version 2); empty: none.
std::string groupFolder() {
  std::ifstream in("/proc/self/cgroup");
  std::string line;
  while (std::getline(in, line)) {
    if (line.starts_with("0::")) return "/sys/fs/cgroup" + line.substr(3);
  }
  return {};
}

MemoryBound leftOfGroup() {
  const std::string folder = groupFolder();
  double most = -1.0, taken = -1.0;
  if (folder.empty() || !(std::ifstream(folder + "/memory.max") >> most) ||
      !(std::ifstream(folder + "/memory.current") >> taken))
    return {kInfinite, {}};
  // Pages of files are counted, too, and go where memory is wanted.
  const double files = std::max(0.0, numberIn(folder + "/memory.stat", "inactive_file"));
  return {std::max(0.0, most - std::max(0.0, taken - files)),
          fmt::format("the control group of this process may have {:.0f} MB (memory.max)", most / kMega)};
}

const MemoryBound& tighter(const MemoryBound& a, const MemoryBound& b) { return b.bytes < a.bytes ? b : a; }

/// The limit of which allocations fail; that of a control group ends processes instead.
MemoryBound allocationBound() {
  return tighter(leftOf(RLIMIT_AS, "VmSize:", "address space", "ulimit -v"),
                 leftOf(RLIMIT_DATA, "VmData:", "data", "ulimit -d"));
}

}  // namespace

MemoryBound processMemoryBound() { return tighter(allocationBound(), leftOfGroup()); }

MemoryBound memoryBound() { return tighter({freeBytes(), {}}, processMemoryBound()); }

double availableMemoryBytes() { return memoryBound().bytes; }

Error outOfMemory(std::string_view what, std::string_view advice) {
  try {
    const std::string reason = allocationBound().reason;
    const std::string way = reason.empty() ? std::string(advice) : reason + ": allow more";
    return {ErrorKind::kResourceLimit, fmt::format("{}; {}", what, way)};
  } catch (const std::bad_alloc&) {
    return {ErrorKind::kResourceLimit, "out of memory"};  // short enough to need none
  }
}

}  // namespace proveout
