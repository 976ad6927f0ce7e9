#include "removal/surface/cell/face_joins.h"

#include "removal/cut/cut_record.h"
#include "removal/grid/blank_field.h"

namespace proveout {

namespace {

/// Where material is looked for between the corners that are not in it: the middle first.
constexpr std::array<double, 3> kBetween = {0.5, 0.25, 0.75};

}  // namespace

FaceJoins::FaceJoins(const Stock::Impl& impl)
    : impl_(impl), known_(impl.cut != nullptr && impl.cut_blank != nullptr) {}

CellShape FaceJoins::withJoins(const Coord& at, std::uint8_t pattern, std::uint8_t doubtful) const {
  CellShape shape = pattern;
  for (int face = 0; face < 6; ++face) {
    if ((doubtful >> face & 1) == 0) continue;
    const int axis = face / 2, base = (face & 1) << axis;
    Coord lowest = at;
    lowest[axis] += face & 1;
    if (isJoined(lowest, axis, (pattern >> base & 1) != 0))
      shape |= static_cast<CellShape>(1 << (kJoinedFaces + face));
  }
  return shape;
}

/// `at`: voxel of the face's lowest corner, so that both cells of the face ask for the same places.
bool FaceJoins::isJoined(const Coord& at, int axis, bool lowest_in) const {
  Coord aside = at, up = at, beyond = at;
  aside[(axis + 1) % 3] += 1;
  up[(axis + 2) % 3] += 1;
  beyond[(axis + 1) % 3] += 1;
  beyond[(axis + 2) % 3] += 1;
  const Vec3 a = impl_.position(lowest_in ? at : aside), c = impl_.position(lowest_in ? beyond : up),
             b = impl_.position(lowest_in ? aside : at), d = impl_.position(lowest_in ? up : beyond);
  // What no tool reached is meshed as before.
  if (!isSwept(b) || !isSwept(d)) return false;
  for (const double part : kBetween) {
    const Vec3 middle = b + part * (d - b);
    if (isMaterial(middle)) return isMaterial(0.5 * (a + middle)) && isMaterial(0.5 * (middle + c));
  }
  return false;
}

bool FaceJoins::isSwept(const Vec3& p) const { return impl_.cut->cutters().comesTo(p, 0.0); }

bool FaceJoins::isMaterial(const Vec3& p) const { return impl_.cut_blank->value(p) < 0.0 && !isSwept(p); }

}  // namespace proveout
