// What a control of the ISO family supports, as `proveout coverage` prints it.
#pragma once

#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"
#include "core/nc/iso/model/codes.h"

namespace proveout::nc {

/// The rows of the tables that execute: G codes, M codes, then features.
std::vector<CoverageRow> coverageOf(const CodeIndex& codes);

/// Rows of the manual's parts in one list.
std::vector<CoverageIdRow> joinRows(std::initializer_list<std::span<const CoverageIdRow>> parts);
/// The rows that are not done, each with the reason that it is not built yet.
std::map<std::string, std::string_view> notBuiltYet(const std::vector<CoverageIdRow>& rows);

}  // namespace proveout::nc
