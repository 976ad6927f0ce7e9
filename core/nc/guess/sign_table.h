// The table of signs: what each tells, for and against whom.
#pragma once

#include <span>
#include <string_view>

#include "core/nc/guess/candidates.h"
#include "core/nc/guess/program_signs.h"

namespace proveout::nc::guess {

/// A sign may have several rows. Weights add up; 6 nearly proves, 3 suggests, 1 leans.
struct SignRow {
  Sign sign;
  std::string_view says;  ///< "length offset with H"
  Candidates speaks_for;
  int weight_for;
  Candidates speaks_against;
  int weight_against;
  int least = 1;  ///< the sign has to be seen so often
};
std::span<const SignRow> signRows();

/// A name in a comment, or the end of a file's name.
struct NameRow {
  std::string_view name;  ///< "HAAS"; ".ngc" in lower case for ends of names
  Candidates speaks_for;
  int weight_for;
  int weight_against;  ///< of all others
};
std::span<const NameRow> nameRows();

}  // namespace proveout::nc::guess
