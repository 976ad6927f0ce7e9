#include "tests/bench/prediction_jobs.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "tests/bench/generated_programs.h"

namespace proveout::bench {

namespace {

using Words = std::vector<std::string>;

constexpr const char* kSlotStock = "box:0,0,-20:100,50,0";

Words milling(const std::string& program, const std::string& stock, const std::string& tool, double grid_mm) {
  return {program,   "--control",    "nct",
          "--stock", stock,          "--tool",
          tool,      "--resolution", fmt::format("{:g}", grid_mm)};
}

Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

const Words kNoPictures{"--no-render"};

/// The same circle again and again.
std::string onePlaceProgram(int passes) {
  std::string text = "T1 M6\nS1000 M3\nG0 X40 Y25\nZ1\nG1 Z-3 F500\n";
  for (int i = 0; i < passes; ++i) text += i % 2 == 0 ? "G1 X60 F1000\n" : "G1 X40\n";
  return text + "G0 Z50\nM30\n";
}

std::string helixProgram(int turns) {
  return fmt::format("T1 M6\nS1000 M3\nG0 X35 Y25\nZ1\nG2 X35 Y25 I15 J0 Z-16 L{} F1000\nG0 Z50\nM30\n",
                     turns);
}

/// Arcs of 80 degrees in G18 on which the tool goes aside by `lean_mm`, side by side in the block.
std::string leaningProgram(int arcs, double lean_mm) {
  std::string text = "T1 M6\nS9000 M3\nG0 X0 Y0\nZ5\n";
  for (int i = 0; i < arcs; ++i) {
    const double y = 4.0 + (42.0 - lean_mm) * i / arcs;
    fmt::format_to(std::back_inserter(text),
                   "G0 X25 Y{:.3f}\nG1 Z-1.5 F800\nG18\nG3 X75 Y{:.3f} Z-1.5 R39\nG17\nG0 Z5\n", y,
                   y + lean_mm);
  }
  return text + "G0 Z50\nM30\n";
}

/// Wells that widen by helices of `turns` turns each, 0.8 mm of rise a turn.
std::string wellsProgram(int turns) {
  std::string text = "T1 M6\nS9000 M3\nG0 X0 Y0\nZ5\n";
  for (int i = 0; i < 15; ++i) {
    const int x = 12 + 19 * (i % 5), y = 10 + 15 * (i / 5);
    fmt::format_to(std::back_inserter(text),
                   "G0 X{0} Y{1}\nG1 Z-9 F500\nX{2}\nG3 X{2} Y{1} I-3.5 J0 Z{3:.2f} L{4}\nG1 X{0}\nG0 Z5\n",
                   x, y, x + 3.5, -9.0 + 0.8 * turns, turns);
  }
  return text + "G0 Z50\nM30\n";
}

/// Wells of three turns that grow from 3 to 6.6, level or on the way down.
std::string spiralsProgram(bool falling) {
  std::string text = "T1 M6\nS9000 M3\nG0 X10 Y10\nZ5\n";
  for (int i = 0; i < 32; ++i) {
    const int x = 15 + 17 * (i / 4), y = 14 + 22 * (i % 4);
    fmt::format_to(std::back_inserter(text), "G0 X{} Y{}\nG1 Z-2 F800\n", x + 3, y);
    for (int k = 0; k < 3; ++k) {
      const double r = 3.0 + 1.2 * k, z = falling ? -3.0 - k : -2.0;
      fmt::format_to(std::back_inserter(text), "G3 X{:.1f} Y{} I{:.1f} J0 Z{}\n", x + r + 1.2, y, -r, z);
    }
    text += "G0 Z5\n";
  }
  return text + "G0 Z50\nM30\n";
}

/// Holes 6 deep, in rows of 40.
std::string holesProgram(int holes) {
  std::string text = "T1 M6\nS1000 M3\nG0 X0 Y0\nZ2\n";
  for (int i = 0; i < holes; ++i) {
    fmt::format_to(std::back_inserter(text), "G0 X{:.2f} Y{:.2f}\nG1 Z-6 F300\nG0 Z2\n", 4.0 + 4.8 * (i % 40),
                   4.0 + 4.8 * (i / 40));
  }
  return text + "G0 Z50\nM30\n";
}

/// A ball over rolling ground in `lines` lines.
std::string groundProgram(int lines) { return finishingProgram(lines, 200); }

/// Square pockets on a 33 degree slant, for a part that was turned.
std::string slantedProgram() {
  return "T1 M6\nS1000 M3\nG0 X-30 Y0\nZ5\nG1 Z-4 F500\nG1 X30 Y12\nX20 Y20\nX-20 Y-20\nG0 Z50\nM30\n";
}

/// A ball of `steps` rings, radius 30, as ASCII STL.
std::string ballStl(int steps) {
  const auto at = [&](int ring, int step) {
    const double v = std::numbers::pi * ring / steps, u = std::numbers::pi * step / steps;
    return fmt::format("vertex {:.6f} {:.6f} {:.6f}\n", 30 * std::sin(v) * std::cos(u),
                       30 * std::sin(v) * std::sin(u), 30 * std::cos(v));
  };
  std::string text = "solid ball\n";
  const auto facet = [&](const std::string& a, const std::string& b, const std::string& c) {
    text += "facet normal 0 0 0\nouter loop\n" + a + b + c + "endloop\nendfacet\n";
  };
  for (int ring = 0; ring < steps; ++ring) {
    for (int step = 0; step < 2 * steps; ++step) {
      const int next = (step + 1) % (2 * steps);
      if (ring + 1 < steps) facet(at(ring, step), at(ring + 1, step), at(ring + 1, next));
      if (ring > 0) facet(at(ring, step), at(ring + 1, next), at(ring, next));
    }
  }
  return text + "endsolid ball\n";
}

/// A block with slanting sides in 12 triangles.
std::string wedgeObj() {
  return "v -40 -25 -30\nv 40 -25 -30\nv 40 25 -30\nv -40 25 -30\nv -35 -20 0\nv 35 -20 -2\nv 35 20 -4\n"
         "v -35 20 -2\nf 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\n"
         "f 3 8 7\nf 4 1 5\nf 4 5 8\n";
}

std::string job(const std::string& rest, double grid_mm) {
  return fmt::format("schema = \"proveout.job/1\"\ncontrol = \"nct\"\n{}\n[simulation]\nresolution = {:g}\n",
                     rest, grid_mm);
}

constexpr const char* kBlock = "[stock]\nshape = \"box\"\nmin = [0, 0, -20]\nmax = [100, 50, 0]\n";
constexpr const char* kMiddleBlock = "[stock]\nshape = \"box\"\nmin = [-50, -30, -20]\nmax = [50, 30, 0]\n";
constexpr const char* kFlat10 = "[[tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 10\n";

/// Two clampings, the second turned by these angles.
std::string setupsJob(const std::string& angles_deg, double grid_mm) {
  return job(
      "[[setup]]\nname = \"first\"\nprogram = \"slant.nc\"\n[[setup]]\nname = \"second\"\n"
      "program = \"slant.nc\"\n[setup.transform]\nrotate = [" +
          angles_deg + "]\n" + kMiddleBlock + kFlat10,
      grid_mm);
}

std::string fixtureJob() {
  return job(
      std::string("program = \"slot.nc\"\n") + kBlock + kFlat10 +
          "[[fixture]]\nname = \"plate\"\nshape = \"box\"\nmin = [-200, -200, -60]\nmax = [300, 250, -20]\n"
          "[[fixture]]\nname = \"stop\"\nshape = \"box\"\nmin = [-200, 60, -20]\nmax = [300, 90, 10]\n",
      0.1);
}

/// A shaft with a thread that goes on to a mill, and with it to a grid.
std::string milledThreadJob() {
  return "schema = \"proveout.job/1\"\n[control]\nname = \"wl4-lathe\"\n[stock]\nshape = \"cylinder\"\n"
         "base = [0, 0, -60]\ndiameter = 20\nlength = 60\n[[tool]]\nnumber = 1\ntype = \"insert\"\n"
         "shape = \"thread\"\ninsert_angle = 60\ntip_flat = 0.1\norientation = 8\nedge_length = 2.2\n"
         "[[setup]]\nname = \"lathe\"\nprogram = \"passes.nc\"\n[[setup]]\nname = \"mill\"\n"
         "program = \"flat.nc\"\n[setup.control]\nname = \"nct\"\n[setup.transform]\nrotate = [0, 90, 0]\n"
         "[[setup.tool]]\nnumber = 1\ntype = \"flat\"\ndiameter = 6\n[simulation]\nresolution = 0.1\n";
}

std::string flatProgram() { return "T1 M6\nS3000 M3\nG0 X-40 Y-20\nZ20\nG1 Z7 F500\nY20\nG0 Z50\nM30\n"; }

/// Lines of the sample shaft's job that ask for another file.
std::string withFormat(std::string job, const std::string& format) {
  return job + fmt::format("\n[output]\nformats = [\"{}\"]\n", format);
}

void addSamples(const std::string& shared, const std::string& parts, std::vector<PredictedJob>& jobs) {
  if (!shared.empty()) {
    const std::string bear = shared + "/bear.nc", stock = "box:0,0,-20:80,80,0", ball = "1=ball:3.175";
    jobs.push_back({"bear 0.25", {}, {}, milling(bear, stock, ball, 0.25) + kNoPictures});
    jobs.push_back({"bear 0.1", {}, {}, milling(bear, stock, ball, 0.1) + kNoPictures});
    jobs.push_back({"bear 0.2, 4 pictures",
                    {},
                    {},
                    milling(bear, stock, ball, 0.2) +
                        Words{"--view", "iso", "--view", "top", "--view", "front", "--view", "left"}});
    jobs.push_back(
        {"bear 0.25, all formats",
         {},
         {},
         milling(bear, stock, ball, 0.25) + kNoPictures + Words{"--format", "stl,stl-ascii,obj,ply,vdb"}});
    jobs.push_back({"bear on a saved stock",
                    {},
                    milling(bear, stock, ball, 0.2) + kNoPictures + Words{"--format", "vdb"},
                    Words{bear, "--control", "nct", "--stock", "vdb:before/bear.vdb", "--tool", "1=ball:2"} +
                        kNoPictures});
    jobs.push_back({"flower mold 0.1",
                    {},
                    {},
                    milling(shared + "/flower_mold.nc", "box:-3.92956,-3.92829,-9.95121:61.0796,61.0529,0",
                            "1=flat:1", 0.1) +
                        kNoPictures});
  }
  for (const char* name :
       {"bracket", "circle_diamond_square", "freeform_patch", "gouged_plate", "keyed_shaft", "macro_plate",
        "polar_boss", "two_sides", "wire_die", "wire_punch", "wire_ruled", "wl4_plate", "wl4_shaft"})
    jobs.push_back({name, {}, {}, Words{parts + "/" + name + "/job.toml"}});
}

void addMilled(std::vector<PredictedJob>& jobs) {
  jobs.push_back({"slot 0.1, pictures",
                  {{"slot.nc", slotProgram}},
                  {},
                  milling("slot.nc", kSlotStock, "1=flat:10", 0.1)});
  jobs.push_back(
      {"slot 0.05, vdb",
       {{"slot.nc", slotProgram}},
       {},
       milling("slot.nc", kSlotStock, "1=flat:10", 0.05) + kNoPictures + Words{"--format", "vdb"}});
  jobs.push_back(
      {"slot from a saved stock",
       {{"slot.nc", slotProgram}},
       milling("slot.nc", kSlotStock, "1=flat:10", 0.1) + kNoPictures + Words{"--format", "vdb"},
       Words{"slot.nc", "--control", "nct", "--stock", "vdb:before/slot.vdb", "--tool", "1=flat:14"} +
           kNoPictures});
  jobs.push_back({"ground 0.25",
                  {{"ground.nc", [] { return groundProgram(250); }}},
                  {},
                  milling("ground.nc", "box:0,0,-20:200,200,0", "1=ball:6", 0.25) + kNoPictures});
  jobs.push_back({"finishing 500k moves",
                  {{"fine.nc", [] { return finishingProgram(250, 2000); }}},
                  {},
                  milling("fine.nc", "box:0,0,-20:200,200,0", "1=ball:6", 0.2) + kNoPictures});
  jobs.push_back({"4,000 passes over one place",
                  {{"place.nc", [] { return onePlaceProgram(4000); }}},
                  {},
                  milling("place.nc", kSlotStock, "1=ball:10", 0.25) + kNoPictures});
  for (const int turns : {50, 400}) {
    jobs.push_back({fmt::format("helix of {} turns", turns),
                    {{"helix.nc", [turns] { return helixProgram(turns); }}},
                    {},
                    milling("helix.nc", kSlotStock, "1=flat:8", 0.2) + kNoPictures});
  }
  jobs.push_back({"ball on arcs and ramps",
                  {{"arcs.nc", arcsProgram}},
                  {},
                  milling("arcs.nc", kSlotStock, "1=ball:6", 0.25) + kNoPictures});
  for (const char* tool : {"1=flat:6", "1=ball:6", "1=bull:6:1", "1=lollipop:6:3"}) {
    const bool falling = tool[2] != 'f';
    jobs.push_back({fmt::format("96 turns on {} {}", falling ? "falling spirals" : "spirals", tool + 2),
                    {{"spirals.nc", [falling] { return spiralsProgram(falling); }}},
                    {},
                    milling("spirals.nc", "box:0,0,-20:150,100,0", tool, 0.25) + kNoPictures});
  }
  jobs.push_back({"1,200 holes, drill",
                  {{"holes.nc", [] { return holesProgram(1200); }}},
                  {},
                  milling("holes.nc", "box:0,0,-20:200,152,0", "1=drill:3", 0.2) + kNoPictures});
  jobs.push_back({"1,200 holes, flat",
                  {{"holes.nc", [] { return holesProgram(1200); }}},
                  {},
                  milling("holes.nc", "box:0,0,-20:200,152,0", "1=flat:3", 0.25) + kNoPictures});
  jobs.push_back({"large fixtures",
                  {{"slot.nc", slotProgram}, {"job.toml", fixtureJob}},
                  {},
                  Words{"job.toml"} + kNoPictures});
}

/// To which nothing was fitted.
void addOthers(const std::string& parts, std::vector<PredictedJob>& jobs) {
  const auto add = [&](const std::string& name, const std::function<std::string()>& program,
                       const std::string& stock, const std::string& tool, double grid_mm,
                       const Words& more = kNoPictures) {
    jobs.push_back({"other: " + name, {{"p.nc", program}}, {}, milling("p.nc", stock, tool, grid_mm) + more});
  };
  const auto leaning = [](int arcs, double lean_mm) {
    return [arcs, lean_mm] { return leaningProgram(arcs, lean_mm); };
  };
  add("lollipop on leaning arcs", leaning(70, 9), kSlotStock, "1=lollipop:7:3.5", 0.15);
  add("dovetail on leaning arcs", leaning(50, 14), kSlotStock, "1=dovetail:9:60:3:4", 0.2);
  add("cone on leaning arcs", leaning(90, 5), kSlotStock, "1=cone:9:2:70", 0.15);
  add("bull nose on leaning arcs", leaning(60, 20), kSlotStock, "1=bull:7:2", 0.15);
  add(
      "dovetail on helices", [] { return wellsProgram(2); }, kSlotStock, "1=dovetail:7:55:2:3", 0.2);
  add(
      "tapered ball on helices", [] { return wellsProgram(4); }, kSlotStock, "1=taper:1.5:12:5", 0.2);
  add("relief 0.1", reliefProgram, "box:0,0,-5:20,20,0", "1=ball:0.8", 0.1);
  add("holes and four pictures", [] { return holesProgram(300); }, "box:0,0,-15:200,50,0", "1=drill:4", 0.15,
      {"--view", "iso", "--view", "top", "--view", "left", "--view", "bottom"});
  add("slot and five pictures", slotProgram, kSlotStock, "1=bull:12:2", 0.2,
      {"--view", "iso", "--view", "top", "--view", "left", "--view", "right", "--view", "front"});
  jobs.push_back({"other: thread mill of ten teeth",
                  {{"mill.nc", threadMillProgram}, {"job.toml", [] { return threadMillJob("mill.nc"); }}},
                  {},
                  Words{"job.toml"} + kNoPictures});
  jobs.push_back({"other: worm, three pictures",
                  {{"worm.pmc", wormProgram}, {"job.toml", [] { return wormJob("worm.pmc"); }}},
                  {},
                  Words{"job.toml", "--view", "iso", "--view", "top", "--view", "left"}});
  const auto part = [&](const std::string& name, const Words& more) {
    jobs.push_back({"other: " + name, {}, {}, Words{parts + "/" + name + "/job.toml"} + more});
  };
  part("flexnc_bore", {});
  part("flexnc_shaft", {});
  part("bracket", {"--resolution", "0.4", "--view", "iso", "--view", "top", "--view", "left"});
  part("polar_boss", Words{"--resolution", "0.15"} + kNoPictures);
  part("freeform_patch", Words{"--resolution", "0.1"} + kNoPictures);
}

/// Holes that are measured: each is cut, and a measuring move goes into it.
std::string measuredProgram(int holes, double step) {
  std::string text = "G21 G90 G17\nT1 M6\nS1000 M3\n";
  for (int i = 0; i < holes; ++i) {
    fmt::format_to(std::back_inserter(text), "G0 Z5\nG0 X{:g} Y{:g}\nG1 Z-3 F500\nG0 Z5\nG31 Z-8 F200\n",
                   12 + step * (i % 5), 10 + step * (i / 5));
  }
  return text + "G0 Z5\nM30\n";
}

/// A spiral of chords, from the middle of the block outwards.
std::string chordSpiralProgram(double radius, int turns, double chord_deg) {
  std::string text = "T1 M6\nS9000 M3\nG0 X50 Y25\nZ5\nG1 Z-3 F500\n";
  const int chords = static_cast<int>(turns * 360 / chord_deg);
  for (int k = 1; k <= chords; ++k) {
    const double angle = k * chord_deg * std::numbers::pi / 180, r = radius * k / chords;
    fmt::format_to(std::back_inserter(text), "X{:.4f} Y{:.4f} Z{:.4f}\n", 50 + r * std::cos(angle),
                   25 + r * std::sin(angle), -3.0 - 1.5 * k / chords);
  }
  return text + "G0 Z50\nM30\n";
}

/// Of kinds that have no terms of their own, twice: the second time with other sizes, held out.
void addKinds(std::vector<PredictedJob>& jobs) {
  for (const bool held_out : {false, true}) {
    const auto name = [&](const std::string& kind) { return (held_out ? "held out: " : "kind: ") + kind; };
    const auto add = [&](const std::string& kind, const std::function<std::string()>& program,
                         const std::string& tool, double grid_mm, const Words& more = {}) {
      jobs.push_back({name(kind),
                      {{"p.nc", program}},
                      {},
                      milling("p.nc", kSlotStock, tool, grid_mm) + kNoPictures + more,
                      "run",
                      held_out});
    };
    const Words unmerged{"--simplify", "0"};
    const auto measured = [held_out] { return held_out ? measuredProgram(9, 13) : measuredProgram(4, 16); };
    const auto wells = [held_out] { return wellsProgram(held_out ? 5 : 3); };
    const auto spiral = [held_out] {
      return held_out ? chordSpiralProgram(17, 11, 4) : chordSpiralProgram(20, 14, 6);
    };
    add("measuring moves", measured, held_out ? "1=ball:5" : "1=flat:6", held_out ? 0.4 : 0.5);
    add("slot, not merged", slotProgram, held_out ? "1=bull:9:2" : "1=flat:10", held_out ? 0.2 : 0.15,
        unmerged);
    add("relief, not merged", reliefProgram, held_out ? "1=ball:1.2" : "1=ball:0.8", held_out ? 0.12 : 0.2,
        unmerged);
    add("taper on helices", wells, held_out ? "1=taper:2:9:8" : "1=taper:1.5:12:6", held_out ? 0.25 : 0.2);
    add("spiral of chords, flat", spiral, held_out ? "1=flat:5" : "1=flat:7", 0.2);
    add("spiral of chords, taper", spiral, held_out ? "1=taper:2:7:10" : "1=taper:3:10:12", 0.2);
    jobs.push_back({name("two meshes"),
                    {{"a.stl", [held_out] { return ballStl(held_out ? 90 : 142); }},
                     {"b.stl", [held_out] { return ballStl(held_out ? 70 : 142); }}},
                    {},
                    Words{"a.stl", "b.stl", "--resolution", held_out ? "0.3" : "0.2"},
                    "compare",
                    held_out});
  }
}

void addMeshes(std::vector<PredictedJob>& jobs) {
  jobs.push_back({"mesh blank of 80,000 triangles",
                  {{"slant.nc", slantedProgram}, {"ball.stl", [] { return ballStl(142); }}},
                  {},
                  milling("slant.nc", "mesh:ball.stl", "1=flat:10", 0.3) + kNoPictures});
  jobs.push_back({"mesh blank of 640,000 triangles",
                  {{"slant.nc", slantedProgram}, {"ball.stl", [] { return ballStl(400); }}},
                  {},
                  milling("slant.nc", "mesh:ball.stl", "1=flat:10", 0.3) + kNoPictures});
  jobs.push_back({"mesh blank of 12 triangles",
                  {{"slant.nc", slantedProgram}, {"wedge.obj", wedgeObj}},
                  {},
                  milling("slant.nc", "mesh:wedge.obj", "1=flat:10", 0.1) + kNoPictures});
  jobs.push_back({"setups turned by 33 degrees",
                  {{"slant.nc", slantedProgram}, {"job.toml", [] { return setupsJob("0, 0, 33", 0.2); }}},
                  {},
                  Words{"job.toml"} + kNoPictures});
  jobs.push_back({"setups tilted",
                  {{"slant.nc", slantedProgram}, {"job.toml", [] { return setupsJob("21, 0, 33", 0.3); }}},
                  {},
                  Words{"job.toml"} + kNoPictures});
}

void addTurned(const std::string& parts, std::vector<PredictedJob>& jobs) {
  jobs.push_back({"20,000 short lines",
                  {{"lines.nc", shortLinesProgram}, {"job.toml", [] { return shortLinesJob("lines.nc"); }}},
                  {},
                  Words{"job.toml"} + kNoPictures});
  jobs.push_back({"thread of 400 turns",
                  {{"turns.nc", longThreadProgram}, {"job.toml", [] { return threadJob("turns.nc", 420); }}},
                  {},
                  Words{"job.toml"} + kNoPictures});
  jobs.push_back({"30 thread passes",
                  {{"passes.nc", manyPassesProgram}, {"job.toml", [] { return threadJob("passes.nc", 60); }}},
                  {},
                  Words{"job.toml"}});
  jobs.push_back({"worm of four starts",
                  {{"worm.pmc", wormProgram}, {"job.toml", [] { return wormJob("worm.pmc"); }}},
                  {},
                  Words{"job.toml"}});
  jobs.push_back({"30 thread passes, vdb",
                  {{"passes.nc", manyPassesProgram},
                   {"job.toml", [] { return withFormat(threadJob("passes.nc", 60), "vdb"); }}},
                  {},
                  Words{"job.toml", "--resolution", "0.2"} + kNoPictures});
  jobs.push_back({"thread, then a mill",
                  {{"passes.nc", manyPassesProgram}, {"flat.nc", flatProgram}, {"job.toml", milledThreadJob}},
                  {},
                  Words{"job.toml"} + kNoPictures});
  jobs.push_back({"30 thread passes, vdb 0.1",
                  {{"passes.nc", manyPassesProgram},
                   {"job.toml", [] { return withFormat(threadJob("passes.nc", 60), "vdb"); }}},
                  {},
                  Words{"job.toml", "--resolution", "0.1"} + kNoPictures});
  jobs.push_back(
      {"wl4_shaft, vdb 0.2",
       {},
       {},
       Words{parts + "/wl4_shaft/job.toml", "--resolution", "0.2", "--format", "vdb"} + kNoPictures});
}

void addWired(std::vector<PredictedJob>& jobs) {
  const auto add = [&](const std::string& name, const std::function<std::string()>& program) {
    jobs.push_back({name,
                    {{"wire.nc", program}, {"job.toml", [] { return gearJob("wire.nc"); }}},
                    {},
                    Words{"job.toml"} + kNoPictures});
  };
  add("wire, 20,000 blocks", [] { return gearProgram(20000, 2.5, 0.0); });
  for (const int blocks : {500, 5000, 20000})
    add(fmt::format("leaning wire, {} blocks", blocks), [blocks] { return gearProgram(blocks, 2.5, 2.0); });
  add("leaning wire, 40 sharp teeth", [] { return starProgram(40, 3.0, 1.0); });
  add("leaning wire, 300 sharp teeth", [] { return starProgram(300, 0.6, 0.5); });
}

/// Tools that lean, and that turn while they cut.
void addFiveAxis(const std::string& parts, std::vector<PredictedJob>& jobs) {
  const auto part = [&](const std::string& file, const Words& more, bool held_out = false) {
    std::string name = "five axes: " + file;
    for (const std::string& word : more)
      if (word.front() != '-') name += " " + word;
    jobs.push_back({name, {}, {}, Words{parts + "/" + file + ".toml"} + more, "run", held_out});
  };
  for (const char* file :
       {"tetrahedron/job-hh-255", "tetrahedron/job-tt-2512", "tetrahedron/job-ht-2512", "cone_frustum/job",
        "cone_frustum/tilted", "relief_cylinder/job", "impeller/job", "ruled_wall/job"}) {
    part(file, {});
    part(file, Words{"--resolution", "0.25"} + kNoPictures);
  }
  for (const char* file : {"tetrahedron/job-tt-255", "cone_frustum/tilted", "impeller/job"})
    part(file, Words{"--resolution", "0.17"} + kNoPictures, true);
  part("relief_cylinder/job", {"--resolution", "0.15", "--view", "iso", "--view", "top"}, true);
  const auto finishing = [&](FinishingAxis axis, int lines, int moves, double grid_mm, bool held_out) {
    const std::string name = axis == FinishingAxis::kLeaning ? "leaning" : "turning";
    jobs.push_back(
        {fmt::format("five axes: ball {} {} x {} {:g}", name, lines, moves, grid_mm),
         {{"five.nc", [=] { return fiveAxisFinishing(lines, moves, axis); }},
          {"job.toml", [file = parts + "/machines/head_cb.toml"] { return fiveAxisJob("five.nc", file); }}},
         {},
         Words{"job.toml", "--resolution", fmt::format("{:g}", grid_mm)} + kNoPictures,
         "run",
         held_out});
  };
  for (const FinishingAxis axis : {FinishingAxis::kLeaning, FinishingAxis::kTurning}) {
    finishing(axis, 5, 1001, 0.1, false);
    finishing(axis, 20, 1001, 0.25, false);
    finishing(axis, 20, 1001, 0.1, false);
    finishing(axis, 40, 50, 0.2, false);
    finishing(axis, 30, 200, 0.15, true);
  }
  const auto made = [&](const std::string& name, const std::function<std::string()>& program,
                        const std::string& machine, const std::string& tool, double grid_mm, bool held_out) {
    jobs.push_back(
        {"five axes: " + name,
         {{"five.nc", program},
          {"job.toml", [=] { return fiveAxisJob("five.nc", parts + "/" + machine + ".toml", tool); }}},
         {},
         Words{"job.toml", "--resolution", fmt::format("{:g}", grid_mm)} + kNoPictures,
         "run",
         held_out});
  };
  const std::string flat = "type = \"flat\"\ndiameter = 6",
                    bull = "type = \"bull\"\ndiameter = 6\ncorner_radius = 1";
  for (const bool held_out : {false, true}) {
    made(
        "pocket that leans", [=] { return tiltedPocket(held_out ? 4 : 12); }, "machines/head_cb", flat,
        held_out ? 0.13 : 0.1, held_out);
    made(
        "bull nose turning",
        [=] { return fiveAxisFinishing(held_out ? 8 : 12, held_out ? 100 : 200, FinishingAxis::kTurning); },
        "machines/head_cb", bull, held_out ? 0.2 : 0.25, held_out);
  }
}

}  // namespace

std::vector<PredictedJob> predictedJobs(const std::string& shared, const std::string& parts) {
  std::vector<PredictedJob> jobs;
  addSamples(shared, parts, jobs);
  addMilled(jobs);
  addOthers(parts, jobs);
  addKinds(jobs);
  addMeshes(jobs);
  addTurned(parts, jobs);
  addWired(jobs);
  addFiveAxis(parts, jobs);
  return jobs;
}

}  // namespace proveout::bench
