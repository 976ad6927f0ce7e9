// The examples of the FlexNC manual with what they make: tables 9.1 to 9.4 of the digest flexnc, sharp tool,
// X drawn downwards. Points are "X,Z", X a diameter; several stand one behind the other with blanks.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace proveout::test {

struct FlexncRoughingExample {
  std::string row;    ///< of the manual's list that the example proves
  std::string block;  ///< as programmed
  std::string profile, centers, start;
  int passes;        ///< before the one along the profile
  std::string ends;  ///< "X@Z" of the first two passes and of the last
  double volume;     ///< mm^3, off a bar or out of a bore of the initial diameter
};
const std::vector<FlexncRoughingExample>& flexncShaftExamples();        // 9.1
const std::vector<FlexncRoughingExample>& flexncHoleExamples();         // 9.2
const std::vector<FlexncRoughingExample>& flexncConstructedExamples();  // 9.4

struct FlexncContourExample {
  std::string row, block, profile, centers;
  std::string increments;  ///< of X and Z from start to end
};
const std::vector<FlexncContourExample>& flexncContourExamples();  // 9.3

inline void PrintTo(const FlexncRoughingExample& example, std::ostream* out) { *out << example.block; }
inline void PrintTo(const FlexncContourExample& example, std::ostream* out) { *out << example.block; }

}  // namespace proveout::test
