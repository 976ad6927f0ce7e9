#include "core/nc/text/lex_names.h"

#include <algorithm>

#include "core/base/characters.h"

namespace proveout::nc {
namespace {

bool standsAt(std::string_view name, std::string_view text, std::size_t pos) {
  if (pos + name.size() > text.size()) return false;
  for (std::size_t k = 0; k < name.size(); ++k) {
    if (upper(text[pos + k]) != name[k]) return false;
  }
  return true;
}

}  // namespace

void LexNames::addAxis(std::string_view name, int index, int number) {
  const auto axis = static_cast<std::int8_t>(index);
  if (name.size() == 1) {
    letters_[static_cast<std::size_t>(name[0] - 'A')] = axis;
    axes_.push_back({axis, number, name[0]});
    return;
  }
  axes_.push_back({axis, number, kNamedWord});
  longer_.push_back({std::string(name), axis, -1});
  starts_ |= 1u << (name[0] - 'A');
  std::stable_sort(longer_.begin(), longer_.end(),
                   [](const Name& a, const Name& b) { return a.text.size() > b.text.size(); });
}

void LexNames::addSpindle(std::string_view name, int index) {
  longer_.push_back({std::string(name), -1, static_cast<std::int8_t>(index)});
  starts_ |= 1u << (name[0] - 'A');
  std::stable_sort(longer_.begin(), longer_.end(),
                   [](const Name& a, const Name& b) { return a.text.size() > b.text.size(); });
}

const LexNames::Name* LexNames::match(std::string_view text, std::size_t pos) const {
  if (starts_ == 0) return nullptr;
  const char c = upper(text[pos]);
  if (c < 'A' || c > 'Z' || (starts_ >> (c - 'A') & 1u) == 0) return nullptr;
  for (const Name& name : longer_) {
    if (standsAt(name.text, text, pos)) return &name;
  }
  return nullptr;
}

int LexNames::axisByNumber(int number) const {
  const auto found =
      std::find_if(axes_.begin(), axes_.end(), [&](const Axis& axis) { return axis.number == number; });
  return found == axes_.end() ? -1 : found->index;
}

Address LexNames::addressOf(int axis) const {
  const auto found = std::find_if(axes_.begin(), axes_.end(), [&](const Axis& a) { return a.index == axis; });
  return found == axes_.end() ? kNamedWord : found->address;
}

}  // namespace proveout::nc
