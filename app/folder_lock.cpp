#include "app/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>
#include <utility>

namespace proveout {

namespace {

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Whether the descriptor is of the folder that has this name now: results may have been swapped in
/// meanwhile.
bool isStill(int descriptor, const std::string& folder) {
  struct stat held {};
  struct stat named {};
  if (::fstat(descriptor, &held) != 0 || ::stat(folder.c_str(), &named) != 0) return true;
  return held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FolderLock::~FolderLock() { release(); }

void FolderLock::release() noexcept {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

FolderLock::Outcome FolderLock::wait(double until_s) {
  while (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return Outcome::kUnknown;
    if (now() >= until_s) return Outcome::kBusy;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return Outcome::kTaken;
}

FolderLock::Outcome FolderLock::take(const std::string& folder, double wait_s) {
  const double until_s = now() + wait_s;
  for (;;) {
    release();
    descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) return Outcome::kUnknown;
    const Outcome outcome = wait(until_s);
    if (outcome != Outcome::kTaken || isStill(descriptor_, folder)) return outcome;
  }
}

}  // namespace proveout
