#include "io/job/machine_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace proveout {
namespace {

using Type = ConfigValue::Type;

constexpr std::size_t kMostEvents = 100, kMostPairs = 20;
constexpr std::array kModes{AxisMode::kCouple, AxisMode::kPark, AxisMode::kExchange, AxisMode::kReverse,
                            AxisMode::kHead};

/// `["Y", "V"]`.
std::optional<AxisPair> readPair(const ConfigDocument& document, const ConfigValue& value,
                                 const std::string& key) {
  if (value.type != Type::kArray || value.items.size() != 2) {
    document.error(value.place, "job-type", key + " names axes in pairs: [\"Y\", \"V\"]");
    return std::nullopt;
  }
  const auto first = readText(document, value.items[0], key),
             second = readText(document, value.items[1], key);
  if (!first || !second) return std::nullopt;
  return AxisPair{*first, *second};
}

/// `[["Y", "V"], ["Z", "W"]]`.
std::vector<AxisPair> readPairs(ConfigTable& table, const std::string& key) {
  std::vector<AxisPair> pairs;
  if (table.find(key) == nullptr) return pairs;
  const std::vector<ConfigValue>* items = table.list(key, kMostPairs);
  if (items == nullptr) return pairs;
  for (const ConfigValue& item : *items) {
    if (const auto pair = readPair(table.document(), item, key)) pairs.push_back(*pair);
  }
  return pairs;
}

std::vector<std::string> readNames(ConfigTable& table, const std::string& key) {
  return table.find(key) == nullptr ? std::vector<std::string>()
                                    : table.texts(key).value_or(std::vector<std::string>());
}

/// `true`, or a list of what ends.
std::vector<AxisMode> readRelease(ConfigTable& table) {
  const ConfigValue* value = table.find("release");
  if (value == nullptr) return {};
  if (value->type == Type::kBoolean) {
    if (table.flag("release").value_or(false)) return {kModes.begin(), kModes.end()};
    table.error("release", "job-value", "release = false does nothing: leave it out");
    return {};
  }
  std::vector<AxisMode> modes;
  std::vector<std::string> known;
  for (const AxisMode mode : kModes) known.emplace_back(axisModeName(mode));
  for (const std::string& name : readNames(table, "release")) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      unknownChoice(table.document(), value->place, "release", name, known);
    } else {
      modes.push_back(kModes[static_cast<std::size_t>(found - known.begin())]);
    }
  }
  return modes;
}

MachineEvent readEvent(ConfigTable& table) {
  MachineEvent event;
  if (const auto code = table.must("code").integer("code", 1, 99999999)) event.code = static_cast<int>(*code);
  event.release = readRelease(table);
  event.couple = readPairs(table, "couple");
  event.opposite = readNames(table, "opposite");
  event.park = readNames(table, "park");
  if (const ConfigValue* pair = table.find("exchange"))
    event.exchange = readPair(table.document(), *pair, "exchange");
  event.reverse = readNames(table, "reverse");
  if (const auto head = table.choice("head", {"vertical", "horizontal"}))
    event.head = *head == "horizontal" ? HeadPosition::kHorizontal : HeadPosition::kVertical;
  if (table.find("gauge") != nullptr) event.gauge = table.point("gauge");
  table.refuseOthers();
  return event;
}

}  // namespace

void readMachineEvents(ConfigTable& machine, ControlSettings& settings) {
  const int errors = machine.document().diagnostics->errorCount();
  std::vector<ConfigTable> tables = machine.tables("event", kMostEvents);
  if (!tables.empty()) settings.events.clear();
  for (ConfigTable& table : tables) settings.events.push_back(readEvent(table));
  const bool gantry = machine.find("gantry") != nullptr, tandem = machine.find("tandem") != nullptr;
  if (gantry) settings.gantry = readPairs(machine, "gantry");
  if (tandem) settings.tandem = readPairs(machine, "tandem");
  if (machine.document().diagnostics->errorCount() != errors) return;
  for (const EventFault& fault : eventFaults(settings)) {
    const bool of_event = fault.where == EventFault::Where::kEvent;
    // What the machine's file has said is looked at again by the control, with the axes as they are then.
    if (of_event && !tables.empty()) tables[fault.index].error(fault.key, "job-value", fault.text);
    if (!of_event && (gantry || tandem)) machine.error(fault.key, "job-value", fault.text);
  }
}

}  // namespace proveout
