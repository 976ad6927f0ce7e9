// From the words of the wire EDM control to lines and arcs (digest wedm, D5).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/nc/wedm/wedm_plan.h"

namespace proveout::nc {

/// Words of one shape and where it starts.
struct WordShape {
  const std::vector<WedmWord>* words;
  Vec2 from;
  int motion;
};

bool hasWordOf(const std::vector<WedmWord>& words, std::string_view addresses);
/// Where the words of two axes lead, `first` and the letter behind it: mirrored, swapped, in the work system
/// of that origin or from `from`. Workpiece frame, mm. Errors: reported, none.
std::optional<Vec2> targetOf(WedmContext& c, const WedmState& s, const std::vector<WedmWord>& words,
                             char first, const Vec2& from, const Vec2& origin);
/// The line or arc that the words make. Errors: reported, none.
std::optional<ContourElement> elementOf(WedmContext& c, const WedmState& s, const WordShape& shape);

}  // namespace proveout::nc
