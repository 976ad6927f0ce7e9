#include "core/nc/iso/model/codes.h"

#include <algorithm>
#include <utility>

#include "core/base/assert.h"

namespace proveout::nc {

std::string_view codeClassName(CodeClass cls) {
  switch (cls) {
    case CodeClass::kSim:
      return "SIM";
    case CodeClass::kTime:
      return "TIME";
    case CodeClass::kState:
      return "STATE";
    case CodeClass::kHost:
      return "HOST";
    case CodeClass::kReject:
      return "REJECT";
  }
  return "REJECT";
}

CodeIndex::CodeIndex(std::vector<CodeTable> tables, std::vector<CodeTable> instead,
                     std::span<const std::int32_t> without) {
  const auto replaced = [&](const auto& row, auto CodeTable::*rows, auto number) {
    return std::any_of(instead.begin(), instead.end(), [&](const CodeTable& table) {
      return std::any_of((table.*rows).begin(), (table.*rows).end(),
                         [&](const auto& other) { return number(other) == number(row); });
    });
  };
  const auto g_number = [](const GCode& row) { return row.number10(); };
  const auto m_number = [](const MCode& row) { return row.code; };
  const auto take = [&](const CodeTable& table, bool all) {
    for (const GCode& code : table.g) {
      const bool left_out = std::find(without.begin(), without.end(), code.number10()) != without.end();
      if (all || !(left_out || replaced(code, &CodeTable::g, g_number))) g_sorted_.push_back(&code);
    }
    for (const MCode& code : table.m) {
      if (all || !replaced(code, &CodeTable::m, m_number)) m_sorted_.push_back(&code);
    }
    for (const FeatureRow& row : table.features) features_.push_back(&row);
  };
  for (const CodeTable& table : tables) take(table, false);
  for (const CodeTable& table : instead) take(table, true);
  meanings_ = g_sorted_;
  std::sort(g_sorted_.begin(), g_sorted_.end(),
            [](const GCode* a, const GCode* b) { return a->number10() < b->number10(); });
  std::stable_sort(meanings_.begin(), meanings_.end(),
                   [](const GCode* a, const GCode* b) { return a->code10 < b->code10; });
  std::sort(m_sorted_.begin(), m_sorted_.end(),
            [](const MCode* a, const MCode* b) { return a->code < b->code; });
  const auto same_g = [](const GCode* a, const GCode* b) { return a->number10() == b->number10(); };
  const auto same_m = [](const MCode* a, const MCode* b) { return a->code == b->code; };
  PROVEOUT_ASSERT(std::adjacent_find(g_sorted_.begin(), g_sorted_.end(), same_g) == g_sorted_.end());
  PROVEOUT_ASSERT(std::adjacent_find(m_sorted_.begin(), m_sorted_.end(), same_m) == m_sorted_.end());
  for (const GCode* code : g_sorted_) {
    PROVEOUT_ASSERT(code->group >= 0 && code->group < kGroupCount);
    if (code->number10() < kDense) g_[static_cast<std::size_t>(code->number10())] = code;
  }
  for (const GCode* code : meanings_) {
    if (code->code10 < kDense) in_force_[static_cast<std::size_t>(code->code10)] = code;
  }
}

const GCode* CodeIndex::beyond(const std::vector<const GCode*>& sorted, int number10, NumberOf number) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), number10,
                                   [&](const GCode* code, int wanted) { return (code->*number)() < wanted; });
  return at != sorted.end() && ((*at)->*number)() == number10 ? *at : nullptr;
}

const MCode* CodeIndex::m(int code) const {
  const auto at = std::lower_bound(m_sorted_.begin(), m_sorted_.end(), code,
                                   [](const MCode* row, int wanted) { return row->code < wanted; });
  return at != m_sorted_.end() && (*at)->code == code ? *at : nullptr;
}

}  // namespace proveout::nc
