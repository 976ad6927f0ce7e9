// The name that a misspelt one may mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proveout {

/// The candidate nearest to `word` in edit distance, or "" where none is near enough to be meant.
std::string nearestName(std::string_view word, const std::vector<std::string>& candidates);

/// The name that may be meant as the end of a clause: ", did you mean 'shape'?"; "" for "".
std::string didYouMean(const std::string& nearest);

}  // namespace proveout
