// What the wire covers on stretches that follow each other, as one polygon. Only for the .cpp files of
// sections: pulls in Clipper.
#pragma once

#include <polyclipping/clipper.hpp>
#include <span>
#include <utility>

#include "removal/wire/section/wire_stretch.h"

namespace proveout::wire_detail {

inline constexpr double kUnit = 1e-6;         ///< mm: a nanometre, the unit of integer points
inline constexpr double kKerfChordMm = 1e-4;  ///< chords leave arcs by no more

ClipperLib::IntPoint toUnits(const Vec2& p);
Vec2 toMm(const ClipperLib::IntPoint& p);

/// Points as integers, without one twice in a row.
class OutlinePath {
 public:
  void add(const Vec2& p) {
    const ClipperLib::IntPoint at = toUnits(p);
    if (path_.empty() || !(path_.back() == at)) path_.push_back(at);
  }
  /// The closed path.
  ClipperLib::Path take() {
    while (path_.size() > 1 && path_.front() == path_.back()) path_.pop_back();
    return std::move(path_);
  }

 private:
  ClipperLib::Path path_;
};

/// Whether `next` goes on where `before` ends, with the same kerf.
bool follows(const WireStretch& before, const WireStretch& next);

/// A closed polygon whose points with a winding above 0 are the kerf; none winds below 0. `run`: stretches
/// that follow each other, one or more.
ClipperLib::Path kerfOutline(std::span<const WireStretch> run);

}  // namespace proveout::wire_detail
