// A job as geometry, before it is text: what the relations turn, shift and split.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace proveout::soak::second {

using Spot = Eigen::Vector3d;  ///< mm

enum class Control { kNct, kWl4Mill, kWl4Lathe, kFlexnc, kWedm };
inline bool turns(Control c) { return c == Control::kWl4Lathe || c == Control::kFlexnc; }
inline bool mills(Control c) { return c == Control::kNct || c == Control::kWl4Mill; }
const char* nameOf(Control control);

/// One thing that a program does. Lathes have radii in x.
struct Step {
  enum class Kind {
    kTool,   ///< `number` comes into the spindle
    kRapid,  ///< to `to`
    kLine,   ///< feed to `to`
    kArc,    ///< feed about `center`, level in Z; `to` where it begins: a whole turn. Another height: a helix
    kHole,   ///< drilling cycle `number` at `to`, from the height `level` on, `peck` deep each
    kWeave,  ///< `number` times: feed to `to`, to `center`, both `stride` farther each time; a macro loop
    kSide,   ///< compensation `number` (40, 41, 42)
    kLean,   ///< the wire leans by `angle` to the side of `number` (50, 51, 52)
    kCut,    ///< the wire is cut, and threaded again at `to`
    kWords   ///< `words` as they are; they say no place but along the spindle of a lathe
  };
  Kind kind = Kind::kLine;
  Spot to = Spot::Zero(), center = Spot::Zero(), stride = Spot::Zero();
  int number = 0;
  int sense = 1;  ///< of arcs: 1 counter-clockwise
  double level = 0, peck = 0, angle = 0;
  double round = 0;  ///< radius of the corner behind it, of wires
  std::string words;
};

/// A solid that a job can name.
struct Solid {
  enum class Shape { kBox, kRound, kMesh };
  Shape shape = Shape::kBox;
  Spot min = Spot::Zero(), max = Spot::Zero();  ///< box
  Spot base = Spot::Zero();                     ///< round: middle of the lower end
  int axis = 2;
  double length = 0, radius = 0, inner = 0;
  std::vector<Spot> points;  ///< mesh
  std::vector<std::array<int, 3>> faces;

  Eigen::AlignedBox3d bounds() const;
  double volume() const;  ///< closed form, mm3
};

struct StartHole {
  Spot at = Spot::Zero();
  double diameter = 0;
};

/// p goes to turn p + shift.
struct Move {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Spot shift = Spot::Zero();
  Spot operator()(const Spot& p) const { return turn * p + shift; }
  Move operator*(const Move& first) const { return {turn * first.turn, turn * first.shift + shift}; }
  Move inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
};
/// About X, then about Z; exact where both are quarters.
Move turnedBy(double about_x_deg, double about_z_deg);
Eigen::AlignedBox3d movedBounds(const Eigen::AlignedBox3d& box, const Move& move);

struct Clamping {
  Control control = Control::kNct;
  std::vector<Step> steps;
  Move move;                   ///< of the workpiece from the clamping before
  Spot origin = Spot::Zero();  ///< G54
  std::vector<Solid> fixtures;
  std::string tools;              ///< TOML, a table "[[@tool]]" each
  std::map<int, double> radii;    ///< offset table of D, and of H of a wire
  std::string parameters;         ///< TOML, of the control
  double bottom = 0, height = 0;  ///< of what a wire cuts
  bool idle = false;              ///< nothing is to be cut
};

struct Plan {
  std::string process;  ///< "nct mill", "lathe > mill", ...
  Solid blank;
  std::vector<StartHole> start_holes;
  std::vector<Clamping> clampings;
  double grid = 0.5, profile = 0.01;  ///< mm
  bool keeps_stock = false;           ///< writes a grid, for lathes that save one
  std::string stock_file;             ///< saved stock in place of the blank
  bool plain = false;                 ///< one program without [[setup]]
};

/// The plan of a seed.
Plan makePlan(std::uint64_t seed);
/// Its job folder: names and contents; "job.toml" is the job.
std::map<std::string, std::string> filesOf(const Plan& plan);
/// What a clamping's program says.
std::string programOf(const Clamping& clamping);

}  // namespace proveout::soak::second
