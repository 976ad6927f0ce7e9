// A plan as a job folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/soak/second/plan.h"

namespace proveout::soak::second {
namespace {

std::string triple(const Spot& p) { return fmt::format("[{:.6f}, {:.6f}, {:.6f}]", p.x(), p.y(), p.z()); }

std::string roundWords(const Solid& solid) {
  std::string text =
      fmt::format("shape = \"{}\"\nbase = {}\naxis = \"{}\"\nlength = {:.6f}\nradius = {:.6f}\n",
                  solid.inner > 0 ? "tube" : "cylinder", triple(solid.base), "xyz"[solid.axis], solid.length,
                  solid.radius);
  if (solid.inner > 0) text += fmt::format("inner_radius = {:.6f}\n", solid.inner);
  return text;
}

std::string solidWords(const Solid& solid) {
  if (solid.shape == Solid::Shape::kRound) return roundWords(solid);
  if (solid.shape == Solid::Shape::kMesh) return "shape = \"mesh\"\nfile = \"blank.obj\"\n";
  return fmt::format("shape = \"box\"\nmin = {}\nmax = {}\n", triple(solid.min), triple(solid.max));
}

std::string objOf(const Solid& mesh) {
  std::string text;
  for (const Spot& p : mesh.points) text += fmt::format("v {:.6f} {:.6f} {:.6f}\n", p.x(), p.y(), p.z());
  for (const auto& f : mesh.faces) text += fmt::format("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1);
  return text;
}

/// `tools` with its tables below `above` ("" or "setup.").
std::string toolTables(std::string tools, const std::string& above) {
  for (std::size_t at; (at = tools.find('@')) != std::string::npos;) tools.replace(at, 1, above);
  return tools;
}

std::string parametersOf(const Clamping& c) {
  if (c.control != Control::kWedm) return c.parameters;
  return c.parameters + fmt::format("ZB = {:.6f}\nT = {:.6f}\n", c.bottom, c.height);
}

std::string controlTable(const Clamping& c, const std::string& above) {
  const std::string more = parametersOf(c);
  std::string text = fmt::format("[{}control]\nname = \"{}\"\n", above, nameOf(c.control));
  if (!more.empty()) text += fmt::format("[{}control.{}]\n{}", above, nameOf(c.control), more);
  return text;
}

/// Offsets and fixtures of a clamping.
std::string aroundOf(const Clamping& c, const std::string& above) {
  std::string text;
  if (!c.radii.empty() && c.control != Control::kWedm) {
    text += fmt::format("[{}offsets.radius]\n", above);
    for (const auto& [row, radius] : c.radii) text += fmt::format("{} = {:.6f}\n", row, radius);
  }
  for (const Solid& fixture : c.fixtures)
    text += fmt::format("[[{}fixture]]\n{}", above, solidWords(fixture));
  return text;
}

/// Degrees about the fixed X, Y and Z axes, one after the other; whole quarters come out as such.
Spot fixedAngles(const Eigen::Matrix3d& r) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double y = std::asin(std::clamp(-r(2, 0), -1.0, 1.0));
  if (std::abs(r(2, 0)) > 1 - 1e-12) return {0, y * kDegrees, std::atan2(-r(0, 1), r(1, 1)) * kDegrees};
  return {std::atan2(r(2, 1), r(2, 2)) * kDegrees, y * kDegrees, std::atan2(r(1, 0), r(0, 0)) * kDegrees};
}

std::string moveTable(const Move& move) {
  const Spot angles = fixedAngles(move.turn);
  return fmt::format("[setup.transform]\nrotate = [{:.9f}, {:.9f}, {:.9f}]\ntranslate = {}\n", angles.x(),
                     angles.y(), angles.z(), triple(move.shift));
}

bool sameMachine(const Clamping& a, const Clamping& b) {
  return a.control == b.control && a.tools == b.tools && parametersOf(a) == parametersOf(b);
}

std::string setupTables(const Plan& plan, std::size_t k) {
  const Clamping& c = plan.clampings[k];
  std::string text = fmt::format("[[setup]]\nname = \"s{0}\"\nprogram = \"p{0}.nc\"\n", k + 1);
  if (k > 0) text += moveTable(c.move);
  if (!sameMachine(c, plan.clampings.front()))
    text += controlTable(c, "setup.") + toolTables(c.tools, "setup.");
  return text + aroundOf(c, "setup.");
}

std::string stockTable(const Plan& plan) {
  if (!plan.stock_file.empty())
    return fmt::format("[stock]\nshape = \"vdb\"\nfile = \"{}\"\n", plan.stock_file);
  std::string text = "[stock]\n" + solidWords(plan.blank);
  for (const StartHole& hole : plan.start_holes)
    text += fmt::format("[[stock.start_hole]]\nat = [{:.6f}, {:.6f}]\ndiameter = {:.6f}\n", hole.at.x(),
                        hole.at.y(), hole.diameter);
  return text;
}

std::string simulationTable(const Plan& plan) {
  std::string text = fmt::format("[simulation]\nprofile_resolution = {:g}\n", plan.profile);
  if (plan.stock_file.empty()) text += fmt::format("resolution = {:g}\n", plan.grid);
  if (plan.keeps_stock) text += "[output]\nformats = [\"stl\", \"vdb\"]\n";
  return text;
}

}  // namespace

std::map<std::string, std::string> filesOf(const Plan& plan) {
  std::map<std::string, std::string> files;
  const Clamping& first = plan.clampings.front();
  std::string job = "schema = \"proveout.job/1\"\n";
  if (plan.plain) job += "program = \"p1.nc\"\n";
  job += controlTable(first, "") + stockTable(plan) + toolTables(first.tools, "") + simulationTable(plan);
  for (std::size_t k = 0; k < plan.clampings.size(); ++k) {
    files[fmt::format("p{}.nc", k + 1)] = programOf(plan.clampings[k]);
    job += plan.plain ? aroundOf(first, "") : setupTables(plan, k);
  }
  files["job.toml"] = job;
  if (plan.blank.shape == Solid::Shape::kMesh) files["blank.obj"] = objOf(plan.blank);
  return files;
}

}  // namespace proveout::soak::second
