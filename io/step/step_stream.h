// What the reader's process (io/step/reader/) writes to its standard output, and step_file.cpp reads.
//
// kStepMagic, the length of the text (8 bytes, little endian), the text: JSON with
//   "unit"       unit of lengths in the file, as it is written there; all below is mm
//   "bodies"     names of the file's bodies, in its order
//   "body"       index of the one that follows
//   "notes"      one sentence each: what was done about a body that is no plain solid
//   "faces"      objects with "kind" (index of SurfaceKind), "origin", "axis", "radius", "tube_radius",
//                "half_angle", "turn", "hollow", "name" and, where it has one, "colour"
//   "vertices", "triangles"  how many follow
// then the vertices (3 floats each), the corners of the triangles (3 of 4 bytes each) and a face for each
// triangle (4 bytes). On an error the process writes one line to its standard error and ends with
// kStepRefused.
#pragma once

#include <string_view>

namespace proveout {

inline constexpr std::string_view kStepMagic = "PVSTEP01";
inline constexpr int kStepRefused = 2;
/// Name of the program in lib/proveout.
inline constexpr std::string_view kStepReaderName = "proveout-step";

}  // namespace proveout
