// Baseline files: findings that are known and accepted, as text that is stable and shows well in a diff.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "io/report.h"

namespace proveout {

/// What a baseline keeps of a finding.
KnownFinding knownFinding(const Finding& finding);

/// The text of a baseline, schema proveout.baseline/1: a finding a line, sorted by clamping, file, line, kind
/// and place; figures to 0.0001. Binding kinds are left out. The same findings give the same bytes.
std::string baselineText(const std::vector<Finding>& findings);

/// How many of the findings baselineText() keeps.
std::size_t baselineCount(const std::vector<Finding>& findings);

/// Reads such a text. Errors, which begin with `name`: no JSON, another schema, a kind that is not known or
/// is binding, an entry of another form; each says that --write-baseline writes it anew.
Result<std::vector<KnownFinding>> parseBaseline(const std::string& text, const std::string& name);

}  // namespace proveout
