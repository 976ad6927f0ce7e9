// A call of a cycle of the FlexNC control, and the answer. Who calls reads blocks and keeps modal state; the
// cycles know neither (digest flexnc, 5 to 10 and 12). Everything lies in the half plane (z, r) of the work
// or local system: lengths mm, r a radius, z towards the tailstock.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/services/contour/contour_elements.h"
#include "core/nc/text/block.h"

namespace proveout::nc {

/// G codes that take arguments and make moves of their own: ten times the printed number, G12.3 is 123.
enum class CycleCode : int {
  kG3_1 = 31,    ///< part of a circle, shafts only
  kG5 = 50,      ///< deep drilling
  kG8_1 = 81,    ///< convex and concave radius, shafts only
  kG12 = 120,    ///< quarter of a circle
  kG12_1 = 121,  ///< convex radius and cone, .1 to .5
  kG12_2 = 122,
  kG12_3 = 123,
  kG12_5 = 125,
  kG13 = 130,    ///< quarter of a circle, the other way round
  kG13_1 = 131,  ///< concave radius and cone, .1 to .5
  kG13_2 = 132,
  kG13_5 = 135,
  kG22_1 = 221,  ///< convex radius, cone, convex radius
  kG22_2 = 222,
  kG22_3 = 223,
  kG23_1 = 231,  ///< convex radius, cone, concave radius
  kG23_2 = 232,
  kG23_3 = 233,
  kG23_4 = 234,
  kG30 = 300,  ///< worm of several starts
  kG76 = 760,  ///< thread: data and cut
  kG77 = 770,  ///< cone
  kG77_1 = 771,
  kG77_2 = 772,
  kG77_3 = 773,
  kG79 = 790,    ///< facing
  kG79_1 = 791,  ///< groove into a shaft
  kG79_2 = 792   ///< groove into a face
};

/// Letters with numbers behind the code.
class CycleArguments {
 public:
  /// `letter`: 'A' to 'Z'. False: it is there already, and keeps its first value.
  bool set(char letter, double value);
  bool has(char letter) const { return present_.has(letter); }
  std::optional<double> find(char letter) const {
    return has(letter) ? std::optional(values_[index(letter)]) : std::nullopt;
  }
  /// 0 of a letter that is not there.
  double value(char letter) const { return values_[index(letter)]; }
  AddressSet present() const { return present_; }

 private:
  static std::size_t index(char letter) { return static_cast<std::size_t>(letter - 'A'); }
  AddressSet present_;
  std::array<double, 26> values_{};
};

/// From where rotation words are seen (digest flexnc, 1.3): the X axis drawn downwards or upwards, Z to the
/// right.
enum class ArcView { kXDown, kXUp };

/// Contour blocks that hang together: K=1 begins a chain, K=0 goes on with it.
struct ContourChain {
  bool approached = false;  ///< a block G81.1 to G81.3 led to it: no return of its own
  double start_z = 0.0;     ///< plane of the start point, where it was not approached
};

/// What a first G76 block says of the thread that a second one cuts.
struct ThreadData {
  int spring_passes = 0;      ///< passes at the full depth
  double run_out = 0.0;       ///< leg of the run-out at 45 degrees, pitches
  double angle_deg = 0.0;     ///< of the tool; 0: radial infeed
  double second_depth = 0.0;  ///< infeed of the second pass, mm
};

struct CycleCall {
  CycleCode code = CycleCode::kG12;
  CycleArguments arguments;
  ArcView arc_view = ArcView::kXDown;
  Vec2 at = Vec2::Zero();             ///< (z, r) of the tool before the call
  bool approached = false;            ///< the motion before was that of G81.1 to G81.3: compensation is on
  std::optional<ContourChain> chain;  ///< of the contour block before; a K=0 block goes on with it
  std::optional<ThreadData> thread;   ///< of the G76 data block before
};

/// One move. Moves hang together: the first begins at CycleCall::at, each where the one before ends.
struct CycleMove {
  enum class Kind {
    kRapid,  ///< to the end as G00 goes there
    kFeed,   ///< line or arc at the feed in force
    kThread  ///< a line bound to the turns of the spindle
  } kind = Kind::kFeed;
  ContourElement element;  ///< in (z, r): sweep > 0 turns from +z to +r
  double lead = 0.0;       ///< kThread: mm of Z a turn, > 0 (of a move that keeps Z: of X)
  double turn = 0.0;       ///< kThread: where the spindle stands at its start, 0 to 1 of a turn
  /// What the move is for; a finding names it behind the block.
  enum class Role {
    kApproach,  ///< to the start point
    kInfeed,
    kPass,     ///< cuts, in the manner of the cycle
    kRetract,  ///< off the work, and back for the next pass
    kContour,  ///< along the finished profile
    kReturn    ///< to the point where the cycle ends
  } role = Role::kPass;
  int pass = 0;  ///< number of the pass that it belongs to, from 1; 0: of none
};

/// Why a call is refused, or what is odd with it. `id`: of the digest's chapter 12, "fnc-tangent".
struct CycleNote {
  std::string_view id;
  std::string text;  ///< a sentence: what is wrong, and what to do
};

struct CycleAnswer {
  std::optional<CycleNote> alarm;  ///< the call is refused: nothing else counts
  std::vector<CycleNote> warnings;
  std::vector<CycleMove> moves;
  int passes = 0;  ///< the highest CycleMove::pass
  /// Contour blocks: what a K=0 block behind it is to be told, and the moves that are due where none stands
  /// behind it, before anything else moves. They begin where `moves` end.
  std::optional<ContourChain> chain;
  std::vector<CycleMove> chain_return;
  std::optional<ThreadData> thread;  ///< of a G76 data block, for the cut block behind it
};

/// The code of a G number; nothing where it is none of a cycle.
std::optional<CycleCode> cycleCode(double number);
/// "G12.3".
std::string cycleName(CycleCode code);
/// Letters that the code knows, in whichever of its forms: they are arguments, not words of the block.
AddressSet cycleAddresses(CycleCode code);
/// Is it one with roughing and contour blocks (chapters 3.2 to 3.5 of the manual)?
bool isTemplate(CycleCode code);
/// Carries out the call. Never fails otherwise than by CycleAnswer::alarm, whatever the numbers are.
CycleAnswer performCycle(const CycleCall& call);

}  // namespace proveout::nc
