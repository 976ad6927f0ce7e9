// Clampings of a job file: [[setup]] with its transform, and [[fixture]].
#include <fmt/format.h>

#include <algorithm>

#include "io/job/job_sections.h"

namespace proveout {

namespace {

constexpr std::size_t kMostParts = 1'000;  ///< fixtures of a setup, setups of a job
constexpr NumberRange kDegrees{-360.0, 360.0, false};

/// Turn of a [setup.transform]: `rotate`, or `axis` with `angle`.
Eigen::Matrix3d readRotation(ConfigTable& table) {
  const auto rotate = table.point("rotate", kDegrees);
  const bool has_axis = table.find("axis") != nullptr, has_angle = table.find("angle") != nullptr;
  if (!has_axis && !has_angle) return rotationXyzDeg(rotate.value_or(Vec3::Zero()));
  if (table.find("rotate") != nullptr) {
    table.error("rotate", "job-value", "give rotate, or axis and angle, not both");
  }
  const auto axis = table.must("axis").point("axis");
  const auto angle = table.must("angle").number("angle", kDegrees);
  if (!axis || !angle) return Eigen::Matrix3d::Identity();
  if (!(axis->norm() > 1e-9)) {
    table.error("axis", "job-range", "axis must not be zero");
    return Eigen::Matrix3d::Identity();
  }
  return rotationAbout(*axis, *angle);
}

void readTransform(ConfigTable& setup, bool first, SetupSpec& spec) {
  auto table = setup.table("transform");
  if (!table) return;
  if (first) {
    setup.error("transform", "job-value",
                "the first setup has no transform: the stock is given in its frame");
  }
  spec.from_previous.rotation = readRotation(*table);
  if (const auto shift = table->point("translate")) spec.from_previous.translation = *shift;
  table->refuseOthers();
}

/// What a setup says of its program, on top of what the job says.
SetupSpec readSetup(ConfigTable& table, bool first, const JobNames& names, const Job& job) {
  Job part;
  if (table.find("control") != nullptr) {  // another machine: nothing of the job's own is its
    readControl(table, names, part);
    readMachine(table, part);
  } else {
    if (table.find("machine") != nullptr)
      table.error("machine", "job-value", "a setup has a machine of its own only with a control of its own");
    part.settings = job.settings;
    part.limits = job.limits;
    part.limits.tools.clear();
    part.start = job.start;
  }
  readTools(table, part);
  if (part.tools.empty()) part.limits.tools = job.limits.tools;
  readProgram(table, part);
  readOffsets(table, part);
  readPlacement(table, part);
  readPanel(table, part);
  readFixtures(table, part);
  if (const auto start = table.point("start")) part.start = *start;
  SetupSpec spec;
  spec.control = std::move(part.control);
  spec.settings_by_table = std::move(part.settings_by_table);
  spec.machine_file = std::move(part.machine_file);
  spec.tools = std::move(part.tools);
  spec.program = std::move(part.program);
  spec.filled = std::move(part.filled);
  spec.subprograms = std::move(part.subprograms);
  spec.settings = std::move(part.settings);
  spec.limits = std::move(part.limits);
  spec.start = part.start;
  spec.fixtures = std::move(part.fixtures);
  readTransform(table, first, spec);
  return spec;
}

}  // namespace

void readFixtures(ConfigTable& root, Job& job) {
  for (ConfigTable& table : root.tables("fixture", kMostParts)) {
    FixtureSpec fixture;
    fixture.name = table.text("name").value_or(fmt::format("{}", job.fixtures.size() + 1));
    std::optional<StockSpec> shape;
    if (table.find("mesh") != nullptr) {
      if (table.find("shape") != nullptr) table.error("shape", "job-value", "give mesh or shape, not both");
      shape = readMeshFile(table, "mesh");
    } else if (table.find("shape") != nullptr) {
      shape = readShape(table, {"box", "cylinder", "tube"});
    } else {
      table.error("", "job-missing", fmt::format("{} needs mesh or shape", table.title()));
    }
    table.refuseOthers();
    const auto same = [&](const FixtureSpec& other) { return other.name == fixture.name; };
    if (std::any_of(job.fixtures.begin(), job.fixtures.end(), same)) {
      table.error("name", "job-value",
                  fmt::format("there are two fixtures with the name '{}'", fixture.name));
    }
    if (!shape) continue;
    fixture.shape = std::move(*shape);
    job.fixtures.push_back(std::move(fixture));
  }
}

void readSetups(ConfigTable& root, const JobNames& names, Job& job) {
  std::vector<ConfigTable> tables = root.tables("setup", kMostParts);
  if (tables.empty() && root.find("setup") != nullptr) {
    root.error("setup", "job-value", "setup must hold at least one table, [[setup]]");
  }
  for (const char* key : {"program", "template", "subprograms", "fixture"}) {
    if (tables.empty() || root.find(key) == nullptr) continue;
    root.error(key, "job-value", fmt::format("with [[setup]], {} belongs to the setups", key));
  }
  if (tables.empty() && job.tools.empty()) root.require("tool");
  for (ConfigTable& table : tables) {
    if (job.tools.empty() && table.find("tool") == nullptr) root.require("tool");
    const std::string name = table.text("name").value_or(fmt::format("{}", job.setups.size() + 1));
    SetupSpec spec = readSetup(table, job.setups.empty(), names, job);
    spec.name = name;
    const auto same = [&](const SetupSpec& other) { return other.name == name; };
    if (std::any_of(job.setups.begin(), job.setups.end(), same)) {
      table.error("name", "job-value", fmt::format("there are two setups with the name '{}'", name));
    }
    table.refuseOthers();
    job.setups.push_back(std::move(spec));
  }
}

}  // namespace proveout
