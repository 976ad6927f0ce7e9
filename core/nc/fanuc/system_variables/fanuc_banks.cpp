#include "core/nc/fanuc/system_variables/fanuc_banks.h"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/base/characters.h"
#include "core/nc/fanuc/model/setting_notes.h"
#include "core/nc/fanuc/parameters/fanuc_parameters.h"
#include "core/nc/fanuc/system_variables/common_bank.h"
#include "core/nc/fanuc/system_variables/offset_numbers.h"
#include "core/nc/fanuc/tools/kept_tables.h"
#include "core/nc/iso/context/context.h"
#include "core/nc/iso/system_variables/frame_bank.h"
#include "core/nc/iso/system_variables/message_bank.h"
#include "core/nc/iso/system_variables/modal_bank.h"
#include "core/nc/iso/system_variables/plc_bank.h"
#include "core/nc/iso/system_variables/position_bank.h"
#include "core/nc/iso/system_variables/status_bank.h"
#include "core/nc/iso/system_variables/tool_offset_bank.h"
#include "core/nc/iso/system_variables/units.h"

namespace proveout::nc {
namespace {

constexpr double kHourMs = 3'600'000.0;
constexpr int kFanucGroups = 30;
constexpr int kLastLowCommon = 199;
constexpr int kFanucSystems = 7, kOldAxes = 4;
constexpr int kExtendedLow48 = 48, kExtended300 = 300;

constexpr auto kMillFrames = std::to_array<FrameNumbers>({
    {5201, kFanucSystems, kLowAxes, kLowAxes, 1, 0},
    {7001, kExtendedLow48, kLowAxes, kLowAxes, 1, kFirstExtended},
    {14001, kExtended300, kLowAxes, kLowAxes, 1, kFirstExtended},
    {100301, kFanucSystems, kHighAxes, kHighAxes, 1, 0},
    {101001, kExtended300, kHighAxes, kHighAxes, 1, kFirstExtended},
    {2500, kFanucSystems, 1, kOldAxes, 100, 0},  // last: with V15 these are offsets of tools
});
/// #2500 and #14001 are offsets of tools there.
constexpr auto kLatheFrames = std::to_array<FrameNumbers>({
    {5201, kFanucSystems, kLowAxes, kLowAxes, 1, 0},
    {7001, kExtendedLow48, kLowAxes, kLowAxes, 1, kFirstExtended},
    {100301, kFanucSystems, kHighAxes, kHighAxes, 1, 0},
    {101001, kExtended300, kHighAxes, kHighAxes, 1, kFirstExtended},
});

double givenOr(const IsoContext& c, std::string_view name, double usual) {
  const auto found = c.settings.parameters.find(std::string(name));
  return found == c.settings.parameters.end() ? usual : found->second;
}

OffsetNumbering numberingOf(const IsoContext& c) {
  OffsetNumbering out;
  out.haas = givenOr(c, "flavour", 0.0) == 1.0;
  out.memory = static_cast<int>(givenOr(c, "offset_memory", 2.0));
  out.v15 = givenOr(c, "v15", out.haas ? 1.0 : 0.0) != 0.0;
  out.diameters = givenOr(c, "d_is", out.haas ? 1.0 : 0.0) != 0.0;
  return out;
}

/// The code of a group as programs write it: 17, 90, 54.1. That depends on the system of a lathe.
double plainCode(const IsoContext& c, const IsoState& s, int group) {
  constexpr double kTenfold = 10.0;
  if (group >= kGroupCount) return 0.0;
  const int code10 = s.active[static_cast<std::size_t>(group)];
  const GCode* const code = c.codes.inForce(code10);
  return (code == nullptr ? code10 : code->number10()) / kTenfold;
}

/// Mills of Haas have the work frames in group 12.
double haasCode(const IsoContext& c, const IsoState& s, int group) {
  return plainCode(c, s, group == kGroupMacro ? kGroupWorkSystem : group);
}

/// Groups of lathes: 2 is constant surface speed, 16 the plane.
double latheCode(const IsoContext& c, const IsoState& s, int group) {
  constexpr int kSurface = 2, kPlaneOfLathes = 16, kZones = 9, kCycles = 10;
  constexpr double kFromFaceToSide = 4.0;  // G83 along Z is G87 along X
  const int shared = group == kSurface         ? kGroupSurfaceSpeed
                     : group == kPlaneOfLathes ? kGroupPlane
                     : group == kZones         ? kGroupZones
                     : group == kCycles        ? kGroupCycle
                                               : group;
  if (shared != kGroupCycle) return plainCode(c, s, shared);
  const bool side = s.inCycle() && s.cycle.drill_axis == 0;
  return s.active[kGroupCycle] / 10.0 + (side ? kFromFaceToSide : 0.0);
}

/// System A has no G90 and G91.
double latheCodeOfA(const IsoContext& c, const IsoState& s, int group) {
  return group == kGroupDistance ? 0.0 : latheCode(c, s, group);
}

/// The number behind the O or : that stands in front of the program; 0: none.
int headNumber(const SourceText& text) {
  constexpr std::size_t kFarthest = 100;
  constexpr int kMost = 99'999'999;
  const auto& lines = text.lines();
  for (std::size_t k = text.firstLine(); k < std::min(lines.size(), text.firstLine() + kFarthest); ++k) {
    std::size_t i = lines[k].find_first_not_of(" \t%");
    if (i == std::string_view::npos || (upper(lines[k][i]) != 'O' && lines[k][i] != ':')) continue;
    int number = 0;
    for (++i; i < lines[k].size() && isDigit(lines[k][i]) && number <= kMost / 10; ++i)
      number = 10 * number + (lines[k][i] - '0');
    if (number > 0) return number;
  }
  return programNumber(text.name());
}

/// Numbers that no other bank has: errors, or vacant where `unknown_variables` says so.
class UnknownBank : public VariableBank {
 public:
  explicit UnknownBank(IsoContext& context) : c_(context) {}
  VariableStatus read(int number, Value& out) override {
    if (!takes(number)) return VariableStatus::kUnknown;
    const auto found = values_.find(number);
    out = found == values_.end() ? Value::none() : found->second;
    return VariableStatus::kDone;
  }
  VariableStatus write(int number, const Value& value) override {
    if (!takes(number)) return VariableStatus::kUnknown;
    values_[number] = value;
    return VariableStatus::kDone;
  }

 private:
  bool takes(int number) {
    if (!c_.parameters.flag(FanucParam::kUnknownVariables) || number < 0) return false;
    if (c_.firstTime(fmt::format("unknown #{}", number))) {
      c_.warn("unknown-variable",
              fmt::format(
                  "#{} is not known here: it is vacant until it is written (unknown_variables = \"null\")",
                  number),
              {}, Severity::kNote);
    }
    return true;
  }
  IsoContext& c_;
  std::unordered_map<int, Value> values_;
};

/// Of mills: which number is which cell depends on settings, which is told once.
class MillOffsets final : public ToolOffsetBank {
 public:
  MillOffsets(IsoContext& context, std::vector<OffsetNumbers> numbers)
      : ToolOffsetBank(context, std::move(numbers)), c_(context) {}
  VariableStatus read(int number, Value& out) override {
    tell(number);
    return ToolOffsetBank::read(number, out);
  }
  VariableStatus write(int number, const Value& value) override {
    tell(number);
    return ToolOffsetBank::write(number, value);
  }

 private:
  void tell(int number) {
    if (told_) return;
    told_ = true;
    noteSetting(
        c_, FanucParam::kV15,
        fmt::format("#{} is a cell of the offset table, and geometry and wear change places with it (as "
                    "does what offset_memory says)",
                    number));
  }
  IsoContext& c_;
  bool told_ = false;
};

class FanucBanks final : public SystemVariables {
 public:
  FanucBanks(IsoContext& context, std::unique_ptr<ToolOffsetBank> offsets,
             std::span<const FrameNumbers> frames, double (*code)(const IsoContext&, const IsoState&, int))
      : modal_(context, {code, kFanucGroups, headNumber, true}),
        frames_(context, {frames, false}),
        offsets_(std::move(offsets)),
        positions_(context, {true, false}),
        plc_(context.host.person),
        status_(context, {kHourMs, false, true}),
        messages_(context, false),
        unknown_(context),
        tables_(context) {
    VariableStore& store = context.variables;
    store.endLowGlobals(kLastLowCommon);
    modal_.addTo(store);
    frames_.addTo(store);
    offsets_->addTo(store);
    positions_.addTo(store);
    plc_.addTo(store);
    status_.addTo(store);
    messages_.addTo(store);
    common_.addTo(store);
    store.setFallback(unknown_);
    for (const auto& [number, value] : context.host.person.kept.variables) store.write(number, {value});
  }
  void keep(IsoContext& c) override {
    for (int number = VariableStore::kFirstKept; number <= VariableStore::kLastGlobal; ++number) {
      Value value;
      if (c.variables.peek(number, value) && !value.vacant) c.summary.kept.variables[number] = value.number;
    }
    common_.addTo(c.summary.kept.variables);
    tables_.keep(c);
  }

 private:
  ModalBank modal_;
  FrameBank frames_;
  std::unique_ptr<ToolOffsetBank> offsets_;
  PositionBank positions_;
  PlcBank plc_;
  StatusBank status_;
  MessageBank messages_;
  CommonBank common_;
  UnknownBank unknown_;
  KeptTables tables_;
};

}  // namespace

std::unique_ptr<SystemVariables> fanucMillBanks(IsoContext& context) {
  const OffsetNumbering numbering = numberingOf(context);
  const std::span<const FrameNumbers> frames = kMillFrames;
  return std::make_unique<FanucBanks>(
      context, std::make_unique<MillOffsets>(context, millOffsetNumbers(numbering)),
      numbering.v15 ? frames.first(kMillFrames.size() - 1) : frames, numbering.haas ? haasCode : plainCode);
}

std::unique_ptr<SystemVariables> fanucLatheBanks(IsoContext& context) {
  return std::make_unique<FanucBanks>(
      context, std::make_unique<ToolOffsetBank>(context, latheOffsetNumbers(numberingOf(context))),
      kLatheFrames, givenOr(context, "gcode_system", 0.0) == 0.0 ? latheCodeOfA : latheCode);
}

}  // namespace proveout::nc
