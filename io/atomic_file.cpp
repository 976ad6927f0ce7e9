#include "io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "core/base/memory_limit.h"

namespace proveout {

namespace fs = std::filesystem;

namespace {

std::string reason(int error) { return std::generic_category().message(error); }

Error writeError(const std::string& path, int error) { return folderError(path, "cannot be written", error); }

/// How long a name may be in a folder, or in the folder above it that is there.
std::size_t longestName(fs::path folder) {
  constexpr std::size_t kUsual = 255, kLeast = 64;
  std::error_code error;
  while (!folder.empty() && !fs::is_directory(folder, error) && folder != folder.parent_path())
    folder = folder.parent_path();
  const long longest = ::pathconf(folder.empty() ? "." : folder.c_str(), _PC_NAME_MAX);
  return longest <= 0 ? kUsual : std::max(kLeast, static_cast<std::size_t>(longest));
}

/// Creates a file next to `target` that did not exist. The name carries the process id, so that two runs that
/// write to one folder do not share it.
std::FILE* createAside(const std::string& target, std::string& aside) {
  constexpr std::size_t kRoom = 32;  // for what is put behind a name, which may be as long as any
  const fs::path path(target);
  const std::string name = path.filename().string();
  const std::string kept = name.substr(0, std::min(name.size(), longestName(path.parent_path()) - kRoom));
  for (int attempt = 0; attempt < 100; ++attempt) {
    aside = (path.parent_path() / kept).string() + ".tmp" + std::to_string(getpid()) + "-" +
            std::to_string(attempt);
    const int descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) return ::fdopen(descriptor, "wb");
    if (errno != EEXIST) return nullptr;
  }
  return nullptr;
}

}  // namespace

Error folderError(const std::string& path, const std::string& what, int error) {
  const bool full = error == ENOSPC || error == EDQUOT || error == EFBIG;
  return {full ? ErrorKind::kResourceLimit : ErrorKind::kInput, path + ": " + what + ": " + reason(error)};
}

namespace {

std::atomic<int> unfinished_files{0};

}  // namespace

UnfinishedFile::UnfinishedFile() noexcept { ++unfinished_files; }
UnfinishedFile::~UnfinishedFile() { --unfinished_files; }
bool UnfinishedFile::any() noexcept { return unfinished_files.load() > 0; }

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  if (path.empty()) return inputError("an output file has no name");
  std::error_code error;
  AtomicFile file;
  file.path_ = path;
  file.target_ = path;
  // A link is followed, so that the file it points to is replaced and the link stays.
  if (fs::is_symlink(path, error)) {
    const fs::path real = fs::weakly_canonical(path, error);
    if (!error) file.target_ = real.string();
  }
  const fs::file_status status = fs::status(file.target_, error);
  if (status.type() == fs::file_type::directory) return inputError(path + ": is a folder, not a file");
  errno = 0;
  if (status.type() == fs::file_type::regular || status.type() == fs::file_type::not_found) {
    file.file_ = createAside(file.target_, file.aside_);
    if (file.file_ == nullptr) file.aside_.clear();
  } else {
    file.file_ = std::fopen(path.c_str(), "wbe");
  }
  if (file.file_ == nullptr) return writeError(path, errno);
  return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept { *this = std::move(other); }

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this == &other) return *this;
  discard();
  file_ = std::exchange(other.file_, nullptr);
  path_ = std::move(other.path_);
  target_ = std::move(other.target_);
  aside_ = std::exchange(other.aside_, std::string());
  error_ = other.error_;
  return *this;
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() noexcept {
  if (file_ != nullptr) std::fclose(std::exchange(file_, nullptr));
  if (!aside_.empty()) ::unlink(aside_.c_str());
  aside_.clear();
}

void AtomicFile::write(const void* data, std::size_t size) {
  if (file_ == nullptr || error_ != 0 || size == 0) return;
  errno = 0;
  if (std::fwrite(data, 1, size, file_) != size) error_ = errno != 0 ? errno : EIO;
}

Status AtomicFile::commit() {
  if (file_ == nullptr) return inputError(path_ + ": is not open");
  errno = 0;
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) error_ = errno != 0 ? errno : EIO;
  if (error_ == 0 && !aside_.empty()) {
    if (std::rename(aside_.c_str(), target_.c_str()) == 0) {
      aside_.clear();
    } else {
      error_ = errno;
    }
  }
  discard();
  if (error_ != 0) return writeError(path_, error_);
  return Done{};
}

Status checkNameLength(const std::string& path) {
  constexpr std::size_t kLongestPath = 4096, kAside = 64;  // a folder aside, and what is put behind names
  constexpr std::size_t kShown = 40;
  std::error_code error;
  const std::string whole = fs::absolute(path, error).lexically_normal().string();
  if (whole.size() + kAside > kLongestPath)
    return inputError(whole.substr(0, kShown) + "...: the path is too long for a file (" +
                      std::to_string(whole.size()) + " bytes)");
  const std::size_t longest = longestName(fs::path(whole).parent_path());
  for (const fs::path& part : fs::path(whole)) {
    const std::string name = part.string();
    if (name.size() > longest)
      return inputError(name.substr(0, kShown) + "...: the name is too long for a file (" +
                        std::to_string(name.size()) + " bytes, " + std::to_string(longest) +
                        " at most): give a shorter one");
  }
  return Done{};
}

Status writeFileAtomically(const std::string& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  file->write(bytes);
  return file->commit();
}

Status checkRegularFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) return inputError(path + ": there is no such file");
  if (status.type() == fs::file_type::directory) return inputError(path + ": is a folder, not a file");
  if (error) return inputError(path + ": cannot be read: " + error.message());
  if (status.type() != fs::file_type::regular) return inputError(path + ": is not a regular file");
  if (::access(path.c_str(), R_OK) != 0) return inputError(path + ": cannot be read: " + reason(errno));
  return Done{};
}

Result<std::string> readWholeFile(const std::string& path, std::size_t max_bytes) {
  const Status regular = checkRegularFile(path);
  if (!regular) return regular.error();
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr) return inputError(path + ": cannot be read: " + reason(errno));
  std::string bytes;
  struct stat info {};
  // The size is a hint: files of /proc say 0, and a file may grow while it is read.
  if (::fstat(fileno(file), &info) == 0 && static_cast<std::uintmax_t>(info.st_size) <= max_bytes) {
    if (const Status fits = memoryFor(static_cast<double>(info.st_size), path); !fits) {
      std::fclose(file);
      return fits.error();
    }
    bytes.reserve(static_cast<std::size_t>(info.st_size));
  }
  char buffer[65536];
  std::size_t got = 0;
  errno = 0;
  while (bytes.size() <= max_bytes && (got = std::fread(buffer, 1, sizeof buffer, file)) > 0) {
    bytes.append(buffer, got);
  }
  const int failed = std::ferror(file) != 0 ? (errno != 0 ? errno : EIO) : 0;
  std::fclose(file);
  if (failed != 0) return inputError(path + ": cannot be read: " + reason(failed));
  if (bytes.size() > max_bytes) {
    return inputError(path + ": is larger than " + std::to_string(max_bytes) + " bytes");
  }
  return bytes;
}

Status makeFolders(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return Done{};
  fs::create_directories(path, error);
  if (error) return folderError(path, "the folder cannot be made", error.value());
  if (!fs::is_directory(path, error)) return inputError(path + ": the folder cannot be made: it is a file");
  return Done{};
}

}  // namespace proveout
