#include "io/verdict.h"

#include <algorithm>

#include "io/report.h"

namespace proveout {

std::string_view verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "fail";
    case Verdict::kError:
      return "error";
  }
  return "error";
}

Verdict verdictOf(const Report& report) {
  const auto isError = [](const Diagnostic& d) { return d.severity == Severity::kError; };
  if (std::any_of(report.diagnostics.begin(), report.diagnostics.end(), isError)) return Verdict::kError;
  bool failed = report.comparison && !report.comparison->decided;
  for (const Finding& finding : report.findings) {
    if (finding.severity != Severity::kError || finding.known) continue;
    if (finding.kind == FindingKind::kAlarm) return Verdict::kError;
    failed = true;
  }
  return failed ? Verdict::kFail : Verdict::kPass;
}

}  // namespace proveout
