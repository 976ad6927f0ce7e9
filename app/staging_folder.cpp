#include "app/staging_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "app/result_moves.h"
#include "io/atomic_file.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kAsidePrefix = ".proveout-run-";

const Error kStopped{ErrorKind::kInterrupted, "interrupted"};

/// Removes what runs that no longer live have left in the folder. The caller has its lock, so that none is
/// just being made.
void removeAbandoned(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    if (at->path().filename().string().starts_with(kAsidePrefix)) found.push_back(at->path());
  }
  for (const fs::path& aside : found) {
    std::error_code ignored;
    FolderLock owner;
    if (fs::is_symlink(aside, ignored) || !fs::is_directory(aside, ignored)) continue;
    if (owner.take(aside.string(), 0.0) == FolderLock::Outcome::kTaken) fs::remove_all(aside, ignored);
  }
}

}  // namespace

Result<StagingFolder> StagingFolder::create(const std::string& target, const OutputGuard* guard,
                                            const Progress* progress) {
  StagingFolder staging;
  std::error_code error;
  for (fs::path above = fs::path(target).lexically_normal(); !above.empty() && !fs::exists(above, error);
       above = above.parent_path())
    staging.made_.push_back(above.string());
  if (const Status made = makeFolders(target); !made) return made.error();
  FolderLock making;
  if (making.take(target, FolderLock::kPatienceS) == FolderLock::Outcome::kTaken) {
    removeAbandoned(target);
    if (const Status settled = settleLocked(target); !settled) return settled.error();
  }
  std::string pattern = (fs::path(target) / (std::string(kAsidePrefix) + std::string(6, 'X'))).string();
  if (mkdtemp(pattern.data()) == nullptr) return folderError(target, "cannot write into this folder", errno);
  staging.target_ = target;
  staging.aside_ = pattern;
  staging.in_use_.take(pattern, 0.0);
  staging.guard_ = guard;
  staging.progress_ = progress;
  return staging;
}

StagingFolder::StagingFolder(StagingFolder&& other) noexcept
    : target_(std::move(other.target_)),
      aside_(std::exchange(other.aside_, {})),
      names_(std::move(other.names_)),
      missing_(std::move(other.missing_)),
      made_(std::exchange(other.made_, {})),
      in_use_(std::move(other.in_use_)),
      guard_(other.guard_),
      progress_(other.progress_) {}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  if (!aside_.empty()) fs::remove_all(aside_, ignored);
  for (const std::string& folder : made_) fs::remove(folder, ignored);  // where nothing came into it
}

Status StagingFolder::write(const std::string& name,
                            const std::function<Status(const std::string& path)>& make) {
  if (progress_ != nullptr && progress_->cancelled()) return kStopped;
  const fs::path target = fs::path(target_) / name, aside = fs::path(aside_) / name;
  std::error_code error;
  if (fs::is_directory(target, error)) return inputError(target.string() + ": is a folder, not a file");
  if (guard_ != nullptr) {
    if (Status allowed = guard_->check(target.string()); !allowed) return allowed;
  }
  if (Status done = makeFolders(aside.parent_path().string()); !done)
    return Error{done.error().kind, asTarget(done.error().message)};
  if (Status done = make(aside.string()); !done) {
    fs::remove(aside, error);
    missing_.push_back({name, asTarget(done.error().message)});
    return Error{done.error().kind, missing_.back().why};
  }
  names_.push_back(name);
  return Done{};
}

/// A message about a file aside, for the reader of the target.
std::string StagingFolder::asTarget(std::string message) const {
  const std::string aside = (fs::path(aside_) / "").string(), target = (fs::path(target_) / "").string();
  for (std::size_t at = 0; (at = message.find(aside, at)) != std::string::npos; at += target.size())
    message.replace(at, aside.size(), target);
  return message;
}

Status StagingFolder::commit() {
  if (progress_ != nullptr && progress_->cancelled()) return kStopped;
  for (const Missing& file : missing_) {
    if (file.name == kReportName)
      return Error{ErrorKind::kResourceLimit,
                   target_ + ": nothing was written there without the report of it: " + file.why};
  }
  FolderLock alone;
  if (alone.take(target_, FolderLock::kPatienceS) == FolderLock::Outcome::kBusy)
    return inputError(target_ +
                      ": another run has been writing into this folder for too long: end it, or "
                      "write to another folder");
  if (const Status settled = settleLocked(target_); !settled) return settled;
  ResultChange change{target_, aside_, names_, {}};
  for (const Missing& file : missing_) {  // an earlier run's must not pass for this one's
    std::error_code ignored;
    if (!fs::is_directory(fs::path(target_) / file.name, ignored)) change.removed.push_back(file.name);
  }
  const bool swapped = swapResults(change);
  Status moved = swapped ? Status(Done{}) : moveResults(change);
  in_use_.release();  // where it was swapped the folder is the target now
  return moved;
}

}  // namespace proveout
