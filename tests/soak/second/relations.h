// What holds between a job and the same job said in another way (metamorphic relations).
#pragma once

#include <vector>

#include "tests/soak/second/dice.h"
#include "tests/soak/second/same_job.h"

namespace proveout::soak::second {

Ran runPlan(const Plan& plan);

struct Relation {
  const char* name;
  const char* law;  ///< one sentence
  Answer (*ask)(const Ran& job, Dice& dice);
};

const std::vector<Relation>& relations();

}  // namespace proveout::soak::second
