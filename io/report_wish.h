// What a job says of its report: `[report]`.
#pragma once

#include <string>
#include <vector>

namespace proveout {

/// A line of the report's head.
struct ReportHeadLine {
  std::string key;    ///< as in the job: "part_number"
  std::string label;  ///< for people: "Part number"
  std::string text;
};

/// A plane across an axis of the finished part's frame.
struct SectionPlane {
  int axis = 2;  ///< 0: X, 1: Y, 2: Z
  double at_mm = 0.0;
};

struct ReportWish {
  std::vector<ReportHeadLine> head;    ///< in a fixed order; only what is given
  std::vector<double> bands_mm;        ///< edges of the bands of deviation, ascending; empty: none
  std::vector<SectionPlane> sections;  ///< of which the outlines are drawn
};

}  // namespace proveout
