// Texts of machine files, and what is said of them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "io/job/job.h"
#include "temp_folder.h"

namespace proveout::io_test {

/// Line numbers of the tests below count from 1 in this text.
inline const std::string kGoodMachine =
    "schema = \"proveout.machine/1\"\n"         // 1
    "name = \"trunnion\"\n"                     // 2
    "[[axis]]\n"                                // 3
    "name = \"X\"\n"                            // 4
    "travel = [-10, 810]\n"                     // 5
    "rapid = 30000\n"                           // 6
    "[[axis]]\n"                                // 7
    "name = \"Y\"\n"                            // 8
    "on = \"X\"\n"                              // 9
    "[[axis]]\n"                                // 10
    "name = \"Z\"\n"                            // 11
    "on = \"Y\"\n"                              // 12
    "[[axis]]\n"                                // 13
    "name = \"A\"\n"                            // 14
    "carries = \"part\"\n"                      // 15
    "direction = [1, 0, 0]\n"                   // 16
    "point = [400, 300, -500]\n"                // 17
    "sense = \"left\"\n"                        // 18
    "travel = [-120, 30]\n"                     // 19
    "[[axis]]\n"                                // 20
    "name = \"C\"\n"                            // 21
    "on = \"A\"\n"                              // 22
    "carries = \"part\"\n"                      // 23
    "point = [400, 300, -460]\n"                // 24
    "step = 1.0\n"                              // 25
    "clamped = true\n"                          // 26
    "[spindle]\n"                               // 27
    "on = \"Z\"\n"                              // 28
    "gauge = [0, 0, 20]\n"                      // 29
    "[[body]]\n"                                // 30
    "name = \"cradle\"\n"                       // 31
    "on = \"A\"\n"                              // 32
    "box = [[0, 0, -600], [800, 600, -520]]\n"  // 33
    "watch = [\"spindle\", \"holder\"]\n";      // 34

struct ReadMachine {
  Job job;
  Diagnostics diagnostics;
  std::string error;  ///< the first, "LINE CODE: MESSAGE"
};

inline ReadMachine readMachineFile(const std::string& path) {
  ReadMachine out;
  loadMachine(path, out.job, out.diagnostics);
  for (const Diagnostic& d : out.diagnostics.all()) {
    if (out.error.empty()) out.error = fmt::format("{} {}: {}", d.where.line, d.code, d.message);
  }
  return out;
}

inline ReadMachine readMachineText(const std::string& text) {
  const TempFolder folder;
  return readMachineFile(folder.write("machine.toml", text));
}

/// The good machine with its first `from` changed.
inline std::string inGoodMachine(const std::string& from, const std::string& to) {
  const std::size_t at = kGoodMachine.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return std::string(kGoodMachine).replace(at, from.size(), to);
}

}  // namespace proveout::io_test
