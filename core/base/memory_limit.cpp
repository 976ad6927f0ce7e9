#include "core/base/memory_limit.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <mutex>

namespace proveout {

namespace {

std::atomic<double> limit_bytes{0.0};
std::mutex refusal_mutex;
std::optional<Error> refusal;

/// Bytes of this process that are in memory.
double residentBytes() {
  std::ifstream info("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  info >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace

MemoryLimit::~MemoryLimit() {
  if (!own_) return;
  limit_bytes.store(0.0);
  const std::lock_guard<std::mutex> lock(refusal_mutex);
  refusal.reset();
}

void MemoryLimit::set(double bytes) {
  // What the program takes with nothing read; less is refused by what predicts the work.
  constexpr double kOwnBytes = 64e6;
  if (limit_bytes.load() > 0.0 || !(bytes > 0.0)) return;
  limit_bytes.store(std::max(bytes, kOwnBytes));
  own_ = true;
}

Status memoryFor(double more, const std::string& what) {
  const double limit = limit_bytes.load();
  if (limit <= 0.0) return Done{};
  const double needed = residentBytes() + more;
  if (needed <= limit) return Done{};
  Error error{ErrorKind::kResourceLimit,
              fmt::format("{} would take about {:.0f} MB, {:.0f} MB are allowed; allow more (--max-memory)",
                          what, 1e-6 * needed, 1e-6 * limit)};
  const std::lock_guard<std::mutex> lock(refusal_mutex);
  if (!refusal) refusal = error;
  return error;
}

bool memorySpent() {
  const double limit = limit_bytes.load();
  return limit > 0.0 && residentBytes() > limit;
}

std::optional<Error> memoryRefusal() {
  const std::lock_guard<std::mutex> lock(refusal_mutex);
  return refusal;
}

}  // namespace proveout
