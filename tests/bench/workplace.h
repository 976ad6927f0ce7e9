// What benchmarks that run the program share: a folder of their own and where the program lies.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/temporary_folder.h"

namespace proveout::bench {

inline std::string readFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The folder in which everything happens; it goes with the object.
using Workplace = test::TemporaryFolder;

/// The program that was built beside this one.
inline std::string programPath() {
  std::error_code error;
  return (std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "proveout").string();
}

}  // namespace proveout::bench
