// NC programs made for measuring. The same arguments give the same text everywhere.
#pragma once

#include <string>

namespace proveout::bench {

/// One slot, 10 wide and 5 deep, through a block of 100 x 50 x 20 (mm, top at Z0): leaves 95000 mm3.
std::string slotProgram();

/// A pocket 40 x 30 x 5 in a block of 50 x 40 x 10 (mm, top at Z0), flat end mill of 10 mm: it leaves
/// 20000 - 5 (1200 - (4 - pi) 25) mm3.
std::string pocketProgram();

/// Ball-end finishing of a wavy surface, 200 x 200 mm, between Z-12.5 and Z-3.5: `lines` lines along X in
/// zig-zag, each of `moves_a_line` straight moves. Requires lines >= 2 and moves_a_line >= 1.
std::string finishingProgram(int lines, int moves_a_line);

/// The same on 100 x 100 mm, between Z-11 and Z-5, with tool centre point control where the tool leans:
/// upright, leaning by 15 degrees, or with the direction turning in every block, by 5 to 25 degrees from +z.
enum class FinishingAxis { kUpright, kLeaning, kTurning };
std::string fiveAxisFinishing(int lines, int moves_a_line, FinishingAxis axis);
/// Its job: ball of 6 mm, the machine in `machine_file`.
std::string fiveAxisJob(const std::string& program_file, const std::string& machine_file,
                        const std::string& tool = "type = \"ball\"\ndiameter = 6");

/// A pocket of `layers` layers with rounded corners, its outermost way 34 wide, in a plane that leans by 15
/// degrees.
std::string tiltedPocket(int layers);

/// Arcs in the plane XZ and ramps between them, as a ball finishes a trough: 222 motions in a block of 100 x
/// 50 mm.
std::string arcsProgram();

/// 4,240 moves crosswise over a relief of 19 x 19 mm that is finer than a ball of 0.8 mm.
std::string reliefProgram();

/// Three bores by a thread mill of ten teeth, and the job for it: mostly helices.
std::string threadMillProgram();
std::string threadMillJob(const std::string& program_file);

/// A program of at least `blocks` blocks that repeats the body of another, which ends in a line "M30".
std::string repeatedProgram(const std::string& program, int blocks);

/// A WHILE loop of five macro blocks a pass (condition, three assignments with arithmetic, END) and no
/// motion.
std::string macroLoopProgram(int passes);

/// The program of parts/wl4_shaft without the blocks of its thread tool.
std::string shaftWithoutThread(const std::string& program);

/// The job of parts/wl4_shaft with another program and without its nominal.
std::string shaftJob(const std::string& job, const std::string& program_file);

/// A cylinder of 40 x 100 mm, turned in 20,000 lines of 5 micrometres each, for the job of shortLinesJob().
std::string shortLinesProgram();
/// A thread M20 x 1 of 400 turns in one pass, for threadJob(400).
std::string longThreadProgram();
/// G30 of the FlexNC control: a worm of four starts in 940 passes, for wormJob().
std::string wormProgram();
std::string wormJob(const std::string& program_file);
/// A thread M20 x 2.5 of 28 mm with infeed along a flank, about 30 passes, for threadJob(60).
std::string manyPassesProgram();
/// Jobs for these programs: a bar of 50 x 130 and an insert; a bar of 20 and a thread tool.
std::string shortLinesJob(const std::string& program_file);
std::string threadJob(const std::string& program_file, int length_mm);

/// A closed contour of `blocks` straight blocks for the wire EDM control, like a gear, in a plate of 120 x
/// 120 x 60 (gearJob): a circle of 50 in 40 waves of `depth` mm, from a start hole within. Upright with an
/// offset, or on four axes with the wire leaning to the outside by `lean_deg`.
std::string gearProgram(int blocks, double depth, double lean_deg);
/// Sharp teeth with taper for the same plate.
std::string starProgram(int teeth, double depth, double taper_deg);
std::string gearJob(const std::string& program_file);

/// Volume of the shaft without its thread, by the drawing, mm3.
double shaftVolumeWithoutThread();

}  // namespace proveout::bench
