// Where the words that made a motion were written. A virtual control tells it while it runs, so that a
// finding can name the block with the wrong word and not only the block that moved.
//
// A motion's SourceRef::origins is the index of an OriginSet: an OriginCode for each kind of word. Most codes
// only count lines, so that a hundred thousand blocks share a few sets. core/path/origin_query.h turns codes
// into places, texts and values.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "core/geometry/types.h"

namespace proveout {

/// What a word in force is for. Words that end a mode (G40, G49, G69) are the word in force as well; G80 and
/// a G code of group 1 end a cycle and all of its words.
enum class OriginKind : std::uint8_t {
  // The coordinate that the motion ends at, whichever word named it: in a cycle Z is the word of the level.
  kX,
  kY,
  kZ,
  kA,
  kB,
  kC,
  kU,
  kV,
  kW,
  kOtherAxis,  ///< an axis with a name of several characters, the last one written
  // Words of the block itself.
  kI,
  kJ,
  kK,
  kArcRadius,  ///< R of an arc
  kAngle,      ///< ,A
  kCorner,     ///< ,C ,R or the B of WL4
  // Cycles.
  kCycle,        ///< G73 to G89; WL4: G31, G70 to G78 too
  kCycleDepth,   ///< level of the bottom; WL4: #3 of G81 to G89, and the stock U, W, C of G76
  kCyclePlane,   ///< R; WL4: #2
  kCycleStep,    ///< Q; WL4: #5, and the depth of cut E
  kCycleShift,   ///< I, J, K
  kCycleReturn,  ///< G98, G99
  kAllowance,    ///< WL4: R, I, K of G76 to G78
  kContour,      ///< WL4: the block of the contour that a pass of G76 to G78 follows or ends at
  // Tools.
  kTool,          ///< the T whose tool is in the spindle
  kNextTool,      ///< the last T
  kLengthOffset,  ///< H
  kLengthCode,    ///< G43, G44, G49
  kRadiusOffset,  ///< D
  kCompensation,  ///< G40, G41, G42
  // Coordinates.
  kWorkOffset,    ///< G54 to G59, G54.1; WL4: G53 and G92 too
  kShift,         ///< G52, G92
  kUnits,         ///< G20, G21
  kDistance,      ///< G90, G91
  kPlane,         ///< G17, G18, G19
  kMirror,        ///< G51.1, G50.1; WL4: G51, G50
  kScaling,       ///< G51, G50
  kRotation,      ///< G68, G69
  kPolar,         ///< G16, G15
  kVirtualPlane,  ///< G12.1, G13.1, G7.1
  kDiameter,      ///< G10.9
  // How it moves.
  kMotionCode,        ///< G0, G1, G2, G3, G33 ...
  kFeed,              ///< F
  kFeedMode,          ///< G94, G95
  kThreadLead,        ///< F or E of a thread
  kSpindle,           ///< S
  kSpindleMode,       ///< G96, G97
  kSpindleDirection,  ///< M3, M4, M5, M19
  // Never in a set: what words were computed from.
  kVariable,  ///< assignment of a macro variable
  kArgument,  ///< argument of a macro call
  kData,      ///< a value of an offset table (G10, G37, G52, G92)
  kCall,      ///< the block that called the program in hand, as a whole; `from`: the call of its own program
};
/// Kinds that a set knows.
inline constexpr std::size_t kOriginKinds = static_cast<std::size_t>(OriginKind::kVariable);

/// "X", "depth of the cycle", "H".
std::string_view originKindName(OriginKind kind);
/// Is the word of that kind a coordinate, which may be incremental?
bool isCoordinate(OriginKind kind);
/// Is its value a length?
bool isLength(OriginKind kind);

/// Where one word was written, in 32 bits. Words that stand in the motion's own program (file and depth) as a
/// plain letter and number are found by their line; all others are in OriginTables::words.
class OriginCode {
 public:
  static constexpr std::uint32_t kMostLinesBack = 15;
  static constexpr std::uint32_t kMostLines = (1u << 24) - 1;
  /// How a word found by its line was read.
  class Reading {
   public:
    /// The word is not one of the kind itself: in a cycle Z may be the level of R, or of a step.
    enum class As : std::uint8_t { kItself, kCyclePlane, kCycleStep };
    constexpr Reading() = default;
    /// `incremental`: as a step (G91 and the like).
    constexpr Reading(bool incremental, bool inch, As as = As::kItself)
        : bits_(static_cast<std::uint8_t>((incremental ? kIncremental : 0) | (inch ? kInch : 0) |
                                          static_cast<int>(as))) {}
    constexpr bool incremental() const { return (bits_ & kIncremental) != 0; }
    constexpr bool inch() const { return (bits_ & kInch) != 0; }
    constexpr As as() const { return static_cast<As>(bits_ & kAs); }
    constexpr bool operator==(const Reading&) const = default;

   private:
    friend class OriginCode;
    static constexpr int kAs = 0xF, kInch = 0x10, kIncremental = 0x20;
    std::uint8_t bits_ = 0;
  };

  /// The program never said it: power-on state, or the job.
  constexpr OriginCode() = default;
  /// The word with index `number` - 1 of OriginTables::words.
  static constexpr OriginCode word(std::uint32_t number) { return OriginCode(number & kNumberBits); }
  /// On a line so many lines above the motion's; 0: on its own.
  static constexpr OriginCode linesBack(std::uint32_t lines, Reading reading) {
    return OriginCode(kBack | bitsOf(reading) | lines);
  }
  /// On that line, 1 to kMostLines.
  static constexpr OriginCode line(std::uint32_t number, Reading reading) {
    return OriginCode(kLine | bitsOf(reading) | number);
  }

  constexpr bool none() const { return bits_ == 0; }
  constexpr bool isWord() const { return bits_ >> 30 == 0 && bits_ != 0; }
  constexpr bool isLinesBack() const { return bits_ >> 30 == 1; }
  constexpr std::uint32_t number() const { return bits_ & kNumberBits; }  ///< of a word
  constexpr std::uint32_t lines() const { return bits_ & kMostLines; }    ///< lines back, or the line
  constexpr Reading reading() const {
    Reading reading;
    reading.bits_ = static_cast<std::uint8_t>(bits_ >> kReadingShift & 0x3Fu);
    return reading;
  }
  constexpr std::uint32_t bits() const { return bits_; }
  constexpr bool operator==(const OriginCode&) const = default;

 private:
  static constexpr std::uint32_t kBack = 1u << 30, kLine = 2u << 30, kNumberBits = (1u << 30) - 1;
  static constexpr unsigned kReadingShift = 24;
  static constexpr std::uint32_t bitsOf(Reading reading) {
    return static_cast<std::uint32_t>(reading.bits_) << kReadingShift;
  }
  constexpr explicit OriginCode(std::uint32_t bits) : bits_(bits) {}
  std::uint32_t bits_ = 0;
};
/// The kind whose address a word of `kind` is written with.
constexpr OriginKind writtenAs(OriginKind kind, OriginCode::Reading reading) {
  using As = OriginCode::Reading::As;
  return reading.as() == As::kCyclePlane  ? OriginKind::kCyclePlane
         : reading.as() == As::kCycleStep ? OriginKind::kCycleStep
                                          : kind;
}

/// A word of the program that took effect, or an assignment of a variable.
struct WordOrigin {
  std::uint32_t file = 0;            ///< index into Toolpath::files
  std::uint32_t line = 0;            ///< from 1
  std::uint16_t begin = 0, end = 0;  ///< columns from 1, end one past; 0: as the text of the line shows
  std::uint16_t depth = 0;           ///< as in SourceRef
  OriginKind kind = OriginKind::kVariable;
  bool incremental = false;  ///< a coordinate that counted from where the tool was
  bool inch = false;         ///< read in inches
  std::int64_t block = -1;   ///< N number of the block, or -1
  /// As the word says it, lengths in mm. NaN: as the text of the line shows, or, of computed words that took
  /// many values, not kept.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// What the expression read: numbers (index + 1) of the assignments and arguments behind its variables. No
  /// place comes twice on the way to the first of them: what a loop computes from its own last round is left
  /// out.
  std::vector<std::uint32_t> from;
};

/// A row of an offset table as a program used it. 0 in `..._by`: the value is the job's; else the number
/// (index + 1) of the word that set it (G10, G37, a system variable).
struct OffsetInForce {
  std::int32_t row = 0;               ///< 0: none
  double geometry = 0.0, wear = 0.0;  ///< mm; what counts is their sum
  std::uint32_t geometry_by = 0, wear_by = 0;
  double value() const { return geometry + wear; }
  bool operator==(const OffsetInForce&) const = default;
};

/// A vector of the tables, and which word set each component (0: the job).
struct VectorInForce {
  Vec3 value = Vec3::Zero();  ///< mm, or degrees
  std::array<std::uint32_t, 3> set_by{};
  bool operator==(const VectorInForce& other) const { return value == other.value && set_by == other.set_by; }
};

/// The rows of the tables that a motion was made with, as they were when the program called them.
struct DataInForce {
  std::int32_t tool = 0;              ///< number of the tool in the spindle; 0: none named
  OffsetInForce length;               ///< row of H
  OffsetInForce length_x, length_y;   ///< turning lengths of the same row (nct, G43.7)
  Vec3 length_offset = Vec3::Zero();  ///< what it adds to X, Y, Z of the machine, mm; 0 with G49
  OffsetInForce radius;               ///< row of D
  // What lathes keep of a tool.
  std::int32_t nose_tool = 0;       ///< number of the tool whose data these are: the one called last
  double nose_radius = 0.0;         ///< mm
  std::int32_t tip = 0;             ///< where the touch-off point lies, 0 to 9
  bool at_center = false;           ///< programs move the nose centre, not the touch-off point
  Vec3 tool_offset = Vec3::Zero();  ///< shift of the tool, X as a radius, mm
  std::int32_t work_system = 0;  ///< 1 to 6: G54 to G59; 101 to 199: G54.1 P1 to P99; 0: none (WL4: G53, G92)
  VectorInForce work_offset;     ///< of that system, machine frame
  VectorInForce work_rotation;   ///< its basic rotation about X, Y, Z, degrees
  VectorInForce common_offset;   ///< added to every work offset
  VectorInForce shift;           ///< sum of G52 and G92, work coordinates
  bool operator==(const DataInForce&) const = default;
};

/// The words in force besides X, Y, Z, which change seldom.
struct ModalOrigins {
  std::array<OriginCode, kOriginKinds - 3> code{};  ///< by kind, from kA on
  std::uint32_t data = 0;                           ///< index into OriginTables::data
  std::uint32_t call = 0;  ///< number (index + 1) of the word of the call; 0: in the main program
  bool operator==(const ModalOrigins&) const = default;
};

/// The words in force in a block.
struct OriginSet {
  std::uint32_t modal = 0;           ///< index into OriginTables::modal
  std::array<OriginCode, 3> axis{};  ///< X, Y, Z
  bool operator==(const OriginSet& other) const {
    using Bits = std::array<std::uint64_t, 2>;
    return std::bit_cast<Bits>(*this) == std::bit_cast<Bits>(other);
  }
};

/// What the origins of a path are made of.
struct OriginTables {
  std::vector<WordOrigin> words;
  std::vector<DataInForce> data;
  std::vector<ModalOrigins> modal;
  std::vector<OriginSet> sets;

  /// The code of a kind in set `index`; none where the index is -1.
  OriginCode code(std::int32_t index, OriginKind kind) const;
  /// Bytes that the tables take.
  std::size_t bytes() const;
};

}  // namespace proveout
