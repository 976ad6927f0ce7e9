// What a run was told to accept of its findings: severities by kind, kinds that count, findings that are
// known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/geometry/types.h"
#include "io/finding_kind.h"

namespace proveout {

/// Severities that the job gives to kinds of findings; none: they are turned off, and only counted.
using SeverityChoice = std::map<FindingKind, std::optional<Severity>>;

/// Kinds that count and are listed: `select`, or all where it is empty, without `ignore`. Binding kinds
/// always do.
struct KindFilter {
  std::vector<FindingKind> select, ignore;
};

/// A finding as a baseline keeps it.
struct KnownFinding {
  FindingKind kind = FindingKind::kGouge;
  Severity severity = Severity::kError;
  std::string setup;       ///< name of the clamping; empty in a job without setups
  std::string file;        ///< of the block, without its folder; empty: no block is to blame
  std::uint32_t line = 0;  ///< from 1
  std::string block;       ///< text of the block, without N number and with single blanks
  std::string last_block;  ///< text of the last one, where several blocks did the same
  std::optional<Vec3> where;
  std::optional<double> depth_mm, area_mm2, volume_mm3;
  std::size_t spots = 1;
  std::string message;
};

/// Findings that were not listed, and on whose word.
struct LeftOut {
  FindingKind kind;
  std::size_t count = 0;
  std::string by;  ///< "the job", "--select", "--ignore"
};

/// What findings were held against.
struct BaselineUse {
  std::string file;
  std::string sha256;
  std::size_t known = 0;           ///< findings of the run that it has
  bool looked_for_all = true;      ///< false: only a part was run, and what is gone is not known
  std::vector<KnownFinding> gone;  ///< of the kinds that count: not found any more
};

struct ReportAcceptance {
  SeverityChoice severities;
  KindFilter filter;
  std::vector<LeftOut> left_out;
  std::optional<BaselineUse> baseline;

  bool none() const {
    return severities.empty() && filter.select.empty() && filter.ignore.empty() && !baseline;
  }
};

}  // namespace proveout
