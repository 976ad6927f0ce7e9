#include "io/report/alignment_text.h"

#include <fmt/format.h>

#include <cmath>

#include "io/report_text.h"

namespace proveout::report_text {

std::string alignmentLine(const ReportAlignment& a) {
  std::string text = fmt::format("{}: nominal moved by up to {} mm and turned by {} degrees; ", a.kind,
                                 figure(a.moved_mm), figure(a.turned_deg));
  // Three features have no points to spare: what is left is how far apart the holes are.
  text += a.kind == "datums" ? fmt::format("the distance of the holes is {} mm off", figure(a.rms_mm))
                             : fmt::format("{} mm rms left at {} points, {} left out", figure(a.rms_mm),
                                           a.points, a.left_out);
  if (a.free_directions > 0)
    text += fmt::format("; {} direction{} not settled by the surface", a.free_directions,
                        a.free_directions == 1 ? "" : "s");
  return text;
}

std::string scanLine(const ReportScan& s) {
  std::string text = fmt::format(
      "{:.1f} % of the nominal's surface was scanned (a point within {} mm), {} point{}",
      std::floor(1000.0 * s.coverage) / 10.0, figure(s.reach_mm), s.points, s.points == 1 ? "" : "s");
  if (s.off > 0) text += fmt::format(", {} too far off to be of the part", s.off);
  return text;
}

}  // namespace proveout::report_text
