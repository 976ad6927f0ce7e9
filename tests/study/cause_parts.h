// Parts whose sizes, tools and places follow from a seed, with one mistake of a kind each: for the study of
// causes.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tests/study/planted.h"

namespace proveout::study {

/// A file of a job: a program, or the job itself.
struct StudyFile {
  std::string name, text;
};

/// A job with its programs. `lines`: "top.nc:word" and its line.
struct StudyJob {
  std::vector<StudyFile> files;  ///< the last is the job
  std::map<std::string, int> lines;
};

/// What is wrong, and what has to be named.
struct Mistake {
  std::string kind;  ///< a row of the table
  std::string what;  ///< the word or key, for complaints
  Plan plan;
  std::set<std::string> words;  ///< names in StudyJob::lines of which one has to be named
  std::set<std::string> data;   ///< keys of the job of which one has to be named
};

/// One of the values from `least` to `most` that are `step` apart.
inline double stepped(std::mt19937& random, double least, double most, double step) {
  const auto steps = static_cast<unsigned>(std::lround((most - least) / step)) + 1U;
  return least + step * static_cast<double>(random() % steps);
}

/// A milled plate in two clampings: contour pocket, row of holes by a repeat count, turned groove (G68),
/// countersinks, groove along an arc in G18, counterbore on the back.
StudyJob platesJob(std::uint32_t seed, const Plan& plan);
Mistake platesMistake(std::uint32_t seed);

/// A punch or a die under wire EDM: a contour with arcs, a taper, a rough cut.
StudyJob wireJob(std::uint32_t seed, const Plan& plan);
Mistake wireMistake(std::uint32_t seed);

}  // namespace proveout::study
