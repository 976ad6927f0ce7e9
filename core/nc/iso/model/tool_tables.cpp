#include "core/nc/iso/model/tool_tables.h"

namespace proveout::nc {
namespace {

bool usable(const ToolRow& row) {
  if (!row.has(ToolRow::kValid)) return false;
  if (row.status == ToolStatus::kUnmanaged) return row.has(ToolRow::kSearchable);
  return row.status == ToolStatus::kNew || row.status == ToolStatus::kUsed;
}

}  // namespace

const ToolRow* ToolTables::row(int number) const {
  const auto found = rows_.find(number);
  return found == rows_.end() ? nullptr : &found->second;
}

ToolRow* ToolTables::row(int number) {
  const auto found = rows_.find(number);
  return found == rows_.end() ? nullptr : &found->second;
}

void ToolTables::removeRow(int number) {
  rows_.erase(number);
  std::erase_if(places_, [&](const auto& entry) { return entry.second == number; });
}

std::optional<int> ToolTables::select(int type) const {
  std::optional<int> best;
  double most = 0.0;
  for (const auto& [number, tool] : rows_) {
    if (tool.type != type || !usable(tool)) continue;
    if (best && tool.counter <= most) continue;
    best = number;
    most = tool.counter;
  }
  return best;
}

void ToolTables::place(const ToolPlace& at, int row) {
  if (row == 0) {
    places_.erase(at);
  } else {
    places_[at] = row;
  }
}

int ToolTables::at(const ToolPlace& place) const {
  const auto found = places_.find(place);
  return found == places_.end() ? 0 : found->second;
}

bool ToolTables::use(int number, double amount) {
  ToolRow* tool = row(number);
  if (tool == nullptr || tool->status == ToolStatus::kUnmanaged || amount <= 0.0) return false;
  const auto warns = [&] { return tool->limit > 0.0 && tool->limit - tool->counter <= tool->warning; };
  const bool warned = warns();
  tool->counter += amount;
  if (tool->status == ToolStatus::kNew) tool->status = ToolStatus::kUsed;
  if (tool->status == ToolStatus::kUsed && tool->limit > 0.0 && tool->counter >= tool->limit) {
    tool->status = ToolStatus::kExpired;
  }
  return warns() && !warned && tool->warning > 0.0;
}

const ToolShape* ToolTables::shape(int number) const {
  const auto found = shapes_.find(number);
  return found == shapes_.end() ? nullptr : &found->second;
}

}  // namespace proveout::nc
