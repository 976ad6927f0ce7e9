// Short names for the tables of this folder only.
#pragma once

#include <array>

#include "core/nc/nct/coverage/coverage_rows.h"

namespace proveout::nc::coverage_rows {

constexpr CodeClass kSim = CodeClass::kSim;
constexpr CodeClass kTime = CodeClass::kTime;
constexpr CodeClass kState = CodeClass::kState;
constexpr CodeClass kHost = CodeClass::kHost;
constexpr CodeClass kReject = CodeClass::kReject;

constexpr RowStatus kDone = RowStatus::kDone;
constexpr RowStatus kPartly = RowStatus::kPartly;
constexpr RowStatus kMissing = RowStatus::kMissing;
constexpr RowStatus kDeferred = RowStatus::kDeferred;

}  // namespace proveout::nc::coverage_rows
