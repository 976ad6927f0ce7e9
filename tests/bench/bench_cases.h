// The cases of bench_programs: programs of others, made ones, turned parts, wires, and what once cost most.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace proveout::bench {

struct Case {
  std::string name, file;                  ///< of the table's line, and of the program
  std::function<std::string()> text = {};  ///< makes the program; empty: it is one of the shared programs
  std::string stock = {}, tool = {};       ///< options of `proveout run`
  double grid_mm = 0.0;
  std::optional<double> exact_mm3 = {};   ///< of the part
  bool heavy = false;                     ///< run on request only
  std::string job_file = {};              ///< where there is a job in place of stock and tool
  std::function<std::string()> job = {};  ///< makes it; empty: job_file is one that is there
  bool picture = false;                   ///< drawn, too
  std::string simplify = {};              ///< value of --simplify, mm; empty: as by default
};

/// The folder of the programs of others; there may be none.
std::string sharedFolder();
/// All, without those of others where there are none.
std::vector<Case> allCases();

}  // namespace proveout::bench
