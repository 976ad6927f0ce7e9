#include "app/session/findings/standing_spindle.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/findings/spindle_watch.h"
#include "io/report_text.h"

namespace proveout {
namespace {

/// The word in force that stopped or started it, "M5" where the program calls it so; else `otherwise`.
std::string word(const Toolpath& path, const RecordingSource& texts, MotionId motion, const PathEvent& event,
                 const char* otherwise) {
  if (path.motions[motion].source.origins < 0) return otherwise;
  const auto said = originOf(path, motion, OriginKind::kSpindleDirection, lineText(path, texts));
  const bool same = said && said->line == event.source.line && said->file == event.source.file;
  return same && !said->text.empty() ? said->text : otherwise;
}

const PathEvent* firstStart(const Toolpath& path, int channel) {
  for (const Toolpath::EventAt& at : path.events) {
    const auto* spindle = at.event.as<event::Spindle>();
    if (spindle != nullptr && at.event.channel == channel && letsTurn(*spindle)) return &at.event;
  }
  return nullptr;
}

}  // namespace

bool StandingSpindle::isOperators() const {
  const bool turns = std::any_of(path_.motions.begin(), path_.motions.end(),
                                 [](const Motion& motion) { return motion.spindle != 0.0; });
  if (turns || path_.motions.empty()) return false;
  SpindleWatch watch(path_);
  return watch.before(static_cast<MotionId>(path_.motions.size() - 1)) == nullptr;
}

std::string StandingSpindle::place(const PathEvent& event) const {
  return report_text::place(blockRef(path_, event.source, texts_));
}

std::string StandingSpindle::reason(MotionId motion) const {
  const PathEvent* const last = SpindleWatch(path_).before(motion);
  if (last == nullptr) {
    const PathEvent* const later = firstStart(path_, path_.motions[motion].channel);
    if (later == nullptr) return ", M3 is missing";
    return fmt::format(", it is started only later, in {}", place(*later));
  }
  if (letsTurn(*last->as<event::Spindle>()))
    return fmt::format(", no speed S was given for {} ({})", word(path_, texts_, motion, *last, "its start"),
                       place(*last));
  return fmt::format(", since {} ({})", word(path_, texts_, motion, *last, "its stop"), place(*last));
}

}  // namespace proveout
