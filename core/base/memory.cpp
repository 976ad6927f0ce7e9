#include "core/base/memory.h"

#include <unistd.h>

#include <fstream>
#include <string>

namespace proveout {

double availableMemoryBytes() {
  std::ifstream info("/proc/meminfo");
  std::string key, unit;
  double kilobytes = 0.0;
  while (info >> key >> kilobytes) {
    std::getline(info, unit);
    if (key == "MemAvailable:") return kilobytes * 1024.0;
  }
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace proveout
