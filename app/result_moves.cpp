#include "app/result_moves.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "app/folder_lock.h"
#include "io/atomic_file.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

/// The folder of new files whose moving has begun; holds the list of what must go.
constexpr const char* kJournal = ".proveout-moving";
constexpr const char* kGoneList = ".proveout-gone";
constexpr std::string_view kOwnPrefix = ".proveout-";
constexpr std::string_view kSwapPrefix = ".proveout-swap-";
constexpr std::size_t kMaxListBytes = std::size_t{1} << 20;

// ---------------------------------------------------------------------------- the swap

/// The name beside the target under which the new folder waits, and then the old one goes.
fs::path swapPlace(const fs::path& real) {
  return real.parent_path() / (std::string(kSwapPrefix) + real.filename().string());
}

bool hasListOfRights(const fs::path& folder) {
  const ssize_t bytes = ::listxattr(folder.c_str(), nullptr, 0);
  if (bytes <= 0) return false;
  std::string names(static_cast<std::size_t>(bytes), '\0');
  const ssize_t got = ::listxattr(folder.c_str(), names.data(), names.size());
  return got < 0 || names.find("posix_acl") != std::string::npos;
}

/// Whether the process works in the folder or below it, and would stand in the removed one.
bool isWorkedIn(const fs::path& real) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  if (error) return true;
  return std::mismatch(real.begin(), real.end(), here.begin(), here.end()).first == real.end();
}

/// Whether a new folder can stand for the old one: the same owner, rights and file system.
bool isReplaceable(const fs::path& real, const fs::path& aside) {
  struct stat old {};
  struct stat made {};
  struct stat above {};
  if (!real.has_filename() || ::stat(real.c_str(), &old) != 0 || ::stat(aside.c_str(), &made) != 0 ||
      ::stat(real.parent_path().c_str(), &above) != 0)
    return false;
  const bool same = old.st_dev == above.st_dev && old.st_dev == made.st_dev && old.st_uid == made.st_uid &&
                    old.st_gid == made.st_gid;
  return same && ::access(real.parent_path().c_str(), W_OK | X_OK) == 0 && !hasListOfRights(real) &&
         !isWorkedIn(real) && ::chmod(aside.c_str(), old.st_mode & 07777) == 0;
}

/// Takes along, by hard links, what stands in the old folder and is not replaced; on destruction without
/// keep() the links go again.
class Carrier {
 public:
  explicit Carrier(const ResultChange& change) : change_(change) {}
  ~Carrier() {
    std::error_code ignored;
    for (auto at = made_.rbegin(); at != made_.rend(); ++at) fs::remove(*at, ignored);
  }
  Carrier(const Carrier&) = delete;
  void keep() { made_.clear(); }

  /// False: something cannot be taken along.
  bool carry(const fs::path& below) {
    std::error_code error;
    for (fs::directory_iterator at(change_.target / below, error), end; !error && at != end;
         at.increment(error)) {
      if (!carryOne(below / at->path().filename())) return false;
    }
    return !error;
  }

 private:
  /// More than a few folders of results have is somebody's data.
  static constexpr std::size_t kMost = 500;

  bool carryOne(const fs::path& name) {
    const fs::path from = change_.target / name, to = change_.aside / name;
    std::error_code error;
    if (from == fs::path(change_.aside)) return true;
    if (made_.size() >= kMost) return false;
    if (!name.has_parent_path() && name.string().starts_with(kOwnPrefix)) return false;  // another run's
    const fs::file_type type = fs::symlink_status(from, error).type();
    if (error || std::count(change_.removed.begin(), change_.removed.end(), name.string()) > 0) return !error;
    if (type == fs::file_type::directory) return carryFolder(name, to);
    if (type != fs::file_type::regular && type != fs::file_type::symlink) return false;
    if (::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), 0) != 0) return errno == EEXIST;
    made_.push_back(to);
    return true;
  }

  bool carryFolder(const fs::path& name, const fs::path& to) {
    struct stat old {};
    struct stat made {};
    const fs::path from = change_.target / name;
    std::error_code error;
    if (fs::create_directory(to, error)) made_.push_back(to);
    if (error || ::lstat(from.c_str(), &old) != 0 || ::lstat(to.c_str(), &made) != 0) return false;
    const bool same = old.st_dev == made.st_dev && old.st_uid == made.st_uid && old.st_gid == made.st_gid;
    return same && !hasListOfRights(from) && ::chmod(to.c_str(), old.st_mode & 07777) == 0 && carry(name);
  }

  const ResultChange& change_;
  std::vector<fs::path> made_;
};

/// What came into the old folder while the new one was made is moved after it.
void moveLateComers(const fs::path& old, const fs::path& real) {
  std::error_code error;
  std::vector<fs::path> names;
  for (fs::directory_iterator at(old, error), end; !error && at != end; at.increment(error))
    names.push_back(at->path().filename());
  for (const fs::path& name : names)
    ::renameat2(AT_FDCWD, (old / name).c_str(), AT_FDCWD, (real / name).c_str(), RENAME_NOREPLACE);
}

/// What must go stands in the old folder still: it must not come back as a late comer.
void dropRemoved(const ResultChange& change, const fs::path& old) {
  std::error_code ignored;
  for (const std::string& name : change.removed) fs::remove(old / name, ignored);
}

// ---------------------------------------------------------------------------- the journal

/// Names of the regular files below a folder, report.json last.
std::vector<std::string> filesBelow(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const std::string name = at->path().lexically_relative(folder).string();
    if (at->is_regular_file(ignored) && name != kGoneList) names.push_back(name);
  }
  std::stable_partition(names.begin(), names.end(), [](const auto& name) { return name != kReportName; });
  return names;
}

Status moveOne(const fs::path& from, const fs::path& to) {
  if (Status made = makeFolders(to.parent_path().string()); !made) return made;
  std::error_code error;
  fs::rename(from, to, error);
  if (error) return folderError(to.string(), "cannot be written", error.value());
  return Done{};
}

void removeListed(const fs::path& target, const std::string& list) {
  std::error_code ignored;
  for (std::size_t at = 0, end; (end = list.find('\0', at)) != std::string::npos; at = end + 1) {
    const fs::path given = fs::path(list.substr(at, end - at)).lexically_normal();
    if (given.empty() || given.is_absolute() || *given.begin() == "..") continue;  // not of our making
    const fs::path name = target / given;
    if (!fs::is_directory(name, ignored)) fs::remove(name, ignored);
  }
}

/// Carries the journal out, from wherever a killed command left it.
Status carryOut(const fs::path& target) {
  const fs::path journal = target / kJournal;
  const std::vector<std::string> names = filesBelow(journal);
  // Without any left the new report is there already, and is not what must go.
  const Result<std::string> gone = readWholeFile((journal / kGoneList).string(), kMaxListBytes);
  if (gone && !names.empty()) removeListed(target, *gone);
  Status first = Done{};
  for (const std::string& name : names) {
    if (!first && name == kReportName) break;
    if (Status done = moveOne(journal / name, target / name); first && !done) first = std::move(done);
  }
  std::error_code ignored;
  fs::remove_all(journal, ignored);
  return first;
}

}  // namespace

bool swapResults(const ResultChange& change) {
  std::error_code error;
  const fs::path real = fs::canonical(change.target, error);
  if (error || !isReplaceable(real, change.aside)) return false;
  Carrier carrier(change);
  if (!carrier.carry({})) return false;
  const fs::path place = swapPlace(real);
  if (::rename(change.aside.c_str(), place.c_str()) != 0) return false;
  if (::renameat2(AT_FDCWD, place.c_str(), AT_FDCWD, real.c_str(), RENAME_EXCHANGE) != 0) {
    fs::rename(place, change.aside, error);
    return false;
  }
  carrier.keep();
  dropRemoved(change, place);
  moveLateComers(place, real);
  fs::remove_all(place, error);
  return true;
}

Status moveResults(const ResultChange& change) {
  std::string gone;
  const auto is = [](const std::string& name) { return name == kReportName; };
  if (std::any_of(change.files.begin(), change.files.end(), is)) gone = std::string(kReportName) + '\0';
  for (const std::string& name : change.removed) gone += name + '\0';
  if (Status listed = writeFileAtomically((fs::path(change.aside) / kGoneList).string(), gone); !listed)
    return listed;
  const fs::path journal = fs::path(change.target) / kJournal;
  std::error_code error;
  fs::rename(change.aside, journal, error);  // from here on the new files are the result
  if (error) return folderError(change.target, "cannot be written", error.value());
  return carryOut(change.target);
}

Status settleLocked(const std::string& folder) {
  std::error_code error;
  const fs::path real = fs::canonical(folder, error);
  if (!error && real.has_filename()) {
    const fs::path place = swapPlace(real);
    if (fs::is_directory(fs::symlink_status(place, error))) fs::remove_all(place, error);
  }
  if (!fs::is_directory(fs::symlink_status(fs::path(folder) / kJournal, error))) return Done{};
  return carryOut(folder);
}

Status settleResults(const std::string& folder) {
  std::error_code error;
  const std::string named = folder.empty() ? "." : folder;
  if (!fs::is_directory(fs::symlink_status(fs::path(named) / kJournal, error))) return Done{};
  FolderLock alone;
  if (alone.take(named, FolderLock::kPatienceS) == FolderLock::Outcome::kBusy)
    return inputError(named + ": another run has been writing into this folder for too long: end it");
  return settleLocked(named);
}

}  // namespace proveout
