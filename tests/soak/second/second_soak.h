// The second soak: random plans against relations.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace proveout::soak::second {

struct Broken {
  std::string relation, process, why;
};

struct Verdict {
  std::string process;
  bool ran = false;  ///< false: the job was refused, with `why`
  std::string why;
  std::vector<std::string> asked;  ///< names of relations
  std::vector<Broken> broken;
  std::vector<Broken> beyond;  ///< held only because `thin_feature` stands for a bound
};

/// Runs the plan of a seed and asks all relations; `only`: one of them. `keep`: a folder that gets the job
/// folders of what is broken.
Verdict judgePlan(std::uint64_t seed, const std::string& only = {}, const std::string& keep = {});

/// Counts by relation and process.
class Tally {
 public:
  void add(const Verdict& verdict);
  std::string table() const;
  std::uint64_t jobs() const { return jobs_; }
  std::uint64_t bad() const { return bad_; }

 private:
  struct Cell {
    std::uint64_t asked = 0, broken = 0, beyond = 0;
  };
  std::map<std::string, std::map<std::string, Cell>> cells_;  ///< relation, process
  std::map<std::string, std::uint64_t> refused_;              ///< reason
  std::uint64_t jobs_ = 0, bad_ = 0;
};

}  // namespace proveout::soak::second
