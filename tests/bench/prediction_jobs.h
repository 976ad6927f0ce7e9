// Jobs of many kinds, against which the prediction of memory and time is held.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace proveout::bench {

struct PredictedJob {
  std::string name;
  std::map<std::string, std::function<std::string()>> files = {};  ///< made in the folder in which it runs
  std::vector<std::string> before = {};  ///< arguments of a run that makes what this one starts from
  std::vector<std::string> run = {};     ///< arguments of the command but for --out
  std::string command = "run";
  bool held_out = false;  ///< nothing is fitted to it: it is only counted
};

/// `shared`: the folder of the sample programs, empty where there is none; `parts`: that of the sample parts.
std::vector<PredictedJob> predictedJobs(const std::string& shared, const std::string& parts);

}  // namespace proveout::bench
