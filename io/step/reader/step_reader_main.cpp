// proveout-step FILE BODY CHORD_MM FREE_CHORD_MM SECONDS: reads a body of a STEP file and writes it as
// step_stream.h says. BODY: its name, or its number from 1, or empty where there is but one. SECONDS:
// processor time that it may take.
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "io/step/reader/step_bodies.h"
#include "io/step/reader/step_facets.h"
#include "io/step/step_stream.h"

namespace proveout::step_reader {
namespace {

/// "1 plate, 2 (without a name), ..."
std::string listOf(const std::vector<Body>& bodies) {
  constexpr std::size_t kMost = 20;
  std::string out;
  for (std::size_t k = 0; k < std::min(bodies.size(), kMost); ++k) {
    out += (k > 0 ? ", " : "") + std::to_string(k + 1) + " ";
    out += bodies[k].name.empty() ? "(without a name)" : bodies[k].name;
  }
  return bodies.size() > kMost ? out + ", ..." : out;
}

std::size_t choose(const std::vector<Body>& bodies, const std::string& wanted) {
  if (wanted.empty()) {
    if (bodies.size() == 1) return 0;
    throw Refusal{"has " + std::to_string(bodies.size()) +
                  " bodies: choose one by its name or number, body = \"" +
                  (bodies[0].name.empty() ? "1" : bodies[0].name) + "\"; there are " + listOf(bodies)};
  }
  const auto named = [&](const Body& body) { return body.name == wanted; };
  const auto count = std::count_if(bodies.begin(), bodies.end(), named);
  if (count == 1)
    return static_cast<std::size_t>(std::find_if(bodies.begin(), bodies.end(), named) - bodies.begin());
  if (count > 1)
    throw Refusal{"has " + std::to_string(count) + " bodies named " + wanted +
                  ": choose one by its number; there are " + listOf(bodies)};
  char* end = nullptr;
  const unsigned long number = std::strtoul(wanted.c_str(), &end, 10);
  if (*end != '\0' || number < 1 || number > bodies.size())
    throw Refusal{"has no body " + wanted + "; there are " + listOf(bodies)};
  return number - 1;
}

template <class Row>
void writeRows(std::FILE* out, const std::vector<Row>& rows) {
  std::fwrite(rows.data(), sizeof(Row), rows.size(), out);
}

void write(std::FILE* out, const nlohmann::json& head, const Facets& facets) {
  const std::string text = head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::uint64_t length = text.size();
  std::fwrite(kStepMagic.data(), 1, kStepMagic.size(), out);
  std::fwrite(&length, sizeof length, 1, out);
  std::fwrite(text.data(), 1, text.size(), out);
  writeRows(out, facets.vertices);
  writeRows(out, facets.triangles);
  writeRows(out, facets.face_of);
}

nlohmann::json faceOf(const StepDocument& document, const Facets& facets, std::size_t k,
                      const TopoDS_Shape& body) {
  const FaceSurface& s = facets.surfaces[k];
  nlohmann::json out = {
      {"kind", s.kind},     {"origin", s.origin},           {"axis", s.axis},
      {"radius", s.radius}, {"tube_radius", s.tube_radius}, {"half_angle", s.half_angle_rad},
      {"turn", s.turn_rad}, {"hollow", s.hollow},           {"name", document.nameOf(facets.faces[k])}};
  if (const auto colour = document.colourOf(facets.faces[k], body)) out["colour"] = *colour;
  return out;
}

/// Whether the body was written: not where it was read without repair and its facets are not closed.
bool read(std::FILE* out, char** arguments, Repair repair) {
  const StepDocument document(arguments[1], repair);
  const std::vector<Body> bodies = document.bodies();
  const std::size_t chosen = choose(bodies, arguments[2]);
  const Body& body = bodies[chosen];
  const Facets facets = facetsOf(body.shape, std::atof(arguments[3]), std::atof(arguments[4]));
  if (repair == Repair::kNone && !areClosed(facets)) return false;
  nlohmann::json head = {{"unit", document.unit()},
                         {"bodies", nlohmann::json::array()},
                         {"body", chosen},
                         {"notes", nlohmann::json::array()},
                         {"faces", nlohmann::json::array()},
                         {"vertices", facets.vertices.size()},
                         {"triangles", facets.triangles.size()}};
  for (const Body& each : bodies) head["bodies"].push_back(each.name);
  if (!body.note.empty()) head["notes"].push_back(body.note);
  for (std::size_t k = 0; k < facets.faces.size(); ++k)
    head["faces"].push_back(faceOf(document, facets, k, body.shape));
  write(out, head, facets);
  return true;
}

/// Without repair first, in a process of its own: what the library makes of a damaged shape may end it.
/// False: that did not do.
bool readUnrepaired(std::FILE* out, char** arguments) {
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    bool done = false;
    try {
      done = read(out, arguments, Repair::kNone) && std::fclose(out) == 0;
    } catch (...) {  // repaired it may do
    }
    std::_Exit(done ? 0 : 1);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) std::raise(SIGXCPU);  // its time is over
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void run(std::FILE* out, char** arguments) {
  if (!readUnrepaired(out, arguments)) read(out, arguments, Repair::kAll);
}

/// A loop in the library ends the process, and so does a file that asks for more memory than any part needs.
void limitSelf(int seconds) {
  constexpr rlim_t kMostBytes = rlim_t{8} << 30;
  const auto s = static_cast<rlim_t>(std::max(seconds, 1));
  const rlimit time = {s, s + 1}, memory = {kMostBytes, kMostBytes};
  const rlimit none = {0, 0};  // a crash is expected, and its memory nobody's business
  setrlimit(RLIMIT_CORE, &none);
  setrlimit(RLIMIT_CPU, &time);
#ifndef PROVEOUT_SANITIZED  // sanitizers reserve far more than they use
  setrlimit(RLIMIT_AS, &memory);
#else
  (void)memory;
#endif
}

int refuse(const std::string& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return kStepRefused;
}

}  // namespace
}  // namespace proveout::step_reader

int main(int count, char** arguments) {
  using namespace proveout::step_reader;
  if (count != 6) return refuse("usage: proveout-step FILE BODY CHORD_MM FREE_CHORD_MM SECONDS");
  // The library tells what it does on standard output, which is for the result.
  std::FILE* const out = fdopen(dup(STDOUT_FILENO), "wb");
  if (out == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr)
    return refuse("standard output cannot be written");
  limitSelf(std::atoi(arguments[5]));
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  try {
    run(out, arguments);
  } catch (const Refusal& refusal) {
    return refuse(refusal.message);
  } catch (const Standard_Failure& failure) {
    return refuse(std::string("cannot be read by OpenCASCADE (") + failure.DynamicType()->Name() +
                  "); export it again, or as a mesh");
  } catch (const std::exception& failure) {
    return refuse(std::string("cannot be read: ") + failure.what());
  }
  if (std::fclose(out) != 0) return refuse("what was read cannot be handed on");
  std::_Exit(0);  // the library takes its time to take everything down
}
