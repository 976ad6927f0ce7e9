#include "app/offset_options.h"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "app/console.h"
#include "app/session/run/job_defaults.h"
#include "core/base/printable.h"
#include "io/job/job_offsets.h"

namespace proveout {
namespace {

/// Settings that an offset goes into.
struct Place {
  std::string name;  ///< of the clamping, number of the channel; empty: the job's own
  std::string control;
  ControlSettings* settings;
};

std::vector<Place> placesOf(Job& job) {
  std::vector<Place> places = {{"", job.control, &job.settings}};
  for (SetupSpec& setup : job.setups)
    places.push_back({setup.name, setup.control.empty() ? job.control : setup.control, &setup.settings});
  for (ChannelSpec& channel : job.channels)
    places.push_back({fmt::format("{}", channel.settings.channel), job.control, &channel.settings});
  return places;
}

/// What stands before the colon, where it names a clamping or channel; else nothing is taken off `text`.
std::string takePlace(const std::vector<Place>& places, std::string& text) {
  for (const Place& place : places) {
    if (place.name.empty() || !text.starts_with(place.name + ":")) continue;
    text.erase(0, place.name.size() + 1);
    return place.name;
  }
  return {};
}

}  // namespace

void applyOffsets(const std::vector<std::string>& offsets, Job& job, Diagnostics& diagnostics) {
  const JobNames names = jobNames();
  const std::vector<Place> places = placesOf(job);
  std::set<std::pair<std::string, std::string>> given;  // place and name
  for (const std::string& offset : offsets) {
    std::string text = offset, refusal;
    const std::string where = takePlace(places, text);
    bool taken = false, twice = false;
    for (const Place& place : places) {
      const auto parameters = names.parameters.find(place.control);
      if ((!where.empty() && place.name != where) || parameters == names.parameters.end()) continue;
      const Result<OffsetEntry> entry = parseOffset(text, parameters->second);
      if (!entry) {  // another clamping may have a control that knows it
        refusal = entry.error().message;
        continue;
      }
      twice |= !given.emplace(place.name, entry->name).second;
      setOffset(*entry, parameters->second, *place.settings);
      taken = true;
    }
    if (twice) refusal = fmt::format("'{}': this offset is given twice", shortened(offset));
    if ((!taken || twice) && !refusal.empty()) diagnostics.add(usageError("--offset: " + refusal));
  }
}

}  // namespace proveout
