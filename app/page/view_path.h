// The tool path of a run as the 3-D view of its page shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/session/run/run_result.h"
#include "io/report/view/scene_data.h"

namespace proveout {

/// The path of all clampings in the last one's frame, and where findings are on it.
class PathOfRun {
 public:
  /// At most about `most_points` points: of longer paths those near to others are left out.
  PathOfRun(const RunResult& run, const RunSources& sources, std::size_t most_points);

  /// None: there are no motions.
  const std::optional<ViewPath>& path() const { return path_; }
  std::optional<ViewPath> take() { return std::move(path_); }
  /// The block that a finding names, its own execution where that is known; -1: none.
  std::int64_t blockOf(const Finding& finding) const;

 private:
  friend class PathTracer;
  const RunResult& run_;
  std::optional<ViewPath> path_;
  std::vector<std::vector<std::uint32_t>> block_of_motion_;  ///< by clamping and motion
};

}  // namespace proveout
