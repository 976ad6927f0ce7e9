#include "core/base/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace proveout {

namespace {

/// Optimal string alignment distance: insertions, deletions, substitutions and swaps of neighbours.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

/// What people write for the word of the field: the first one of these that is a candidate.
struct Synonym {
  std::string_view written, meant;
};
constexpr Synonym kSynonyms[] = {
    {"type", "shape"},        {"kind", "type"},         {"kind", "shape"},
    {"shape", "type"},        {"form", "shape"},        {"dia", "diameter"},
    {"d", "diameter"},        {"size", "diameter"},     {"r", "radius"},
    {"file", "mesh"},         {"file", "program"},      {"path", "file"},
    {"path", "mesh"},         {"path", "program"},      {"mesh", "file"},
    {"stl", "mesh"},          {"stl", "file"},          {"model", "mesh"},
    {"id", "number"},         {"nr", "number"},         {"no", "number"},
    {"t", "number"},          {"machine", "control"},   {"controller", "control"},
    {"blank", "stock"},       {"workpiece", "stock"},   {"cad", "nominal"},
    {"reference", "nominal"}, {"subs", "subprograms"},  {"subfolder", "subprograms"},
    {"grid", "resolution"},   {"ramp", "acceleration"},
};

std::string synonymOf(std::string_view word, const std::vector<std::string>& candidates) {
  for (const Synonym& synonym : kSynonyms) {
    if (synonym.written != word) continue;
    const auto found = std::find(candidates.begin(), candidates.end(), synonym.meant);
    if (found != candidates.end()) return *found;
  }
  return {};
}

/// The shortest candidate that begins with the word: "res" stands for "resolution".
std::string beginningWith(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr std::size_t kShortest = 2;
  std::string best;
  for (const std::string& candidate : candidates) {
    const bool begins =
        word.size() >= kShortest && candidate.starts_with(word) && candidate.size() > word.size();
    if (begins && (best.empty() || candidate.size() < best.size())) best = candidate;
  }
  return best;
}

/// Longest word that is compared; keys of people are shorter, and the distance takes quadratic time.
constexpr std::size_t kLongestWord = 64;
/// The first letters of a word, so many, mean it more likely than another word that is as short.
constexpr std::size_t kClearBeginning = 3;

bool sameButForCase(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

}  // namespace

std::string nearestName(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  if (word.size() > kLongestWord) return best;
  for (const std::string& candidate : candidates) {
    if (sameButForCase(word, candidate)) return candidate;
  }
  if (std::string synonym = synonymOf(word, candidates); !synonym.empty()) return synonym;
  if (word.size() >= kClearBeginning) {
    if (std::string longer = beginningWith(word, candidates); !longer.empty()) return longer;
  }
  // More than a third wrong is another word, not a slip.
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = editDistance(word, candidate);
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best.empty() ? beginningWith(word, candidates) : best;
}

std::string didYouMean(const std::string& nearest) {
  return nearest.empty() ? std::string() : ", did you mean '" + nearest + "'?";
}

}  // namespace proveout
