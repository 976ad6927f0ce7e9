#include "core/nc/control/machine_event.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/nc/control/control_settings.h"

namespace proveout {
namespace {

using Where = EventFault::Where;

struct KnownAxis {
  std::string name;
  AxisKind kind = AxisKind::kLinear;
  bool carries = true;  ///< moves tool or part
};

std::vector<KnownAxis> knownAxes(const ControlSettings& settings) {
  std::vector<KnownAxis> axes{{"X"}, {"Y"}, {"Z"}};
  for (const AxisSettings& given : settings.axes) {
    if (given.name == "X" || given.name == "Y" || given.name == "Z") continue;
    KnownAxis axis{
        given.name, given.kind,
        given.kind == AxisKind::kLinear ? !given.parallel.empty() : given.carries != RotaryCarries::kNothing};
    const int k = settings.machine ? settings.machine->find(given.name) : -1;
    if (k >= 0) axis.carries = settings.machine->axes[static_cast<std::size_t>(k)].side != AxisSide::kNothing;
    axes.push_back(axis);
  }
  return axes;
}

class EventChecker {
 public:
  explicit EventChecker(const ControlSettings& settings) : settings_(settings), axes_(knownAxes(settings)) {}

  std::vector<EventFault> run() {
    checkDrives(Where::kGantry, settings_.gantry);
    checkDrives(Where::kTandem, settings_.tandem);
    where_ = Where::kEvent;
    for (index_ = 0; index_ < settings_.events.size(); ++index_) {
      const MachineEvent& event = settings_.events[index_];
      checkCode(event);
      checkCouple(event);
      checkNames("park", event.park);
      checkExchange(event);
      checkNames("reverse", event.reverse);
      checkHead(event);
      checkRelease(event);
    }
    return std::move(faults_);
  }

 private:
  void add(const char* key, std::string text) { faults_.push_back({where_, index_, key, std::move(text)}); }

  const KnownAxis* find(const std::string& name) const {
    const auto found =
        std::find_if(axes_.begin(), axes_.end(), [&](const KnownAxis& axis) { return axis.name == name; });
    return found == axes_.end() ? nullptr : &*found;
  }

  /// Whether an event may name the axis; adds a fault where not.
  bool known(const char* key, const std::string& name) {
    if (find(name) == nullptr) {
      std::vector<std::string> names;
      for (const KnownAxis& axis : axes_) names.push_back(axis.name);
      add(key, fmt::format("there is no axis '{}': the machine has {}", name, fmt::join(names, ", ")));
      return false;
    }
    if (where_ != Where::kEvent || !driven_.contains(name)) return true;
    add(key,
        fmt::format("axis {} is the second drive of another one (gantry or tandem): name its master", name));
    return false;
  }

  /// Two axes of one kind that are not the same.
  bool checkPair(const char* key, const AxisPair& pair) {
    if (!known(key, pair.first) || !known(key, pair.second)) return false;
    if (pair.first == pair.second) {
      add(key, fmt::format("axis {} is paired with itself: name two axes", pair.first));
      return false;
    }
    if (find(pair.first)->kind == find(pair.second)->kind) return true;
    add(key, fmt::format("{} and {} are a linear and a rotary axis: name two of one kind", pair.first,
                         pair.second));
    return false;
  }

  /// Whether the pairs give a slave two masters, or lead round in a circle.
  void checkMasters(const char* key, const std::vector<AxisPair>& pairs) {
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto same = [&](const AxisPair& other) { return other.second == pairs[k].second; };
      if (std::any_of(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(k), same))
        add(key, fmt::format("axis {} has two masters: name it once as a slave", pairs[k].second));
      std::string at = pairs[k].first;
      for (std::size_t step = 0; step < pairs.size() && at != pairs[k].second; ++step) {
        const auto up =
            std::find_if(pairs.begin(), pairs.end(), [&](const AxisPair& p) { return p.second == at; });
        if (up != pairs.end()) at = up->first;
      }
      if (at != pairs[k].second || pairs[k].first == pairs[k].second) continue;
      return add(key, fmt::format("axis {} follows itself in the end: leave one pair out", at));
    }
  }

  void checkNames(const char* key, const std::vector<std::string>& names) {
    std::set<std::string> seen;
    for (const std::string& name : names) {
      if (known(key, name) && !seen.insert(name).second)
        add(key, fmt::format("axis {} stands there twice: name it once", name));
    }
  }

  void checkCode(const MachineEvent& event) {
    for (std::size_t k = 0; k < index_; ++k) {
      if (settings_.events[k].code == event.code && event.code > 0)
        add("code", fmt::format("M{} is the code of event {} already: put what it does into one event",
                                event.code, k + 1));
    }
    for (const SpindleSettings& spindle : settings_.spindles) {
      for (const int code : {spindle.main_code, spindle.sync_code, spindle.shift_code, spindle.axis_code}) {
        if (code > 0 && code == event.code)
          add("code", fmt::format("M{} is a code of spindle {} already: an event needs a code of its own",
                                  code, spindle.number));
      }
    }
    const bool any = !event.release.empty() || !event.couple.empty() || !event.park.empty() ||
                     event.exchange || !event.reverse.empty() || event.head;
    if (!any)
      add("code",
          fmt::format("M{} does nothing: give couple, park, exchange, reverse, head or release", event.code));
  }

  void checkCouple(const MachineEvent& event) {
    bool good = true;
    for (const AxisPair& pair : event.couple) good = checkPair("couple", pair) && good;
    if (good) checkMasters("couple", event.couple);
    std::set<std::string> seen;
    for (const std::string& name : event.opposite) {
      const auto is = [&](const AxisPair& pair) { return pair.second == name; };
      if (std::none_of(event.couple.begin(), event.couple.end(), is)) {
        add("opposite", fmt::format("axis {} is no slave of this event: name slaves of couple", name));
      } else if (!seen.insert(name).second) {
        add("opposite", fmt::format("axis {} stands there twice: name it once", name));
      }
    }
  }

  void checkExchange(const MachineEvent& event) {
    if (event.exchange) checkPair("exchange", *event.exchange);
  }

  void checkHead(const MachineEvent& event) {
    if (event.head && (event.exchange || !event.reverse.empty()))
      add("head", "head exchanges and reverses the axes itself: leave exchange and reverse out");
    if (event.gauge && event.head != HeadPosition::kHorizontal)
      add("gauge", "gauge is that of the horizontal head: give it with head = \"horizontal\"");
  }

  void checkRelease(const MachineEvent& event) {
    const auto on = [](const MachineEvent& other, AxisMode mode) {
      switch (mode) {
        case AxisMode::kCouple:
          return !other.couple.empty();
        case AxisMode::kPark:
          return !other.park.empty();
        case AxisMode::kExchange:
          return other.exchange.has_value();
        case AxisMode::kReverse:
          return !other.reverse.empty();
        case AxisMode::kHead:
          return other.head == HeadPosition::kHorizontal;
      }
      return false;
    };
    const auto somewhere = [&](AxisMode mode) {
      return std::any_of(settings_.events.begin(), settings_.events.end(),
                         [&](const MachineEvent& other) { return on(other, mode); });
    };
    if (event.release.empty() || std::any_of(event.release.begin(), event.release.end(), somewhere)) return;
    add("release", "no event switches on what this one releases: add that event, or leave release out");
  }

  void checkDrives(Where where, const std::vector<AxisPair>& pairs) {
    where_ = where;
    const char* key = where == Where::kGantry ? "gantry" : "tandem";
    for (index_ = 0; index_ < pairs.size(); ++index_) {
      const AxisPair& pair = pairs[index_];
      if (!checkPair(key, pair)) continue;
      if (driven_.contains(pair.first)) {
        add(key, fmt::format("axis {} is a second drive itself: name its master", pair.first));
      } else if (!driven_.insert(pair.second).second) {
        add(key, fmt::format("axis {} has two masters: name it once as a slave", pair.second));
      } else if (pair.second == "X" || pair.second == "Y" || pair.second == "Z") {
        add(key, fmt::format("programs move axis {}: the slave is an axis of its own", pair.second));
      } else if (find(pair.second)->carries) {
        add(key,
            fmt::format("axis {} is a drive of {} alone: it must carry nothing", pair.second, pair.first));
      }
    }
  }

  const ControlSettings& settings_;
  const std::vector<KnownAxis> axes_;
  std::set<std::string> driven_;  ///< slaves of gantries and tandems
  Where where_ = Where::kEvent;
  std::size_t index_ = 0;
  std::vector<EventFault> faults_;
};

}  // namespace

std::vector<EventFault> eventFaults(const ControlSettings& settings) { return EventChecker(settings).run(); }

std::string_view axisModeName(AxisMode mode) {
  switch (mode) {
    case AxisMode::kCouple:
      return "couple";
    case AxisMode::kPark:
      return "park";
    case AxisMode::kExchange:
      return "exchange";
    case AxisMode::kReverse:
      return "reverse";
    case AxisMode::kHead:
      return "head";
  }
  return "";
}

}  // namespace proveout
