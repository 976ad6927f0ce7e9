// What the place of a motion's cut depends on: words of the program and data of the operator.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/path/origin_query.h"
#include "core/tool/tool.h"

namespace proveout {

/// How a wrong word or datum moves a cut surface: along an axis of the workpiece frame (lathes: kX along the
/// radius), or, on walls, along their normal, as a wrong radius does.
enum class CutShift : std::uint8_t { kX, kY, kZ, kRadial };
inline constexpr std::size_t kCutShifts = 4;

/// A word, or a datum of the job, that moves the cuts of a motion.
struct CauseCandidate {
  CutShift shift = CutShift::kX;
  /// Equal for all motions that the same word (by its place) or the same datum moves the same way.
  std::string key;
  int rank = 0;                        ///< of candidates that explain as much, the lower is told first
  std::optional<ResolvedOrigin> word;  ///< none: a datum
  std::string datum;                   ///< key in the job: "offsets.length.2"; empty: a word
  std::string value;                   ///< of a datum, as text
};

/// What a tool path and its tools say about the motions of one clamping.
struct CauseSource {
  const Toolpath& path;
  const std::vector<Tool>& tools;
  bool turning;
  std::string control;  ///< name
  LineText text;
};

/// All candidates of a motion. Empty where the path has no origins.
std::vector<CauseCandidate> candidatesOf(const CauseSource& source, MotionId motion);

/// The words that a motion is made with and the data behind it, those of its own block first: what to look at
/// where nothing tells which of them is wrong.
std::vector<CauseCandidate> inForce(const CauseSource& source, MotionId motion);

/// The words that say how the spindle turns during a motion: M3, M4, M5, then S. Where it was stopped that
/// alone.
std::vector<CauseCandidate> spindleWords(const CauseSource& source, MotionId motion);

}  // namespace proveout
