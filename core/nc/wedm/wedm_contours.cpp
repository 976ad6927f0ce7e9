#include "core/nc/wedm/wedm_contours.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/services/contour/contour_shift.h"

namespace proveout::nc {

namespace {

/// What went wrong, for people: a row a kind, in the order of the kinds.
struct WedmFailureText {
  const char* code;
  const char* message;
};
constexpr WedmFailureText kOffsetTexts[] = {
    {"wedm-5.6.2-startup", "an offset starts on a line, not on an arc: give a G01 lead-in with G41 or G42"},
    {"wedm-5.6.4-cancel", "an offset ends on a line, not on an arc: give a G01 with G40"},
    {"wedm-5.6.5-change", "the side changes on a line, not on an arc: put a G01 behind the change"},
    {"wedm-5.6.7-overcut", "overcut: the offset is larger than the radius of this inner arc"},
    {"wedm-5.6.7-overcut", "overcut: the offset paths of this element and the next do not meet"},
    {"wedm-5.6.7-overcut", "overcut: the offset leaves nothing of this element"},
    {"wedm-5.6.7-overcut", "overcut: with this offset the wire cuts into another part of the contour"},
};
constexpr WedmFailureText kTaperTexts[] = {
    {"wedm-7.2-start", "a taper starts on a line, not on an arc"},
    {"wedm-7.2-start", "a taper ends on a line, not on an arc"},
    {"wedm-7.5-error", "arc-arc or line-arc processing error: the taper cannot change here"},
    {"wedm-5.6.7-overcut", "overcut: the taper is larger than the radius of this arc in the secondary plane"},
    {"wedm-5.6.7-overcut", "overcut: this element and the next do not meet in the secondary plane"},
    {"wedm-5.6.7-overcut", "overcut: the taper leaves nothing of this element in the secondary plane"},
    {"wedm-7.3-joins", "the corner of the secondary plane is more than 10 leans away: round it with R"},
    {"wedm-7.4-RR", "the rounded corner does not fit the elements of the secondary plane"},
};

/// Elements of one plane with the record that they belong to.
struct PlanePieces {
  std::vector<OffsetPiece> pieces;
  std::vector<std::size_t> record;
};

class PairedContours {
 public:
  PairedContours(const std::vector<WedmRecord>& records, const WedmParameters& parameters)
      : records_(records), parameters_(parameters), limit_(records.size()) {}

  WedmContours run() {
    const PlanePieces main = mainPieces(), second = secondPieces();
    out_.tracks.resize(records_.size());
    fill(main, false);
    fill(second, true);
    out_.tracks.resize(std::min(limit_, out_.tracks.size()));
    return std::move(out_);
  }

 private:
  void fail(std::size_t record, const WedmFailureText& text, const std::string& more = {}) {
    if (out_.failure && record >= out_.failure->record) return;
    out_.failure = WedmFailure{record, text.code, text.message + more};
    limit_ = std::min(limit_, record);
  }

  OffsetPiece pieceOf(const WedmRecord& record, const ContourElement& element, bool corner) const {
    OffsetPiece piece;
    piece.element = element;
    piece.offset = record.offset;
    piece.outer = record.outer;
    if (!corner) {
      piece.starts = record.starts_offset && record.offset != 0.0;
      piece.extension = record.extension;
      piece.overcut = record.overcut;
    }
    return piece;
  }

  PlanePieces mainPieces() {
    PlanePieces out;
    ContourElement next = records_.empty() ? ContourElement{} : records_.front().main;
    for (std::size_t k = 0; k < records_.size(); ++k) {
      ContourElement element = next;
      if (k + 1 < records_.size()) next = records_[k + 1].main;
      std::optional<ContourElement> round;
      if (records_[k].round > 0.0 && k + 1 < records_.size()) round = roundedBy(k, element, next);
      out.pieces.push_back(pieceOf(records_[k], element, false));
      out.record.push_back(k);
      if (!round) continue;
      out.pieces.push_back(pieceOf(records_[k], *round, true));
      out.record.push_back(k);
    }
    return out;
  }

  std::optional<ContourElement> roundedBy(std::size_t k, ContourElement& a, ContourElement& b) {
    static constexpr WedmFailureText kRound{"wedm-14-R",
                                            "the corner radius R does not fit this element and the next"};
    std::optional<ContourElement> arc;
    if (roundBetween(a, b, records_[k].round, arc) != CornerError::kNone) fail(k, kRound);
    return arc;
  }

  PlanePieces secondPieces() {
    std::vector<TaperPiece> taper;
    for (const WedmRecord& record : records_) {
      TaperPiece piece;
      piece.element = record.second;
      piece.on = record.taper_on;
      piece.lean = record.lean;
      piece.rounded = record.round > 0.0 || record.round_2.value_or(0.0) > 0.0;
      piece.round = record.round;
      piece.round_2 = record.round_2;
      taper.push_back(piece);
    }
    const TaperedContour contour = taperContour(taper, {parameters_.tangent, parameters_.taper_arcs});
    out_.tilts = contour.tilts_in_place;
    if (contour.failure) {
      fail(contour.failure->piece, kTaperTexts[static_cast<std::size_t>(contour.failure->kind)]);
      // The end of the element in front is not known.
      limit_ = limit_ > 0 ? limit_ - 1 : 0;
    }
    PlanePieces out;
    for (const TaperedElement& e : contour.elements) {
      const OffsetPiece piece = pieceOf(records_[e.piece], e.element, e.corner);
      if (e.transition && !shiftedAtAll(piece)) continue;
      out.pieces.push_back(piece);
      out.record.push_back(e.piece);
    }
    return out;
  }

  /// A transition arc that the offset leaves nothing of makes way for the intersection of its neighbours.
  static bool shiftedAtAll(const OffsetPiece& piece) {
    const auto curve = shiftedCurve(piece.element, piece.offset);
    return curve && curve->radius > 1e-9;
  }

  void fill(const PlanePieces& plane, bool second) {
    const OffsetContour contour = offsetContour(plane.pieces, parameters_.tangent);
    if (contour.failure) {
      const OffsetFailure& failure = *contour.failure;
      fail(plane.record[failure.piece], kOffsetTexts[static_cast<std::size_t>(failure.kind)],
           fmt::format(" (near X{:.3f} Y{:.3f}{})", failure.where.x(), failure.where.y(),
                       second ? ", secondary plane" : ""));
    }
    // Where the next element is at fault the end of the one in front of it is not known.
    if (contour.tracks.size() < plane.pieces.size())
      limit_ = std::min(limit_, plane.record[contour.tracks.size()]);
    std::size_t last = records_.size();
    for (std::size_t k = 0; k < contour.tracks.size(); ++k) {
      const OffsetTrack& track = contour.tracks[k];
      const std::size_t record = plane.record[k];
      WedmTracks& tracks = out_.tracks[record];
      auto& behind = second ? tracks.second_behind : tracks.main_behind;
      if (record == last) {
        behind.push_back(track.track);
      } else {
        (second ? tracks.second : tracks.main) = track.track;
        tracks.slanted = tracks.slanted || track.slanted;
      }
      tracks.spikes = std::max(tracks.spikes, track.spike.size());
      behind.insert(behind.end(), track.spike.begin(), track.spike.end());
      behind.insert(behind.end(), track.join.begin(), track.join.end());
      last = record;
    }
  }

  const std::vector<WedmRecord>& records_;
  const WedmParameters& parameters_;
  std::size_t limit_;
  WedmContours out_;
};

}  // namespace

WedmContours wedmContours(const std::vector<WedmRecord>& records, const WedmParameters& parameters) {
  return PairedContours(records, parameters).run();
}

}  // namespace proveout::nc
