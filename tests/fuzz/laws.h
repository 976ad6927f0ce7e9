// What the fuzz targets hold results against, and a folder for readers that take a file.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/diagnostics.h"

namespace proveout {

/// Ends the process where a law does not hold; the fuzzer keeps the input.
inline void require(bool holds, const char* law) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", law);
  std::abort();
}

/// All that was told.
inline std::string said(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics.all()) {
    require(!d.message.empty() && !d.code.empty(), "a diagnostic says something");
    text += formatDiagnostic(d);
  }
  return text;
}

/// A folder of this process in memory (/dev/shm, where there is one), removed at the end.
class ScratchFolder {
 public:
  ScratchFolder() {
    namespace fs = std::filesystem;
    const fs::path memory = "/dev/shm";
    const fs::path above = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    path_ = above / ("proveout-fuzz-" + std::to_string(::getpid()));
    fs::create_directories(path_);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }
  std::string at(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, std::string_view bytes) const {
    std::string file = at(name);
    std::FILE* out = std::fopen(file.c_str(), "wb");
    require(out != nullptr && std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() &&
                std::fclose(out) == 0,
            "the scratch folder takes files");
    return file;
  }

 private:
  std::filesystem::path path_;
};

/// Takes numbers off the front of the fuzzer's bytes; zeros behind their end.
class Bytes {
 public:
  explicit Bytes(std::string_view rest) : rest_(rest) {}
  bool empty() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }
  template <typename Number>
  Number take() {
    Number number{};
    const std::size_t size = rest_.size() < sizeof number ? rest_.size() : sizeof number;
    std::char_traits<char>::copy(reinterpret_cast<char*>(&number), rest_.data(), size);
    rest_.remove_prefix(size);
    return number;
  }

 private:
  std::string_view rest_;
};

}  // namespace proveout
