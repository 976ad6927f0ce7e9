#include "core/nc/control/control_host.h"

#include <fmt/core.h>

namespace proveout {

namespace {

/// More names than this are no measuring records: a loop counts them up.
constexpr std::size_t kMostFiles = 1000;

}  // namespace

Status MemoryOutput::open(const std::string& name, bool append) {
  if (files_.size() >= kMostFiles && !exists(name)) {
    return Error{ErrorKind::kResourceLimit,
                 fmt::format("the program writes more than {} files: {} is one too many", kMostFiles, name)};
  }
  open_ = &files_[name];
  if (!append) {
    size_ -= open_->size();
    open_->clear();
  }
  return Done{};
}

Status MemoryOutput::write(std::string_view bytes) {
  if (open_ == nullptr) return Error{ErrorKind::kInternal, "no output file is open"};
  if (bytes.size() > limit_ - size_) {
    return Error{ErrorKind::kResourceLimit,
                 fmt::format("the files that the program writes exceed {} bytes", limit_)};
  }
  open_->append(bytes);
  size_ += bytes.size();
  return Done{};
}

Status MemoryOutput::close() {
  open_ = nullptr;
  return Done{};
}

}  // namespace proveout
