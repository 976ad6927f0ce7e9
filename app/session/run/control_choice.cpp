#include "app/session/run/control_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/printable.h"
#include "core/nc/guess/control_guess.h"

namespace proveout {
namespace {

constexpr const char* kFlavour = "flavour";

/// What a clamping, or a job without clampings, says of its control.
struct Place {
  std::string& control;
  std::string& note;
  const SettingsByTable& tables;
  std::vector<ControlSettings*> settings;  ///< of all channels
};

const ControlInfo& infoNamed(const std::string& name) {
  const auto& all = controls();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const ControlInfo& c) { return c.name == name; });
  PROVEOUT_ASSERT(found != all.end());
  return *found;
}

void fill(Place& place, const std::string& name, const std::string& flavour, const std::string& note) {
  const ControlInfo& info = infoNamed(name);
  place.control = name;
  place.note = note;
  std::map<std::string, double> given;
  const auto table = place.tables.find(std::string(info.settings_table));
  if (table != place.tables.end()) given = table->second;
  if (const auto value = flavourValue(info.id, flavour)) given.emplace(kFlavour, *value);
  for (ControlSettings* settings : place.settings) settings->parameters.insert(given.begin(), given.end());
}

/// Only one control has channels.
constexpr const char* kChannelControl = "nct";

Status choose(Place& place, const Job& job, const ProgramSource& program) {
  if (!job.channels.empty()) {
    fill(place, kChannelControl, "",
         fmt::format("taken for a program of {}: no other control has channels", kChannelControl));
    return Done{};
  }
  const Result<ProgramText> text = program.mainProgram();
  if (!text) return text.error();
  const GuessedControl guess = guessControl(text->name, text->bytes);
  if (!guess.chosen) return inputError(fmt::format("{}: {}", text->name, guess.refusalText()));
  fill(place, guess.chosen->control, guess.chosen->flavour,
       fmt::format("taken for a program of {}", guess.choiceText()));
  return Done{};
}

/// The word of the setting `flavour`; empty: the control has none.
std::string flavourOf(const ControlInfo& info, const ControlSettings& settings) {
  for (const ParameterInfo& parameter : parameterTable(info.id)) {
    if (parameter.name != kFlavour) continue;
    const auto given = settings.parameters.find(kFlavour);
    double left = given == settings.parameters.end() ? parameter.default_value : given->second;
    std::string_view words = parameter.choices;
    for (; left > 0.5 && !words.empty(); left -= 1.0) {
      const std::size_t blank = words.find(' ');
      words = blank == std::string_view::npos ? std::string_view() : words.substr(blank + 1);
    }
    return std::string(words.substr(0, words.find(' ')));
  }
  return {};
}

Diagnostic noteOf(const char* code, std::string message, const std::string& program) {
  Diagnostic note;
  note.severity = Severity::kNote;
  note.code = code;
  note.message = std::move(message);
  note.where.file = program;
  return note;
}

}  // namespace

bool leavesControl(const Job& job) {
  return job.control == kAutoControl ||
         std::any_of(job.setups.begin(), job.setups.end(),
                     [](const SetupSpec& setup) { return setup.control == kAutoControl; });
}

Status chooseControls(Job& job, const std::vector<const ProgramSource*>& programs) {
  const bool job_leaves = job.control == kAutoControl;
  if (job.setups.empty()) {
    if (!job_leaves) return Done{};
    Place place{job.control, job.control_note, job.settings_by_table, {&job.settings}};
    for (ChannelSpec& channel : job.channels) place.settings.push_back(&channel.settings);
    return choose(place, job, *programs.front());
  }
  for (std::size_t k = 0; k < job.setups.size(); ++k) {
    SetupSpec& setup = job.setups[k];
    const bool of_job = setup.control.empty() && job_leaves;
    if (setup.control != kAutoControl && !of_job) continue;
    Place place{setup.control,
                setup.control_note,
                of_job ? job.settings_by_table : setup.settings_by_table,
                {&setup.settings}};
    if (Status done = choose(place, job, *programs[k]); !done) return done;
  }
  if (job_leaves) job.control = job.setups.front().control;
  return Done{};
}

std::optional<Diagnostic> otherControlNote(const Job& job, const ProgramText& program) {
  if (!job.control_note.empty() || !job.channels.empty()) return std::nullopt;
  constexpr std::size_t kMostBytes = 4'000'000;  // as much of a program as a note is worth
  const std::string_view text = std::string_view(program.bytes).substr(0, kMostBytes);
  const GuessedControl guess = guessControl(program.name, text);
  if (!guess.chosen) return std::nullopt;
  const ControlGuess& chosen = *guess.chosen;
  const std::string flavour = flavourOf(infoNamed(job.control), job.settings);
  if (chosen.control == job.control && (chosen.flavour.empty() || chosen.flavour == flavour))
    return std::nullopt;
  return noteOf("control",
                fmt::format("this looks like a program of {}; the job runs it on {}{}", guess.choiceText(),
                            job.control, flavour.empty() ? "" : fmt::format(" (flavour {})", flavour)),
                program.name);
}

std::optional<Diagnostic> choiceNote(const Job& job) {
  if (job.control_note.empty()) return std::nullopt;
  return noteOf("control", job.control_note, "");
}

}  // namespace proveout
