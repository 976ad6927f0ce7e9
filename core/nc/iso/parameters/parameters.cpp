#include "core/nc/iso/parameters/parameters.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <numeric>
#include <utility>

#include "core/base/assert.h"

namespace proveout::nc {
namespace {

std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

/// "N0107.REN.4" -> "N0107.REN" and 4; without a number at the end 0.
std::pair<std::string_view, int> splitIndex(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {name, 0};
  int index = 0;
  const char* last = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data() + dot + 1, last, index);
  if (error != std::errc() || end != last || index < 1) return {name, 0};
  return {name.substr(0, dot), index};
}

bool inRange(const ParamInfo& info, double value) {
  return value >= info.min && value <= info.max && (info.bit == kWholeParam || value == 0 || value == 1);
}

}  // namespace

IsoParameters::IsoParameters(const ParameterTable& table) : table_(table) {
  for (std::size_t chapter = 0; chapter < chapter_first_.size(); ++chapter) {
    chapter_first_[chapter] = rows_.size();
    for (const ParamInfo& info : table.chapter(static_cast<ParamChapter>(chapter))) {
      const auto count = static_cast<std::uint32_t>(scopeCount(info.scope));
      rows_.push_back({static_cast<std::uint32_t>(values_.size()), count});
      infos_.push_back(&info);
      values_.insert(values_.end(), count, info.default_value);
    }
  }
  PROVEOUT_ASSERT(infos_.size() == rows_.size());
  given_.assign(values_.size(), 0);
  by_number_.resize(rows_.size());
  std::iota(by_number_.begin(), by_number_.end(), std::size_t{0});
  std::stable_sort(by_number_.begin(), by_number_.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(infos_[a]->number, infos_[a]->bit) < std::pair(infos_[b]->number, infos_[b]->bit);
  });
}

Status IsoParameters::set(const std::map<std::string, double>& values) {
  for (const auto& [name, value] : values) {
    if (const Status status = setOne(name, value); !status) return status;
  }
  return Done{};
}

Status IsoParameters::setOne(const std::string& name, double value) {
  const auto [base, index] = splitIndex(name);
  const auto of = [&](std::string_view wanted) {
    return std::find_if(infos_.begin(), infos_.end(),
                        [&](const ParamInfo* p) { return !p->name.empty() && p->name == wanted; });
  };
  const auto found = index > 0 ? of(base) : of(name);
  const bool indexed = found != infos_.end() && scopeCount((*found)->scope) > 1;
  if (found == infos_.end() || (index > 0 && !indexed)) {
    const auto bit = std::find_if(infos_.begin(), infos_.end(),
                                  [&](const ParamInfo* q) { return q->name.starts_with(name + "."); });
    if (bit != infos_.end()) {
      return inputError(fmt::format("parameter {} of control {} is set by its bits (for example {})", name,
                                    table_.control(), (*bit)->name));
    }
    if (const std::string_view instead = table_.insteadOf(name); !instead.empty()) {
      return inputError(fmt::format("parameter {} of control {} is not set by its number: {}", name,
                                    table_.control(), instead));
    }
    return inputError(
        fmt::format("unknown parameter {} of control {}{}", name, table_.control(), nearestTo(name)));
  }
  const ParamInfo& info = **found;
  const Row& row = rows_[static_cast<std::size_t>(found - infos_.begin())];
  if (index > static_cast<int>(row.count)) {
    return inputError(fmt::format("parameter {}: numbers go up to {}", name, row.count));
  }
  if (!inRange(info, value)) {
    const bool is_flag = info.bit != kWholeParam;
    return inputError(fmt::format("parameter {} = {}: must be {} {} to {}", name, value,
                                  is_flag ? "0 or 1, that is" : "from", info.min, info.max));
  }
  const std::size_t first = row.first + (index > 0 ? static_cast<std::size_t>(index - 1) : 0);
  const std::size_t count = index > 0 ? 1 : row.count;
  std::fill_n(values_.begin() + static_cast<std::ptrdiff_t>(first), count, value);
  std::fill_n(given_.begin() + static_cast<std::ptrdiff_t>(first), count, std::uint8_t{1});
  ++revision_;
  return Done{};
}

/// " (nearest known: N1339)"; empty where the control has no parameters.
std::string IsoParameters::nearestTo(std::string_view name) const {
  const ParamInfo* nearest = nullptr;
  std::size_t distance = std::numeric_limits<std::size_t>::max();
  for (const ParamInfo* info : infos_) {
    const std::size_t other = info->name.empty() ? distance : editDistance(info->name, name);
    if (other >= distance) continue;
    nearest = info;
    distance = other;
  }
  return nearest == nullptr ? "" : fmt::format(" (nearest known: {})", nearest->name);
}

ParamStatus IsoParameters::find(int number, int bit, int index, std::size_t& row, std::size_t& slot) const {
  const auto first = std::lower_bound(by_number_.begin(), by_number_.end(), number,
                                      [&](std::size_t r, int wanted) { return infos_[r]->number < wanted; });
  if (first == by_number_.end() || infos_[*first]->number != number) return ParamStatus::kUnknown;
  const bool of_bits = infos_[*first]->bit != kWholeParam;
  if (of_bits && bit == kWholeParam) return ParamStatus::kNeedsBit;
  auto at = first;
  while (at != by_number_.end() && infos_[*at]->number == number && infos_[*at]->bit != bit) ++at;
  if (at == by_number_.end() || infos_[*at]->number != number) return ParamStatus::kUnknown;
  row = *at;
  const bool indexed = rows_[row].count > 1;
  if (indexed && index == 0) return ParamStatus::kNeedsIndex;
  const int last = infos_[row]->scope == ParamScope::kGlobal ? 0 : static_cast<int>(rows_[row].count);
  if (index < 0 || index > last) return ParamStatus::kBadIndex;
  slot = rows_[row].first + (indexed ? static_cast<std::size_t>(index - 1) : 0);
  return ParamStatus::kOk;
}

void IsoParameters::put(std::size_t slot, double value) {
  values_[slot] = value;
  given_[slot] = 1;
  ++revision_;
}

ParamStatus IsoParameters::write(int number, int bit, int index, double value, bool add) {
  std::size_t row = 0, slot = 0;
  if (const ParamStatus status = find(number, bit, index, row, slot); status != ParamStatus::kOk)
    return status;
  const ParamInfo& info = *infos_[row];
  if (info.restart) return ParamStatus::kRestart;
  const double wanted = add ? values_[slot] + value : value;
  if (!inRange(info, wanted)) return ParamStatus::kOutOfRange;
  put(slot, wanted);
  if (info.scope != ParamScope::kGlobal) return ParamStatus::kOk;
  for (IsoParameters* other : others_) other->put(slot, wanted);
  return ParamStatus::kOk;
}

std::vector<std::string_view> IsoParameters::notedNames() const {
  std::vector<std::string_view> names;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const auto first = given_.begin() + static_cast<std::ptrdiff_t>(rows_[r].first);
    const bool any = std::any_of(first, first + static_cast<std::ptrdiff_t>(rows_[r].count),
                                 [](std::uint8_t given) { return given != 0; });
    if (infos_[r]->noted && any) names.push_back(infos_[r]->name);
  }
  return names;
}

ParamStatus IsoParameters::read(int number, int bit, int index, double& out) const {
  std::size_t row = 0, slot = 0;
  const ParamStatus status = find(number, bit, index, row, slot);
  if (status == ParamStatus::kOk) out = values_[slot];
  return status;
}

}  // namespace proveout::nc
