#include "core/nc/iso/model/m_index.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/nc/iso/model/code_names.h"

namespace proveout::nc {
namespace {

constexpr int kMostM = 99999999;

/// Whole numbers from `low` to `high`.
struct MRange {
  int first, last;
  MRange(double low, double high)
      : first(static_cast<int>(std::ceil(std::clamp(low, 0.0, kMostM + 1.0)))),
        last(static_cast<int>(std::floor(std::clamp(high, -1.0, static_cast<double>(kMostM))))) {}
};

/// Where the numbers that parameters give count from 1; 0 stands for none there.
template <class Visit>
void visitAbove0(double low, double high, const Visit& visit) {
  if (low > 0.0) visit(MRange(low, high));
}

/// `count` codes from `first` on; no codes with 0.
template <class Visit>
void visitCount(double first, double count, const Visit& visit) {
  if (count > 0.0) visitAbove0(first, std::ceil(first + count) - 1.0, visit);
}

template <class Visit>
void visitFunctions(const IsoParameters& p, const Visit& visit) {
  visitAbove0(p[ProgramParam::kWaitLow], p[ProgramParam::kWaitHigh],
              [&](MRange range) { visit(range, [](MFunction& f) { f.waits = true; }); });
  for (int k = 0; k < kMGroups; ++k) {  // the first group that has the code
    const auto group = static_cast<std::int8_t>(k + 1);
    visitAbove0(p[FunctionParam::kGroupLow1 + k], p[FunctionParam::kGroupHigh1 + k], [&](MRange range) {
      visit(range, [group](MFunction& f) { f.group = f.group > 0 ? f.group : group; });
    });
  }
  const auto ends = [&](MRange range) { visit(range, [](MFunction& f) { f.ends_look_ahead = true; }); };
  for (int k = 0; k < kBufferCodes; ++k) {
    const double code = p[ProgramParam::kBufferCode1 + k];
    visitAbove0(code, code, ends);
  }
  for (int k = 0; k < kBufferGroups; ++k)
    visitAbove0(p[ProgramParam::kBufferLow1 + k], p[ProgramParam::kBufferHigh1 + k], ends);
  const double place = std::floor(p[ToolParam::kPlaceCode]);
  visitAbove0(place, place, [&](MRange range) { visit(range, [](MFunction& f) { f.of_place = true; }); });
}

template <class Visit>
void visitInterrupts(const IsoParameters& p, const Visit& visit) {
  if (!p.flag(MacroParam::kInterrupts)) return;
  const bool own = p.flag(MacroParam::kInterruptOwnCodes);
  const double on = own ? std::floor(p[MacroParam::kInterruptOn]) : mcode::kInterruptOn;
  const double off = own ? std::floor(p[MacroParam::kInterruptOff]) : mcode::kInterruptOff;
  visit(MRange(off, off), [](MFunction& f) { f.interrupt = InterruptSwitch::kOff; });
  visit(MRange(on, on), [](MFunction& f) { f.interrupt = InterruptSwitch::kOn; });  // of the same code
}

/// The codes of the settings for one spindle.
template <class Visit>
void visitSettings(const SpindleSettings& spindle, std::size_t index, const Visit& visit) {
  struct Named {
    int code;
    std::int8_t MFunction::*place;
  };
  for (const auto& [code, place] : {Named{spindle.main_code, &MFunction::main},
                                    {spindle.sync_code, &MFunction::sync},
                                    {spindle.shift_code, &MFunction::shift},
                                    {spindle.axis_code, &MFunction::axis},
                                    {spindle.speed_code, &MFunction::speed},
                                    {spindle.cw_code, &MFunction::cw},
                                    {spindle.ccw_code, &MFunction::ccw},
                                    {spindle.stop_code, &MFunction::stop}}) {
    visitAbove0(code, code, [&, at = place](MRange range) {
      visit(range, [&](MFunction& f) {
        if (f.*at < 0) f.*at = static_cast<std::int8_t>(index);
      });
    });
  }
}

template <class Visit>
void visitSpindles(const IsoParameters& p, const std::vector<SpindleSettings>& spindles, const Visit& visit) {
  const double low = p[SpindleParam::kOptionalLow], high = p[SpindleParam::kOptionalHigh];
  visitCount(low, high - low + 1,
             [&](MRange range) { visit(range, [](MFunction& f) { f.of_spindles = true; }); });
  for (std::size_t k = 0; k < std::max<std::size_t>(1, spindles.size()); ++k) {
    const int number = spindles.empty() ? 1 : spindles[k].number;
    const double loop = std::floor(p.value(SpindleParam::kLoopCode, number));
    visitAbove0(loop, loop, [&](MRange range) { visit(range, [&](MFunction& f) { f.closes_loop.set(k); }); });
    visitCount(p.value(SpindleParam::kIndexFirst, number), p.value(SpindleParam::kIndexCount, number),
               [&](MRange range) { visit(range, [&](MFunction& f) { f.indexes.set(k); }); });
    if (!spindles.empty()) visitSettings(spindles[k], k, visit);
  }
}

/// All ranges of codes that mean something, with what they mean: visit(MRange, void(MFunction&)).
template <class Visit>
void visitAll(const CodeIndex& codes, const ControlSettings& settings, const IsoParameters& parameters,
              const Visit& visit) {
  for (const MCode* own : codes.allM())
    visit(MRange(own->code, own->code), [own](MFunction& f) { f.own = own; });
  visitFunctions(parameters, visit);
  visitInterrupts(parameters, visit);
  visitSpindles(parameters, settings.spindles, visit);
  for (const MachineEvent& event : settings.events)
    visitAbove0(event.code, event.code, [&](MRange range) {
      visit(range, [&event](MFunction& f) {
        f.event = &event;
        f.ends_look_ahead = true;
      });
    });
}

}  // namespace

void MIndex::rebuild(const IsoParameters& parameters) {
  revision_ = parameters.revision();
  std::vector<int> firsts{0};
  visitAll(codes_, settings_, parameters, [&](MRange range, const auto&) {
    if (range.first > range.last) return;
    firsts.push_back(range.first);
    firsts.push_back(range.last + 1);
  });
  std::sort(firsts.begin(), firsts.end());
  firsts.erase(std::unique(firsts.begin(), firsts.end()), firsts.end());
  PROVEOUT_ASSERT(firsts.front() == 0);  // every number has a row
  rows_.assign(firsts.size(), MFunction());
  for (std::size_t k = 0; k < firsts.size(); ++k) rows_[k].first = firsts[k];
  visitAll(codes_, settings_, parameters, [&](MRange range, const auto& mark) {
    const auto begin = std::lower_bound(rows_.begin(), rows_.end(), range.first,
                                        [](const MFunction& row, int number) { return row.first < number; });
    for (auto row = begin; row != rows_.end() && row->first <= range.last; ++row) mark(*row);
  });
}

const MFunction& MIndex::find(int m) const {
  static const MFunction kNothing;
  if (m < 0) return kNothing;
  const auto behind = std::upper_bound(rows_.begin(), rows_.end(), m,
                                       [](int number, const MFunction& row) { return number < row.first; });
  return *std::prev(behind);
}

}  // namespace proveout::nc
