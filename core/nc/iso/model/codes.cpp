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

CodeIndex::CodeIndex(std::vector<CodeTable> tables) : tables_(std::move(tables)) {
  for (const CodeTable& table : tables_) {
    for (const GCode& code : table.g) g_sorted_.push_back(&code);
    for (const MCode& code : table.m) m_sorted_.push_back(&code);
    for (const FeatureRow& row : table.features) features_.push_back(&row);
  }
  std::sort(g_sorted_.begin(), g_sorted_.end(),
            [](const GCode* a, const GCode* b) { return a->code10 < b->code10; });
  std::sort(m_sorted_.begin(), m_sorted_.end(),
            [](const MCode* a, const MCode* b) { return a->code < b->code; });
  const auto same_g = [](const GCode* a, const GCode* b) { return a->code10 == b->code10; };
  const auto same_m = [](const MCode* a, const MCode* b) { return a->code == b->code; };
  PROVEOUT_ASSERT(std::adjacent_find(g_sorted_.begin(), g_sorted_.end(), same_g) == g_sorted_.end());
  PROVEOUT_ASSERT(std::adjacent_find(m_sorted_.begin(), m_sorted_.end(), same_m) == m_sorted_.end());
  for (const GCode* code : g_sorted_) {
    PROVEOUT_ASSERT(code->group >= 0 && code->group < kGroupCount);
    if (code->code10 < kDense) g_[static_cast<std::size_t>(code->code10)] = code;
  }
}

const GCode* CodeIndex::gBeyond(int code10) const {
  const auto at = std::lower_bound(g_sorted_.begin(), g_sorted_.end(), code10,
                                   [](const GCode* code, int wanted) { return code->code10 < wanted; });
  return at != g_sorted_.end() && (*at)->code10 == code10 ? *at : nullptr;
}

const MCode* CodeIndex::m(int code) const {
  const auto at = std::lower_bound(m_sorted_.begin(), m_sorted_.end(), code,
                                   [](const MCode* row, int wanted) { return row->code < wanted; });
  return at != m_sorted_.end() && (*at)->code == code ? *at : nullptr;
}

}  // namespace proveout::nc
