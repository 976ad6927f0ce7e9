// What only a maker says of a control of the ISO family: the tables that the shared code is run with.
//
// Where comments of this folder name a section of "the manual" it is that of nct, whose rules the code
// follows.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "core/nc/iso/model/codes.h"
#include "core/nc/iso/model/language.h"
#include "core/nc/iso/model/program_store.h"
#include "core/nc/iso/model/system_calls.h"
#include "core/nc/iso/parameters/parameter_table.h"
#include "core/nc/kinematics/axes.h"
#include "core/nc/macro/formula_language.h"
#include "core/nc/services/cutter_comp.h"
#include "core/nc/text/alarms.h"
#include "core/nc/text/lexer.h"

namespace proveout::nc {

struct IsoContext;
struct BlockPlan;
struct IsoState;
class IsoParameters;

/// What a maker's own rules keep of a channel from block to block, beside the state of the family.
class MakerData {
 public:
  virtual ~MakerData() = default;
};

struct ArgumentRules;
struct Arguments;

/// What M98 and its like ask for.
struct SubprogramCall {
  std::int64_t number = -1;    ///< O number; -1: the file or program of a name
  std::int64_t count = 1;      ///< 0: nothing is called
  std::int64_t block = -1;     ///< N number to begin with; -1: at the head
  bool local = false;          ///< the program in hand
  bool folders_first = false;  ///< other programs of the file come last
};

/// The system variables of a channel: banks that its variables ask.
class SystemVariables {
 public:
  virtual ~SystemVariables() = default;
  /// The run is over, whatever ended it: what the control keeps goes into the summary.
  virtual void keep(IsoContext& /*c*/) {}
};

/// What numbers of messages that a program raises count from.
struct MessageNumbers {
  int alarm = 3000;  ///< #3000
  int stop = 3000;   ///< #3006
  int box = 3000;    ///< #3107
};

/// Where controls of the family do the same statement differently. The defaults are those of nct; a member
/// says what the others do.
struct IsoRules {
  bool last_of_group = false;    ///< of several codes of a group in a block the last holds; false: they clash
  bool offsets_by_tool = false;  ///< T names the offsets too: H and D name none, and what T changes is there
                                 ///< before the block moves
  bool set_position_steps = false;  ///< U, V, W of G92 add to the position; false: they are refused
  bool directions_meet = false;     ///< lines by ,A meet in a corner without G41, G42 too
  bool keeps_return_level = false;  ///< the end of a drilling cycle leaves G98 and G99 as they are
  bool cycles_in_comp = false;      ///< drilling cycles run under G41 and G42, at the compensated points
  bool motion_or_cycle =
      false;                    ///< of a motion code and a cycle in a block the later one holds; false: clash
  int local_call = -1;          ///< M code whose P is a block N of the same program to call; -1: none
  bool words_behind_if = true;  ///< IF[...] G0 X1; false: only statements of the macro language
  bool loops_are_closed = false;      ///< GOTO cannot enter a loop behind its DO
  std::int64_t lowest_jump = 0;       ///< smallest block number of GOTO
  bool channel_in_messages = true;    ///< messages show the channel beside their number
  bool names_output = true;           ///< the first DPRNT behind POPEN 31 names the file; false: POPEN alone,
                                      ///< and what is written goes to `macro.txt`
  int m_words = 8;                    ///< more M functions than that in a block are noted; over 8 are refused
  bool probe_in_transforms = false;   ///< G31 goes with scaling, mirroring, rotation and polar data
  bool loose_arcs = false;            ///< an arc tolerance of 0 checks nothing, and a centre word of 0 across
                                      ///< the plane is no word
  bool short_radius_is_half = false;  ///< R within the tolerance of half the chord makes a half circle
  /// A length offset that changes without a motion of its axis acts with the axis's next motion, in steps
  /// (G91) too: see HeldWay. False: steps count from where the machine is.
  bool holds_length = false;
  /// Unequal factors of G51 take centre and ends of an arc with I J K each by themselves, which makes it a
  /// spiral, and R by the larger factor. False: the arc is made anew from its ends and R by the factor of the
  /// plane's first axis.
  bool scales_centres = false;
  bool dynamic_zero_off = false;      ///< G54.2 P0 ends a dynamic zero: the work system before is there again
  bool local_shift_absolute = false;  ///< the words of G52 are the shift; false: under G91 they add to it
  int extended_systems = 99;          ///< work systems of G54.1, G10 L20
};

struct IsoDialect {
  std::string_view name;  ///< of the control
  const AlarmTable& alarms;
  const CodeIndex& codes;
  const ParameterTable& parameters;
  std::reference_wrapper<const FormulaLanguage> formulas;  ///< whose variables are #n
  LexRules lexing = {};  ///< formulas and names of axes come from the channel
  ProgramLayout layout = ProgramLayout::kOneInAFile;
  MessageNumbers messages = {};
  IsoRules rules = {};
  /// The work system (WorkSystemId) of a code beside G54 to G59 and G54.1; 0: it is none. Null: there are no
  /// such codes. False: an error was reported.
  bool (*work_system)(IsoContext&, BlockPlan&, const GCode&, int& id) = nullptr;
  /// A last look at a block that is planned. Null: there is none. False: an error was reported.
  PlanFunction check_block = nullptr;
  /// What a call of the family of M98 says; `code` is its M number. False: reported. Null: P is the number,
  /// L the repetitions.
  bool (*subprogram)(IsoContext&, int code, SubprogramCall&) = nullptr;
  /// The block in hand as arguments of a macro. False: reported. Null: as nct does it.
  bool (*arguments)(IsoContext&, const ArgumentRules&, Arguments&) = nullptr;
  /// Letters that parameters turn into calls of subprograms.
  std::span<const SystemLetter> letters = kSystemLetters;
  /// Into how many increments ROUND divides the unit of a word. Null: it gives whole numbers everywhere.
  double (*steps_per_unit)(const IsoContext&, Address) = nullptr;
  /// Makes the system variables of a channel known to its variables. Null: there are none.
  std::unique_ptr<SystemVariables> (*system_variables)(IsoContext&) = nullptr;
  /// Makes what the maker's rules keep of a channel (IsoContext::maker). Null: nothing.
  std::unique_ptr<MakerData> (*maker_data)(IsoContext&) = nullptr;
  /// Plans a block: all checks, on the plan's copy of the state. Null: planBlock().
  bool (*plan)(IsoContext&, BlockPlan&) = nullptr;
  /// Takes the numbers of a block's words in hand before anything else asks for them: what counts in least
  /// increments, rounding, ranges. Not asked of blocks that call a macro. False: reported. Null: they are as
  /// written.
  bool (*take_words)(IsoContext&) = nullptr;
  /// An M function that neither the control nor the job knows. False: reported. Null: it is told.
  bool (*unknown_m)(IsoContext&, const Word&, int number) = nullptr;
  /// Shifts of G52 and G92 at the end of a program. Null: they are 0.
  void (*end_shifts)(IsoContext&) = nullptr;
  /// Sets back what the end of a program sets back, with the state of power-on at hand, in place of the groups
  /// that nct resets. Null: as nct does.
  void (*end_state)(IsoContext&, const IsoState& fresh) = nullptr;
  /// The channel stands at power-on, its first program is about to be read. Null: nothing is to be done.
  void (*begin)(IsoContext&) = nullptr;
  /// What stands otherwise in the state of power-on, which is nct's. Null: nothing.
  void (*power_on)(const IsoContext&, IsoState&) = nullptr;
  /// Plans T. Null: planTool().
  bool (*tool)(IsoContext&, BlockPlan&, const Word&) = nullptr;
  /// The lines of a block that runs others (BlockPlan::lines) are done. Null: nothing is.
  bool (*lines_done)(IsoContext&) = nullptr;
  /// Makes what reads the lines of a channel and carries out its statements. Null: lexer and macro language
  /// of the family.
  std::unique_ptr<IsoLanguage> (*language)(IsoContext&) = nullptr;
  /// The rows of H and D of the block, and their values into the state. Null: those of nct.
  PlanFunction offsets = nullptr;
  /// The work system that G54 to G59 and G54.1 of the block choose. Null: those of nct, P1 to P99.
  PlanFunction usual_systems = nullptr;
  /// G69, G50 and G50.1 of the block, and what a plane change does to a rotation. Null: planTransformsOff().
  PlanFunction transforms_off = nullptr;
  /// Changes the axes that get the length of a block with G43 or G44, or with H while they are on. False: an
  /// error was reported. Null: those of the parameters.
  bool (*length_axes)(IsoContext&, const BlockPlan&, AxisSet&) = nullptr;
  /// Rules of cutter compensation other than nct's. Null: there are none.
  void (*compensation)(const IsoParameters&, CutterCompPolicy&) = nullptr;
};

}  // namespace proveout::nc
