#include "core/nc/wedm/wedm_chain.h"

#include <fmt/core.h>

#include <utility>

#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/wedm/wedm_contours.h"

namespace proveout::nc {

namespace {

/// As of taper angles: beyond it somebody has slipped, or the heights of the planes are not those of the
/// workpiece.
constexpr double kMostTiltDeg = 45.0;

/// Sends the motions of a record and what stands behind it.
class RecordSender {
 public:
  RecordSender(WedmOutput& output, WedmReport& report, const WedmParameters& parameters)
      : output_(output), report_(report), parameters_(parameters) {}

  /// False: the wire would lean too far, reported.
  bool send(const WedmRecord& record, const WedmTracks& tracks) {
    WedmPace pace = record.pace;
    pace.compensated = record.offset != 0.0;
    if (!move(record, tracks.main, tracks.second, pace)) return false;
    pace.slow_end = false;
    Vec2 main = tracks.main.to, second = tracks.second.to;
    const std::size_t rows = std::max(tracks.main_behind.size(), tracks.second_behind.size());
    const bool dwells = record.overcut_dwell > 0.0 && record.overcut > 0.0 && tracks.spikes > 0;
    if (dwells) dwell(record);
    for (std::size_t k = 0; k < rows; ++k) {
      const ContourElement m = elementAt(tracks.main_behind, k, main);
      const ContourElement s = elementAt(tracks.second_behind, k, second);
      if (!move(record, m, s, pace)) return false;
      if (dwells && k == 0) dwell(record);
      main = m.to;
      second = s.to;
    }
    for (const WedmRecord::Event& e : record.events) output_.event(e.what, e.time_s, e.source);
    return true;
  }

 private:
  /// Where one plane has an element and the other none, the point of the other stands.
  static ContourElement elementAt(const std::vector<ContourElement>& row, std::size_t k,
                                  const Vec2& standing) {
    return k < row.size() ? row[k] : lineElement(standing, standing);
  }

  bool move(const WedmRecord& record, const ContourElement& main, const ContourElement& second,
            const WedmPace& pace) {
    const double tilt = radToDeg(output_.tilt(main, second));
    const bool named = parameters_.max_tilt_deg > 0.0;
    const double most = named ? parameters_.max_tilt_deg : kMostTiltDeg;
    if (tilt > most + 1e-9) {
      return report_.failAt(
          pace.source, record.columns, "wedm-tilt",
          fmt::format(
              "the wire would lean {:.3f} degrees: {} {:g} ({})", tilt,
              named ? "the machine's limit is" : "the limit is", most,
              named ? "MAX_TILT of the job" : "a machine that leans farther has MAX_TILT in [control.wedm]"));
    }
    output_.move(main, second, pace);
    return true;
  }

  void dwell(const WedmRecord& record) {
    output_.event(event::Dwell{record.overcut_dwell}, record.overcut_dwell, record.pace.source);
  }

  WedmOutput& output_;
  WedmReport& report_;
  const WedmParameters& parameters_;
};

}  // namespace

bool WedmChain::add(WedmRecord record) {
  record.starts_offset = record.offset_on && !offset_before_;
  offset_before_ = record.offset_on;
  const bool plain = record.plain();
  if (records_.size() >= kMostKept) {
    report_.fail(
        "wedm-long-contour",
        fmt::format("more than {} motions of one offset or tapered contour: cancel with G40 in between",
                    kMostKept));
    records_.clear();
    return false;
  }
  records_.push_back(std::move(record));
  return !plain || flush();
}

void WedmChain::event(EventKind what, double time_s, const SourceRef& source) {
  if (records_.empty()) {
    output_.event(std::move(what), time_s, source);
  } else {
    records_.back().events.push_back({std::move(what), time_s, source});
  }
}

void WedmChain::interruptOffset() {
  offset_before_ = false;
  if (records_.empty()) return;
  records_.back().offset = 0.0;
  records_.back().offset_on = records_.back().starts_offset = false;
}

bool WedmChain::flush() {
  if (records_.empty()) return true;
  const std::vector<WedmRecord> records = std::exchange(records_, {});
  const WedmContours contours = wedmContours(records, parameters_);
  for (const std::size_t k : contours.tilts) {
    report_.warnAt(
        records[k].pace.source, records[k].columns, "wedm-7.5-tilt",
        "the taper changes between collinear lines: the wire tilts on the spot at the end of this block");
  }
  RecordSender sender(output_, report_, parameters_);
  for (std::size_t k = 0; k < contours.tracks.size(); ++k) {
    const WedmRecord& record = records[k];
    if (contours.tracks[k].slanted && record.pace.rapid) {
      return report_.failAt(record.pace.source, record.columns, "wedm-5.6.2-rapid",
                            "an offset starts, ends or changes side on a G01, not on a G00");
    }
    if (!sender.send(record, contours.tracks[k])) return false;
  }
  if (!contours.failure) return true;
  const WedmRecord& bad = records[contours.failure->record];
  return report_.failAt(bad.pace.source, bad.columns, contours.failure->code, contours.failure->message);
}

}  // namespace proveout::nc
