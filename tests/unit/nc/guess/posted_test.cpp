// Programs in the habits of posts run on their controls: what they cut is known by closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "core/nc/guess/control_guess.h"
#include "tests/unit/nc/guess/posted_programs.h"
#include "tests/unit/nc/iso_run.h"

namespace proveout::test {
namespace {

constexpr double kTop = 200.0;  // mm, machine zero above the workpiece

/// The operator has set the zero point and a radius of 5 for D1; machine zero is at the top of travel.
ControlSettings settingsOf(const PostedProgram& program, ControlId control) {
  ControlSettings settings;
  settings.start = Vec3(0, 0, kTop);
  const bool turns = control == ControlId::kFanucLathe;  // it has no Y that could be anywhere
  settings.work_offsets[0] = Vec3(-300, turns ? 0 : -200, -kTop);
  settings.work_given[0] = true;
  settings.reference_points[0] = Vec3::Zero();
  settings.radius_offsets[1] = {5.0, 0.0};
  for (int tool = 1; tool <= 9; ++tool) settings.length_offsets[tool] = {0.0, 0.0};
  settings.max_errors = 5;
  if (const auto flavour = flavourValue(control, program.flavour)) settings.parameters["flavour"] = *flavour;
  return settings;
}

/// Extent and length of the feed motions, arcs by many chords.
struct Cut {
  Box3 extent;
  double length = 0.0;

  explicit Cut(const Toolpath& path) {
    for (const Motion& m : path.motions) {
      if (m.kind == MotionKind::kRapid) continue;
      const ArcGeometry* arc = m.arc >= 0 ? &path.arcs[static_cast<std::size_t>(m.arc)] : nullptr;
      constexpr int kChords = 7200;
      Vec3 last = m.from;
      extent.extend(last);
      for (int k = 1; k <= (arc != nullptr ? kChords : 1); ++k) {
        const Vec3 next = arc != nullptr ? arcPoint(m, *arc, static_cast<double>(k) / kChords) : m.to;
        length += (next - last).norm();
        extent.extend(next);
        last = next;
      }
    }
  }
  static Vec3 arcPoint(const Motion& m, const ArcGeometry& arc, double s) {
    const Vec3 out = m.from - arc.center, flat = out - arc.normal * arc.normal.dot(out);
    const double angle = arc.sweep_rad * s, rise = arc.normal.dot(m.to - m.from);
    return arc.center + std::cos(angle) * flat + std::sin(angle) * arc.normal.cross(flat) +
           arc.normal * (arc.normal.dot(out) + s * rise);
  }
};

class Posted : public testing::TestWithParam<PostedProgram> {};

TEST_P(Posted, CutsWhatItsFigureSays) {
  const PostedProgram& program = GetParam();
  const ControlId control = findControl(program.control).value();
  const IsoRun run(control, program.text(), settingsOf(program, control));
  EXPECT_EQ(run.error(), "") << run.message() << " line " << run.first(Severity::kError).where.line << ": "
                             << run.first(Severity::kError).source_line;
  EXPECT_EQ(run.summary.end, ProgramEnd::kEndOfProgram);
  const Cut cut(run.path);
  if (program.extent) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(cut.extent.min[k], (*program.extent)[static_cast<std::size_t>(k)], 2e-3)
          << "min of axis " << k;
      EXPECT_NEAR(cut.extent.max[k], (*program.extent)[static_cast<std::size_t>(k) + 3], 2e-3)
          << "max of axis " << k;
    }
  }
  EXPECT_NEAR(cut.length, program.length.value_or(cut.length), 1e-4 * cut.length + 0.02);
  EXPECT_NEAR(run.end().z(), program.end_z.value_or(run.end().z()), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Programs, Posted, testing::ValuesIn(postedPrograms()), [](const auto& test) {
  std::string name = test.param.file;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace proveout::test
