#include "app/session/causes/job_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "core/base/assert.h"
#include "core/mesh/mesh_placement.h"

namespace proveout {

namespace {

template <typename Owner>
struct Number {
  std::string_view key;
  double Owner::* member;
};
constexpr Number<Tool> kToolNumbers[] = {{"diameter", &Tool::diameter},
                                       {"corner_radius", &Tool::corner_radius},
                                       {"tip_diameter", &Tool::tip_diameter},
                                       {"cone_angle", &Tool::cone_angle_deg},
                                       {"point_angle", &Tool::point_angle_deg},
                                       {"dovetail_angle", &Tool::dovetail_angle_deg},
                                       {"pitch", &Tool::pitch},
                                       {"thread_angle", &Tool::thread_angle_deg},
                                       {"crest_flat", &Tool::crest_flat},
                                       {"root_diameter", &Tool::root_diameter},
                                       {"spark_gap", &Tool::spark_gap},
                                       {"gauge_length", &Tool::gauge_length}};
constexpr Number<Insert> kInsertNumbers[] = {{"nose_radius", &Insert::nose_radius},
                                           {"insert_angle", &Insert::insert_angle_deg},
                                           {"lead_angle", &Insert::lead_angle_deg},
                                           {"width", &Insert::width},
                                           {"tip_flat", &Insert::tip_flat}};

/// The first word of a key, which is left with the rest.
std::string_view take(std::string_view& key) {
  const std::size_t dot = key.find('.');
  const std::string_view first = key.substr(0, dot);
  key = dot == std::string_view::npos ? std::string_view() : key.substr(dot + 1);
  return first;
}

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Eigen::Index> axisOf(std::string_view letter) {
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') return std::nullopt;
  return letter[0] - 'x';
}

ControlSettings& settingsOf(Job& job, std::size_t setup) {
  PROVEOUT_ASSERT(job.setups.empty() || setup < job.setups.size());
  return job.setups.empty() ? job.settings : job.setups[setup].settings;
}

/// The tools of a clamping, which are its own from now on.
std::vector<Tool>& toolsOf(Job& job, std::size_t setup) {
  if (job.setups.empty()) return job.tools;
  PROVEOUT_ASSERT(setup < job.setups.size());
  SetupSpec& spec = job.setups[setup];
  if (spec.tools.empty()) spec.tools = job.tools;
  return spec.tools;
}

double* workOffset(ControlSettings& settings, std::string_view key) {
  // The name of a row of G54.1 has a dot of its own.
  const std::size_t last = key.rfind('.');
  if (last == std::string_view::npos) return nullptr;
  const std::string_view row = key.substr(0, last);
  const auto axis = axisOf(key.substr(last + 1));
  if (!axis) return nullptr;
  if (row == "common") return &settings.common_offset[*axis];
  if (row.starts_with("G54.1 P")) {
    const auto p = number(row.substr(7));
    return p ? &settings.extended_offsets.try_emplace(*p, Vec3::Zero()).first->second[*axis] : nullptr;
  }
  const auto code = row.size() == 3 && row[0] == 'G' ? number(row.substr(1)) : std::nullopt;
  if (!code || *code < 54 || *code > 59) return nullptr;
  return &settings.work_offsets[static_cast<std::size_t>(*code - 54)][*axis];
}

double* rowValue(std::map<int, OffsetValue>& rows, std::string_view key) {
  const auto row = number(key);
  return row ? &rows[*row].geometry : nullptr;
}

double* offset(ControlSettings& settings, std::string_view key) {
  const std::string_view table = take(key);
  if (table == "work") return workOffset(settings, key);
  if (table == "length") return rowValue(settings.length_offsets, key);
  if (table == "radius") return rowValue(settings.radius_offsets, key);
  return nullptr;
}

double* toolNumber(Tool& tool, std::string_view key) {
  for (const Number<Tool>& n : kToolNumbers) {
    if (n.key == key) return &(tool.*n.member);
  }
  // Dovetails call it height, T-slot cutters thickness.
  if (key == "height" || key == "thickness") return &tool.cutter_height;
  for (const Number<Insert>& n : kInsertNumbers) {
    if (tool.insert && n.key == key) return &((*tool.insert).*n.member);
  }
  return nullptr;
}

Tool* toolOf(std::vector<Tool>& tools, std::string_view name) {
  const auto wanted = number(name);
  const auto found =
      std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return wanted && tool.number == *wanted; });
  return found == tools.end() ? nullptr : &*found;
}

double* transform(Job& job, std::size_t setup, std::string_view key) {
  if (job.setups.empty() || setup == 0) return nullptr;
  PROVEOUT_ASSERT(setup < job.setups.size());
  const std::string head = fmt::format("{}.transform.translate.", job.setups[setup].name);
  if (!key.starts_with(head)) return nullptr;
  const auto axis = axisOf(key.substr(head.size()));
  return axis ? &job.setups[setup].from_previous.translation[*axis] : nullptr;
}

/// The axis of a key of a clamping's turn, "setup.NAME.transform.rotate.z".
std::optional<Eigen::Index> turnAxis(const Job& job, std::size_t setup, std::string_view key) {
  if (job.setups.empty() || setup == 0) return std::nullopt;
  PROVEOUT_ASSERT(setup < job.setups.size());
  const std::string head = fmt::format("setup.{}.transform.rotate.", job.setups[setup].name);
  return key.starts_with(head) ? axisOf(key.substr(head.size())) : std::nullopt;
}

double* parameter(ControlSettings& settings, std::string_view key) {
  take(key);  // the control
  return &settings.parameters.try_emplace(std::string(key), 0.0).first->second;
}

/// Rows that are not there are made.
double* place(Job& job, std::size_t setup, std::string_view key) {
  const std::string_view section = take(key);
  if (section == "offsets") return offset(settingsOf(job, setup), key);
  if (section == "setup") return transform(job, setup, key);
  if (section == "control") return parameter(settingsOf(job, setup), key);
  if (section != "tools") return nullptr;
  Tool* const tool = toolOf(toolsOf(job, setup), take(key));
  return tool == nullptr ? nullptr : toolNumber(*tool, key);
}

}  // namespace

std::optional<double> jobNumber(const Job& job, std::size_t setup, const std::string& key) {
  if (const auto axis = turnAxis(job, setup, key)) return xyzDegOf(job.setups[setup].from_previous.rotation)[*axis];
  Job copy = job;
  const double* const at = place(copy, setup, key);
  return at == nullptr ? std::nullopt : std::optional(*at);
}

bool putJobNumber(Job& job, std::size_t setup, const std::string& key, double value) {
  if (const auto axis = turnAxis(job, setup, key)) {
    Eigen::Matrix3d& rotation = job.setups[setup].from_previous.rotation;
    Vec3 angles = xyzDegOf(rotation);
    angles[*axis] = value;
    rotation = rotationXyzDeg(angles);
    return true;
  }
  double* const at = place(job, setup, key);
  if (at == nullptr) return false;
  *at = value;
  if (!key.starts_with("tools.")) return true;
  std::string_view rest = key;
  take(rest);
  Tool& tool = *toolOf(toolsOf(job, setup), take(rest));
  if (rest == "corner_radius" && tool.type == ToolType::kFlat) tool.type = ToolType::kBull;
  return validateTool(tool).ok();
}

std::vector<std::string> toolKeys(const Tool& tool) {
  const auto own = [&](std::string_view key) {
    switch (tool.type) {
      case ToolType::kFlat:
      case ToolType::kBull:
        return key == "diameter" || key == "corner_radius";
      case ToolType::kCone:
      case ToolType::kTaperBall:
        return key == "diameter" || key == "tip_diameter" || key == "cone_angle";
      case ToolType::kDrill:
        return key == "diameter" || key == "point_angle";
      case ToolType::kDovetail:
        return key == "diameter" || key == "corner_radius" || key == "dovetail_angle" || key == "height";
      case ToolType::kTSlot:
        return key == "diameter" || key == "corner_radius" || key == "thickness";
      case ToolType::kThreadMill:
        return key == "diameter" || key == "pitch" || key == "thread_angle" || key == "crest_flat";
      case ToolType::kWire:
        return key == "diameter" || key == "spark_gap";
      default:
        return key == "diameter";
    }
  };
  std::vector<std::string> out;
  const std::string head = fmt::format("tools.{}.", tool.number);
  if (tool.insert) {
    for (const Number<Insert>& n : kInsertNumbers) {
      if ((*tool.insert).*n.member != 0.0) out.push_back(head + std::string(n.key));
    }
    return out;
  }
  for (const Number<Tool>& n : kToolNumbers) {
    if (own(n.key)) out.push_back(head + std::string(n.key));
  }
  for (const char* key : {"height", "thickness"}) {
    if (own(key)) out.push_back(head + key);
  }
  if (tool.gauge_length != 0.0) out.push_back(head + "gauge_length");
  return out;
}

}  // namespace proveout
