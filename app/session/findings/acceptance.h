// What counts of the findings of a run: severities of the job, chosen kinds, a baseline.
#pragma once

#include <string>
#include <vector>

#include "app/session/findings/known_findings.h"
#include "core/base/result.h"
#include "io/job/job.h"
#include "io/report.h"

namespace proveout {

/// What the command line says of it.
struct AcceptanceWish {
  struct File {
    std::string path, sha256;
    std::vector<KnownFinding> findings;
  };
  KindFilter filter;
  std::optional<File> baseline;
};

/// Reads lists of kinds, "gouge,excess". Errors: a name that no kind has, with the nearest one; a kind in
/// both, twice or none at all; `ignore` of a binding kind, which would hide that a result is missing.
Result<KindFilter> parseKindFilter(const std::vector<std::string>& select,
                                   const std::vector<std::string>& ignore);

/// Reads the file of --baseline. Errors: as parseBaseline; where there is no such file it says how one is
/// written.
Result<AcceptanceWish::File> loadBaseline(const std::string& path);

/// Gives findings the severities of the job, takes away those that are turned off or of kinds that do not
/// count, and marks the known ones. `compared`: the part was compared with a nominal. Returns what was done,
/// for the report.
ReportAcceptance accept(const Job& job, const AcceptanceWish& wish, bool compared,
                        std::vector<Finding>& findings);

}  // namespace proveout
