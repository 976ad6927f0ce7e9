#include "io/step/step_file.h"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/base/installed_file.h"
#include "core/base/printable.h"
#include "io/atomic_file.h"
#include "io/mesh_formats.h"
#include "io/step/reader_process.h"
#include "io/step/step_stream.h"

namespace proveout {
namespace {

using StepJson = nlohmann::json;

/// Coordinates beyond are no part of a machine, mm.
constexpr double kMostSize = 1e6;

Error brokenStream(const std::string& path) {
  return inputError(path + ": the reader of STEP files has broken off; export the file again");
}

template <class Row>
bool takeRows(std::string_view& bytes, std::size_t count, std::vector<Row>& out) {
  if (bytes.size() / sizeof(Row) < count) return false;
  out.resize(count);
  std::memcpy(out.data(), bytes.data(), count * sizeof(Row));
  bytes.remove_prefix(count * sizeof(Row));
  return true;
}

Vec3 pointOf(const StepJson& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

CadFace faceOf(const StepJson& json) {
  CadFace out;
  const int kind = json.at("kind");
  out.kind = kind >= 0 && kind < static_cast<int>(SurfaceKind::kOther) ? static_cast<SurfaceKind>(kind)
                                                                       : SurfaceKind::kOther;
  out.origin = pointOf(json.at("origin"));
  out.axis = pointOf(json.at("axis"));
  out.radius = json.at("radius");
  out.tube_radius = json.at("tube_radius");
  out.half_angle_rad = json.at("half_angle");
  out.turn_rad = json.at("turn");
  out.hollow = json.at("hollow");
  out.name = printable(json.at("name").get<std::string>());
  if (const auto colour = json.find("colour"); colour != json.end())
    out.colour = {colour->at(0).get<float>(), colour->at(1).get<float>(), colour->at(2).get<float>()};
  return out;
}

/// What follows the head. False: it is not what the head says.
bool takeMesh(std::string_view bytes, const StepJson& head, StepBody& out) {
  std::vector<std::array<float, 3>> vertices;
  const std::size_t triangles = head.at("triangles");
  if (!takeRows(bytes, head.at("vertices"), vertices) || !takeRows(bytes, triangles, out.mesh.triangles) ||
      !takeRows(bytes, triangles, out.faces.of_triangle) || !bytes.empty())
    return false;
  for (const auto& v : vertices) {
    const Eigen::Vector3f at(v[0], v[1], v[2]);
    if (!at.allFinite() || at.cwiseAbs().maxCoeff() > kMostSize) return false;
    out.mesh.positions.push_back(at);
  }
  for (const auto& triangle : out.mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= vertices.size()) return false;
  for (const std::uint32_t face : out.faces.of_triangle)
    if (face >= out.faces.faces.size()) return false;
  return true;
}

/// Equal positions become one; what collapses has no triangle, and no face, any more.
void weld(StepBody& body) {
  TriMesh welded = weldVertices(body.mesh);
  body.faces = facesOf(welded, body.mesh, std::move(body.faces));
  body.mesh = std::move(welded);
}

Result<StepBody> bodyOf(std::string_view bytes, const std::string& path) {
  std::uint64_t length = 0;
  const std::size_t front = kStepMagic.size() + sizeof length;
  if (bytes.size() < front || !bytes.starts_with(kStepMagic)) return brokenStream(path);
  std::memcpy(&length, bytes.data() + kStepMagic.size(), sizeof length);
  bytes.remove_prefix(front);
  if (length > bytes.size()) return brokenStream(path);
  StepBody out;
  try {
    const StepJson head = StepJson::parse(bytes.substr(0, length));
    for (const StepJson& name : head.at("bodies")) out.bodies.push_back(printable(name.get<std::string>()));
    out.name = out.bodies.at(head.at("body").get<std::size_t>());
    out.unit = printable(head.at("unit").get<std::string>());
    for (const StepJson& note : head.at("notes"))
      out.notes.push_back(path + ": the body " + note.get<std::string>());
    for (const StepJson& face : head.at("faces")) out.faces.faces.push_back(faceOf(face));
    if (!takeMesh(bytes.substr(length), head, out)) return brokenStream(path);
  } catch (const std::exception&) {
    return brokenStream(path);
  }
  if (out.mesh.triangles.empty()) return inputError(path + ": has no surface");
  weld(out);
  return out;
}

/// What the process said when it refused the file.
Error refusalOf(const ReaderEnd& end, const std::string& path, const StepLoadOptions& options) {
  if (end.interrupted) return {ErrorKind::kInterrupted, "interrupted"};
  if (end.too_long) {
    return {ErrorKind::kResourceLimit,
            fmt::format("{}: OpenCASCADE has not read it within {} s; export the part alone, or as a mesh",
                        path, options.most_s)};
  }
  if (end.exit_code == kStepRefused && !end.told.empty())
    return inputError(path + ": " + printable(end.told.substr(0, end.told.find('\n'))));
  return inputError(fmt::format(
      "{}: OpenCASCADE has crashed on it ({}): it is damaged, or has what cannot be read; export it again, "
      "or as a mesh",
      path,
      end.signal != 0 ? fmt::format("signal {}", end.signal) : fmt::format("exit code {}", end.exit_code)));
}

}  // namespace

bool isStepFile(std::string_view path) {
  const std::string small = mesh_formats::lowerCase(path);
  return small.ends_with(".step") || small.ends_with(".stp");
}

Status checkStepReader() {
  if (!installedFiles(kStepReaderName).empty()) return Done{};
  return inputError(fmt::format(
      "STEP files are read by {}, which is not installed: `make step` installs OpenCASCADE and builds it "
      "(by hand: apt-get install libocct-data-exchange-dev, then build again); or export the model as STL",
      kStepReaderName));
}

Result<StepBody> loadStep(const std::string& path, const StepLoadOptions& options) {
  if (const Status there = checkStepReader(); !there) return there.error();
  if (const Status readable = checkRegularFile(path); !readable) return readable.error();
  if (std::error_code error; std::filesystem::file_size(path, error) == 0)
    return inputError(path + ": is empty");
  const std::string program = installedFiles(kStepReaderName).front();
  Result<ReaderEnd> end =
      runReader(program,
                {path, options.body, fmt::format("{}", options.chord_mm),
                 fmt::format("{}", options.free_chord_mm), fmt::format("{}", options.most_s)},
                options.most_s);
  if (!end) return end.error();
  if (end->exit_code != 0 || end->signal != 0 || end->too_long) return refusalOf(*end, path, options);
  Result<StepBody> body = bodyOf(end->bytes, path);
  if (body) body->faces.chord_mm = options.free_chord_mm;
  return body;
}

}  // namespace proveout
