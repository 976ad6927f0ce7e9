// The name that a misspelt one may mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proveout {

/// The candidate nearest to `word` in edit distance, or "" where none is near enough to be meant.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace proveout
