// The half section of a turned part over its nominal, with magnified deviations, as SVG.
#pragma once

#include <string>
#include <vector>

#include "io/report/half_section.h"

namespace proveout {

/// A place that the chart points at, (r, z), mm.
struct ProfileMark {
  Vec2 at = Vec2::Zero();
  std::string label;  ///< of the block: "N12"; any text
};

/// The outline of a tool where it stands, (r, z), mm; closed.
struct ProfileTool {
  std::vector<Vec2> outline;
  std::string label;  ///< "T2"; any text
};

struct ProfileChartOptions {
  std::string name;                           ///< of the part; any text
  double gouge_mm = 0.02, excess_mm = 0.05;   ///< tolerances, >= 0; deviations beyond them are coloured
  std::vector<IgnoredRegion> ignored = {};    ///< no deviations there
  double magnification = 0.0;                 ///< of deviations; 0: chosen, 1, 2 or 5 times a power of ten
  std::vector<std::vector<Vec2>> blank = {};  ///< closed loops; drawn as far as it lies beside the part
  std::vector<ProfileMark> marks = {};
  std::vector<ProfileTool> tools = {};
};

/// Both pictures are empty where there is nothing to draw.
struct ProfileChart {
  std::string page;  ///< an svg element for report.html, which has the styles
  std::string file;  ///< an SVG file that stands alone
};

/// Draws r over z, mm. `machined`: closed loops (r, z), r >= 0, every second region is material; `nominal`:
/// its half section in any order, may be empty: no deviations then. Both axes have one scale if the part's
/// proportions allow, else the chart says how much r is stretched. Deviations stand on the machined profile
/// and lead away from the nominal: outwards for excess, inwards for gouge; what is longer than 20 times the
/// larger tolerance is cut off and said to be. The blank is dashed, tools are drawn over the part as far as
/// the chart reaches. Nothing to draw: no material, or numbers that are not finite.
ProfileChart drawProfileChart(const std::vector<std::vector<Vec2>>& machined,
                              const std::vector<SectionSegment>& nominal, const ProfileChartOptions& options);

}  // namespace proveout
