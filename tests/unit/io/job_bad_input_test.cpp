// Every class of bad job file is refused, with the place and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "job_fixture.h"

namespace proveout {
namespace {

using namespace io_test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string refused(const std::string& text) {
  JobFolder folder;
  return folder.refusal(text);
}
std::string refusedTool(const std::string& lines) {
  return refused(kSmallJob + "[[tool]]\nnumber = 2\n" + lines + "\n");
}
std::string refusedEnd(const std::string& lines) { return refused(kSmallJob + lines + "\n"); }

TEST(BadJob, UnknownKeyNamesTheNearestAndShowsTheLine) {
  JobFolder folder;
  EXPECT_EQ(
      folder.refusal(replacedOnce(kSmallJob, "diameter = 10", "diamter = 10")),
      folder.path("job.toml") +
          ":8:1: error[job-missing]: [[tool]] 1 needs the key 'diameter'\n    [[tool]]\n    ^~~~~~~~\n" +
          folder.path("job.toml") +
          ":11:1: error[job-unknown-key]: [[tool]] 1 has no key 'diamter'; did you mean 'diameter'?\n"
          "    diamter = 10\n    ^~~~~~~\n");
}

TEST(BadJob, StartHoles) {
  const auto refusedHole = [](const std::string& keys) {
    return refused(withStock(kSmallStock + "start_hole = [{ " + keys + " }]"));
  };
  EXPECT_THAT(refusedHole("diameter = 1"), HasSubstr("[[start_hole]] 1 needs the key 'at'"));
  EXPECT_THAT(refusedHole("at = [1, 2]"), HasSubstr("[[start_hole]] 1 needs the key 'diameter'"));
  EXPECT_THAT(refusedHole("at = [1, 2], diameter = 0"), HasSubstr("diameter must be above 0"));
  EXPECT_THAT(refusedHole("at = [1, 2], diameter = -1"), HasSubstr("diameter must be above 0"));
  EXPECT_THAT(refusedHole("at = [1, 2, 3], diameter = 1"), HasSubstr("at must be a list of two numbers"));
  EXPECT_THAT(refusedHole("at = 1, diameter = 1"), HasSubstr("at must be a list of two numbers"));
  EXPECT_THAT(refusedHole("at = [1, 'x'], diameter = 1"), HasSubstr("at y must be a number"));
  EXPECT_THAT(refusedHole("at = [1, 2], diamter = 1"), HasSubstr("did you mean 'diameter'?"));
  EXPECT_THAT(refused(withStock(kSmallStock + "start_holes = []")), HasSubstr("did you mean 'start_hole'?"));
  EXPECT_THAT(refused(withStock(kSmallStock + "part_point = [1, 2]")), HasSubstr("part_point"));
}

TEST(BadJob, Severities) {
  EXPECT_THAT(refusedEnd("[severity]\nthin_featur = 'off'"),
              HasSubstr("there is no kind of finding 'thin_featur', did you mean 'thin_feature'?"));
  EXPECT_THAT(refusedEnd("[severity]\ngouge = 'silent'"), HasSubstr("off"));
  EXPECT_THAT(refusedEnd("[severity]\ngouge = 1"), HasSubstr("gouge must be"));
  EXPECT_THAT(refused("severity = 'off'\n" + kSmallJob), HasSubstr("severity must be a table"));
  // Kinds that say that a result is missing can be made severer, and not milder.
  for (const char* line : {"alarm = 'warning'", "output = 'off'", "partial = 'note'", "undecided = 'off'",
                           "no_part = 'warning'", "not_compared = 'off'"})
    EXPECT_THAT(refusedEnd(std::string("[severity]\n") + line),
                HasSubstr("would hide that a result is missing"))
        << line;
  EXPECT_EQ(refusedEnd("[severity]\npartial = 'error'\nundecided = 'warning'\nthin_feature = 'off'"),
            "accepted");
}

TEST(BadJob, UnknownKeysAtEveryLevel) {
  EXPECT_THAT(
      refused("nmae = 'x'\n" + kSmallJob),
      HasSubstr(
          "job.toml:1:1: error[job-unknown-key]: the job file has no key 'nmae'; did you mean 'name'?"));
  EXPECT_THAT(refusedEnd("[simulation]\nresolutoin = 1"),
              HasSubstr("[simulation] has no key 'resolutoin'; did you mean 'resolution'?"));
  EXPECT_THAT(refusedEnd("[[machine.axis]]\nnumber = 4"), HasSubstr("name"));
  EXPECT_THAT(refusedEnd("[[machine.axis]]\nname = 'C'\nnumber = 40"), HasSubstr("number"));
  EXPECT_THAT(refusedEnd("[[machine.axis]]\nname = 'C'\nnumber = 4\nkind = 'round'"), HasSubstr("rotary"));
  EXPECT_THAT(refusedEnd("[[machine.axis]]\nname = 'C'\nnumber = 4\ncarries = 'tool'"), HasSubstr("part"));
  EXPECT_THAT(refusedEnd("[[machine.axis]]\nname = 'C'\nnumber = 4\nrapdi = 4"), HasSubstr("'rapid'"));
  EXPECT_THAT(refusedEnd("[machine.limits]\nA = [0, 1]"),
              HasSubstr("[machine.limits] has no key 'A'; the keys are X, Y, Z"));
  EXPECT_THAT(refusedEnd("[offsets.work]\nG60 = [0, 0, 0]"), HasSubstr("'G60' is no work offset"));
  EXPECT_THAT(refusedEnd("[offsets.work]\n\"G54.1 P100\" = [0, 0, 0]"), HasSubstr("is no work offset"));
  EXPECT_THAT(refusedEnd("[offsets.length]\nH1 = 1"), HasSubstr("'H1' is no row"));
  EXPECT_THAT(refusedEnd("[offsets.length]\n0 = 1"), HasSubstr("'0' is no row"));
  EXPECT_THAT(refusedEnd("[offsets.length]\n1 = { geom = 1 }"), HasSubstr("has no key 'geom'"));
  EXPECT_THAT(refusedEnd("[offsets.tool]\n1 = 1"), HasSubstr("[offsets] has no key 'tool'"));
  EXPECT_THAT(refusedEnd("[spindle]\nx = 1"), HasSubstr("has no key 'spindle'"));
  EXPECT_THAT(refusedEnd("[output]\nformat = ['stl']"), HasSubstr("did you mean 'formats'?"));
  EXPECT_THAT(refusedEnd("[panel]\nskip = [1]"), HasSubstr("[panel] has no key 'skip'"));
  // Keys of one shape are not keys of another.
  EXPECT_THAT(refused(withStock(kSmallStock + "radius = 3")), HasSubstr("[stock] has no key 'radius'"));
  EXPECT_THAT(refusedTool("type = 'flat'\ndiameter = 3\ncorner_radius = 1"),
              HasSubstr("[[tool]] 2 has no key 'corner_radius'"));
}

TEST(BadJob, MissingKeys) {
  for (const char* line : {"schema = \"proveout.job/1\"\n", "program = \"bracket.nc\"\n", "number = 1\n",
                           "type = \"flat\"\n", "min = [0, 0, -20]\n", "shape = \"box\"\n"}) {
    const std::string key = std::string(line).substr(0, std::string(line).find(' '));
    EXPECT_THAT(refused(replacedOnce(kSmallJob, line, "")), HasSubstr("needs the key '" + key + "'"));
  }
  EXPECT_THAT(refused(""), AllOf(HasSubstr("needs the key 'program'"), HasSubstr("needs the key 'stock'"),
                                 HasSubstr("needs the key 'tool'")));
  EXPECT_THAT(refusedTool("type = 'bull'\ndiameter = 3"), HasSubstr("needs the key 'corner_radius'"));
  EXPECT_THAT(refusedTool("type = 'cone'\ndiameter = 3"), HasSubstr("needs the key 'cone_angle'"));
  EXPECT_THAT(refusedTool("type = 'taper'\ntip_diameter = 3\ntaper_angle = 3"),
              HasSubstr("a taper needs diameter or flute_length"));
  EXPECT_THAT(refusedEnd("[nominal]\ngouge = 1"), HasSubstr("[nominal] needs the key 'mesh'"));
  EXPECT_THAT(refused(withStock("shape = 'cylinder'\nbase = [0, 0, 0]\nlength = 1")),
              HasSubstr("needs the key 'diameter'"));
}

TEST(BadJob, WrongTypes) {
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "diameter = 10", "diameter = \"10\"")),
              HasSubstr("11:12: error[job-type]: diameter must be a number, not a text"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "number = 1", "number = 1.0")),
              HasSubstr("number must be a whole number"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "\"flat\"", "3")),
              HasSubstr("type must be a text in quotes, not a whole number"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "[0, 0, -20]", "[0, 0]")),
              HasSubstr("min must be a list of three numbers"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "[0, 0, -20]", "[0, true, 1]")),
              HasSubstr("min: y must be a number, not true or false"));
  EXPECT_THAT(refused("stock = 5\n" + replacedOnce(kSmallJob, "[stock]\n" + kSmallStock, "")),
              HasSubstr("stock must be a table, not a whole number"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "[[tool]]", "[tool]")),
              HasSubstr("tool must be a list, not a table"));
  EXPECT_THAT(refused("tool = [1]\n" + replacedOnce(kSmallJob, "[[tool]]", "[[x]]")),
              HasSubstr("an entry of [[tool]] must be a table"));
  EXPECT_THAT(refused("name = 1979-05-27\n" + kSmallJob),
              HasSubstr("name must be a text in quotes, not a date or time"));
  EXPECT_THAT(refusedEnd("[panel]\noptional_stop = 1"), HasSubstr("optional_stop must be true or false"));
  EXPECT_THAT(refusedEnd("[machine]\nlimits = []"), HasSubstr("limits must be a table, not a list"));
  EXPECT_THAT(refusedEnd("[machine.limits]\nX = 5"), HasSubstr("X must be a list of two numbers"));
  EXPECT_THAT(refusedEnd("[machine]\ntool_change = 300"),
              HasSubstr("tool_change must be a list of three numbers"));
  EXPECT_THAT(refusedEnd("[machine]\ntool_change = [0, 300]"), HasSubstr("tool_change"));
  EXPECT_THAT(refusedEnd("[machine]\ntool_change = {}"), HasSubstr("tool_change names no axis"));
  EXPECT_THAT(refusedEnd("[machine]\ntool_change = { Z = 'up' }"), HasSubstr("Z must be a number"));
  EXPECT_THAT(refusedEnd("[machine]\ntool_change = { z = 300 }"), HasSubstr("has no key 'z'"));
  EXPECT_THAT(refusedTool("type = 'flat'\ndiameter = 3\nhand = 'both'"), HasSubstr("right"));
  EXPECT_THAT(refusedEnd("[output]\nformats = 'stl'"), HasSubstr("formats must be a list, not a text"));
  EXPECT_THAT(refusedTool("type = 'flat'\ndiameter = 3\nholder = [[0, 1, 2]]"),
              HasSubstr("[height above gauge line, radius]"));
}

TEST(BadJob, ValuesOutOfRange) {
  for (const char* bad : {"0", "-3", "nan", "inf", "-inf", "1e300"}) {
    EXPECT_THAT(refused(replacedOnce(kSmallJob, "diameter = 10", std::string("diameter = ") + bad)),
                HasSubstr("diameter must be above 0 and at most 100000"))
        << bad;
  }
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "[0, 0, -20]", "[nan, 0, 0]")), HasSubstr("min: x must be"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "[0, 0, -20]", "[0, 0, 0]")),
              HasSubstr("max must be above min"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "number = 1", "number = 0")),
              HasSubstr("number must be from 1"));
  EXPECT_THAT(refusedEnd("[simulation]\nresolution = 0"), HasSubstr("resolution must be at least 0.001"));
  EXPECT_THAT(refusedEnd("[simulation]\nthreads = -1"), HasSubstr("threads must be from 0"));
  EXPECT_THAT(refusedEnd("[simulation]\nmax_blocks = 0"), HasSubstr("max_blocks must be from 1"));
  EXPECT_THAT(refusedEnd("[machine]\nrapid = 0"), HasSubstr("rapid must be above 0"));
  EXPECT_THAT(refusedEnd("[machine]\nrapid = [1, 0, 1]"), HasSubstr("rapid: y must be above 0"));
  EXPECT_THAT(refusedEnd("[machine]\nreference_points = [[0,0,0],[0,0,0],[0,0,0],[0,0,0],[0,0,0]]"),
              HasSubstr("at most four"));
  EXPECT_THAT(refusedEnd("[machine.limits]\nX = [5, 5]"), HasSubstr("the low limit must be below"));
  EXPECT_THAT(refusedEnd("[panel]\nblock_skip = [10]"), HasSubstr("from 1 to 9"));
  EXPECT_THAT(refusedEnd("[panel]\ninterrupt_blocks = [-1]"), HasSubstr("lists N numbers"));
  EXPECT_THAT(refusedEnd("[panel]\ninterrupt_blocks = 5"), HasSubstr("interrupt_blocks"));
  EXPECT_THAT(refusedEnd("[panel]\nanswers = { 99 = 1 }"), HasSubstr("boxes 100 to 299"));
  EXPECT_THAT(refusedEnd("[panel]\nanswers = { 200 = 4 }"), HasSubstr("200"));
  EXPECT_THAT(refusedEnd("[panel]\nplc_bits = [32]"), HasSubstr("from 0 to 31"));
  EXPECT_THAT(refusedEnd("[output]\nsize = [8, 600]"), HasSubstr("each from 16 to 8192"));
  EXPECT_THAT(refusedEnd("[output]\nviews = ['iso', 'iso']"), HasSubstr("listed twice"));
  EXPECT_THAT(refusedEnd("[output]\nviews = ['inside']"),
              HasSubstr("there is no view 'inside'; there are iso, top"));
  EXPECT_THAT(refusedEnd("[output]\nformats = ['stp']"),
              HasSubstr("there is no output format 'stp', did you mean 'stl'?"));
  EXPECT_THAT(refusedEnd("[output]\ndeviation = ['ply']"), HasSubstr("needs a [nominal]"));
  const std::string nominal = "[nominal]\nmesh = 'bracket.stl'\n[output]\n";
  EXPECT_THAT(refusedEnd(nominal + "deviation = ['glb', 'glb']"), HasSubstr("listed twice"));
  EXPECT_THAT(refusedEnd(nominal + "deviation = ['pli']"),
              HasSubstr("not written as 'pli', did you mean 'ply'?; there are ply, glb, csv"));
  EXPECT_THAT(refusedEnd(nominal + "deviation = true"), HasSubstr("deviation must be a list"));
  EXPECT_THAT(refused(withStock("shape = 'tube'\nbase = [0,0,0]\nradius = 3\ninner_radius = 3\nlength = 1")),
              HasSubstr("inner radius must be below"));
  EXPECT_THAT(refused(withStock("shape = 'cylinder'\nbase = [0,0,0]\nradius = 3\ndiameter = 6\nlength = 1")),
              HasSubstr("not both"));
  EXPECT_THAT(refusedTool("type = 'cone'\ndiameter = 3\ncone_angle = 180"), HasSubstr("cone_angle must be"));
  EXPECT_THAT(refusedEnd("[nominal]\nmesh = 'bracket.stl'\ngouge = -1"), HasSubstr("gouge must be above 0"));
  const std::string ignore = "[nominal]\nmesh = 'bracket.stl'\n[[nominal.ignore]]\n";
  EXPECT_THAT(refusedEnd(ignore + "z = [0, 1]"), HasSubstr("needs the key 'name'"));
  EXPECT_THAT(refusedEnd(ignore + "name = 'a'\nradius = [1, 2]"), HasSubstr("by min and max or by z"));
  EXPECT_THAT(refusedEnd(ignore + "name = 'a'\nz = [2, 1]"), HasSubstr("must be below the second"));
  EXPECT_THAT(refusedEnd(ignore + "name = 'a'\nz = [0, 1]\n[[nominal.ignore]]\nname = 'a'\nz = [2, 3]"),
              HasSubstr("two regions 'a'"));
  EXPECT_THAT(refusedEnd(ignore + "name = 'a'\nmin = [0, 0, 0]\nmax = [1, 0, 1]"),
              HasSubstr("every max must be above its min"));
}

TEST(BadJob, ToolsThatCannotBe) {
  EXPECT_THAT(refusedTool("type = 'bull'\ndiameter = 4\ncorner_radius = 3"),
              HasSubstr("error[job-tool]: tool 2: corner_radius is larger than the tool's radius"));
  EXPECT_THAT(refused(kSmallJob + "[[tool]]\nnumber = 1\ntype = 'flat'\ndiameter = 3\n"),
              HasSubstr("there are two tools with number 1"));
  EXPECT_THAT(
      refusedTool("type = 'dovetail'\ndiameter = 20\ndovetail_angle = 60\nheight = 8\nneck_diameter = 12"),
      HasSubstr("error[job-tool]: tool 2: neck_diameter must be at most 10.7624 mm"));
  EXPECT_THAT(
      refusedTool("type = 'taper'\nball_diameter = 1\ntip_diameter = 1\ntaper_angle = 3\ndiameter = 6"),
      HasSubstr("tip_diameter (a flat tip) or ball_diameter (a ball end), not both"));
}

TEST(BadJob, KeysOfOtherToolTypes) {
  EXPECT_THAT(
      refusedTool("type = 'tslot'\ndiameter = 20\nthickness = 5\nneck_diameter = 8\nflute_length = 5"),
      HasSubstr("18:1: error[job-unknown-key]: [[tool]] 2 has no key 'flute_length'"));
  EXPECT_THAT(refusedTool("type = 'flat'\ndiameter = 20\nneck_diameter = 8"),
              HasSubstr("[[tool]] 2 has no key 'neck_diameter'; did you mean 'shank_diameter'?"));
  EXPECT_THAT(refusedTool("type = 'form'\ndiameter = 8\nprofile = [[4, 0], [4, 8]]"),
              HasSubstr("[[tool]] 2 has no key 'diameter'"));
  EXPECT_THAT(refusedTool("type = 'thread-mill'\ndiameter = 8\npitch = 1\ncrest_falt = 0.1"),
              HasSubstr("has no key 'crest_falt'; did you mean 'crest_flat'?"));
  for (const char* key : {"dovetail_angle", "height", "neck_diameter"})
    EXPECT_THAT(refusedTool("type = 'dovetail'\ndiameter = 20"),
                HasSubstr("needs the key '" + std::string(key) + "'"));
  for (const char* key : {"thickness", "neck_diameter"})
    EXPECT_THAT(refusedTool("type = 'tslot'\ndiameter = 20"),
                HasSubstr("needs the key '" + std::string(key) + "'"));
  EXPECT_THAT(refusedTool("type = 'lollipop'\ndiameter = 20"), HasSubstr("needs the key 'neck_diameter'"));
  EXPECT_THAT(refusedTool("type = 'thread-mill'\ndiameter = 20"), HasSubstr("needs the key 'pitch'"));
  EXPECT_THAT(refusedTool("type = 'form'"), HasSubstr("needs the key 'profile'"));
}

TEST(BadJob, ProfilesOfForms) {
  const auto form = [](const std::string& profile) {
    return refusedTool("type = 'form'\nprofile = " + profile);
  };
  EXPECT_THAT(form("3"), HasSubstr("profile must be a list"));
  EXPECT_THAT(form("[]"), HasSubstr("the profile needs at least two points"));
  EXPECT_THAT(form("[[4, 0], 3]"),
              HasSubstr("15:20: error[job-type]: a point of a profile is [radius, height]"));
  EXPECT_THAT(form("[[4, 0], [3]]"), HasSubstr("a point of a profile is [radius, height]"));
  EXPECT_THAT(form("[[4, 0], [3, 1, 2, 3]]"), HasSubstr("a point of a profile is [radius, height]"));
  EXPECT_THAT(form("[[4, 0], [3, 'x']]"), HasSubstr("a height of the profile must be a number"));
  EXPECT_THAT(form("[[-4, 0], [3, 1]]"), HasSubstr("a radius of the profile must be at least 0"));
  EXPECT_THAT(form("[[4, 0], [3, nan]]"), HasSubstr("a height of the profile must be"));
  EXPECT_THAT(form("[[4, 0], [4, 8, 0]]"), HasSubstr("an arc's radius must not be 0"));
  EXPECT_THAT(form("[[4, 0], [4, 8], [3, 7]]"),
              HasSubstr("15:11: error[job-tool]: point 3 of the profile is lower than the one before"));
}

TEST(BadJob, Inserts) {
  const std::string corner =
      "type = 'insert'\norientation = 3\nnose_radius = 0.8\ninsert_angle = 80\nlead_angle = 95\nedge_length "
      "= "
      "12\n";
  EXPECT_EQ(refusedTool(corner), "accepted");
  for (const char* key : {"orientation", "nose_radius", "insert_angle", "lead_angle", "edge_length"})
    EXPECT_THAT(refusedTool("type = 'insert'"), HasSubstr("needs the key '" + std::string(key) + "'"));
  for (const char* key : {"orientation", "width", "edge_length"})
    EXPECT_THAT(refusedTool("type = 'insert'\nshape = 'groove'"),
                HasSubstr("needs the key '" + std::string(key) + "'"));
  for (const char* key : {"orientation", "insert_angle", "edge_length"})
    EXPECT_THAT(refusedTool("type = 'insert'\nshape = 'thread'"),
                HasSubstr("needs the key '" + std::string(key) + "'"));
  for (const char* key : {"orientation", "nose_radius"})
    EXPECT_THAT(refusedTool("type = 'insert'\nshape = 'round'"),
                HasSubstr("needs the key '" + std::string(key) + "'"));
  // Keys of other shapes and of tools that turn.
  for (const char* key :
       {"width", "side_relief", "tip_flat", "diameter", "overall_length", "gauge_length", "hand"})
    EXPECT_THAT(refusedTool(corner + key + " = 1"), HasSubstr("has no key '" + std::string(key) + "'"));
  EXPECT_THAT(
      refusedTool("type = 'insert'\nshape = 'round'\norientation = 3\nnose_radius = 3\nedge_length = 3"),
      HasSubstr("has no key 'edge_length'"));
  EXPECT_THAT(
      refusedTool("type = 'insert'\norientation = 8\nnose_radius = 0.8\ninsert_angle = 35\nlead_angle = "
                  "95\nedge_length = 12"),
      HasSubstr("has no key 'lead_angle'"));
  const std::string shape = refusedTool("type = 'insert'\nshape = 'grove'\nwidth = 3");
  EXPECT_THAT(shape, HasSubstr("shape 'grove' is not known, did you mean 'groove'?"));
  EXPECT_THAT(shape, Not(HasSubstr("unknown-key")));
  EXPECT_THAT(refusedTool("type = 'insert'\norientation = 10"), HasSubstr("orientation must be"));
  EXPECT_THAT(refusedTool(corner + "holder = [[0, 1], [2]]"),
              HasSubstr("a point of an insert's holder is [x, z]"));
  EXPECT_THAT(refusedTool(corner + "holder = [[0, 1], [2, 'x']]"),
              HasSubstr("a z of the holder must be a number"));
  EXPECT_THAT(refusedTool(corner + "holder = []"), HasSubstr("a holder needs at least three points"));
  EXPECT_THAT(refusedTool(corner + "holder = [[0, 0], [1, 1], [1, 0], [0, 1]]"),
              HasSubstr("error[job-tool]: tool 2: holder: the border meets itself"));
  EXPECT_THAT(refusedTool(replacedOnce(corner, "80", "85")),
              HasSubstr("error[job-tool]: tool 2: insert_angle must be above 0 and below 85 degrees"));
}

TEST(BadJob, ToolTypes) {
  EXPECT_THAT(refusedTool("type = 'wire'\ndiameter = 0.25\nnose_radius = 0.4"), HasSubstr("unknown-key"));
  EXPECT_THAT(refusedTool("type = 'wire'\ndiameter = 0.25\nspark_gap = -0.01"), HasSubstr("spark_gap"));
  EXPECT_THAT(refusedTool("type = 'bal'\ndiameter = 3"),
              HasSubstr("type 'bal' is not known, did you mean 'ball'?"));
}

TEST(BadJob, NamesThatAreNotKnown) {
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "\"nct\"", "\"fanuc\"")),
              HasSubstr("control 'fanuc' is not known; there are nct, flexnc"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "job/1", "job/2")),
              HasSubstr("schema 'proveout.job/2' is not known"));
  EXPECT_THAT(refused("units = 'cm'\n" + kSmallJob), HasSubstr("units 'cm' is not known"));
  EXPECT_THAT(refused("encoding = 'latin1'\n" + kSmallJob), HasSubstr("encoding 'latin1' is not known"));
}

TEST(BadJob, ControlTables) {
  const std::string head = replacedOnce(kSmallJob, "control = \"nct\"\n", "");
  JobFolder folder;
  folder.names.parameters["nct"] = {{"N1339", 0, 10}};
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'nct'\n[control.nct]\nN1338 = 1\n"),
              HasSubstr("control 'nct' has no parameter 'N1338'; did you mean 'N1339'?"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'nct'\n[control.nct]\nN1339 = 11\n"),
              HasSubstr("N1339 must be at least 0 and at most 10"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'nct'\n[control.nct]\nN1339 = 'x'\n"),
              HasSubstr("N1339 must be a number"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'nct'\n[control.flexnc]\nx = 1\n"),
              HasSubstr("[control] has no key 'flexnc'"));
  EXPECT_THAT(folder.refusal(head + "[control.nct]\nN1338 = 1\n"),
              HasSubstr("control 'nct' has no parameter 'N1338'"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'auto'\n[control.fanuc]\nx = 1\n"),
              HasSubstr("[control] has no key 'fanuc'"));
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'nct'\n[control.nct]\nN1.SEC = 1\n\"N1.SEC\" = 2\n"),
              HasSubstr("has no parameter"));
  folder.names.parameters.clear();
  EXPECT_THAT(folder.refusal(head + "[control]\nname = 'nct'\n[control.nct]\nN1.SEC = 1\n\"N1.SEC\" = 2\n"),
              HasSubstr("set twice"));
}

TEST(BadJob, FilesThatAreNotThere) {
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "bracket.nc", "braket.nc")),
              AllOf(HasSubstr("3:11: error[job-file]: program:"), HasSubstr("there is no such file")));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "\"bracket.nc\"", "\"\"")),
              HasSubstr("program must not be empty"));
  EXPECT_THAT(refused(replacedOnce(kSmallJob, "\"bracket.nc\"", "\".\"")), HasSubstr("is a folder"));
  EXPECT_THAT(refused("subprograms = ['bracket.nc', 'nowhere']\n" + kSmallJob),
              HasSubstr("an entry of subprograms:"));
  EXPECT_THAT(refusedEnd("[nominal]\nmesh = 'none.stl'"), HasSubstr("none.stl: there is no such file"));
  EXPECT_THAT(refusedEnd("[machine]\nfile = 'none.toml'"), HasSubstr("none.toml: there is no such file"));
  EXPECT_THAT(refused(withStock("shape = 'vdb'\nfile = 'none.vdb'")),
              HasSubstr("none.vdb: there is no such file"));
  Diagnostics diagnostics;
  EXPECT_FALSE(loadJob("/nowhere/job.toml", {}, diagnostics));
  EXPECT_THAT(formatDiagnostic(diagnostics.all().at(0)),
              HasSubstr("error[job-file]: /nowhere/job.toml: there is no such file"));
  EXPECT_FALSE(loadJob("/", {}, diagnostics));
}

TEST(BadJob, MachineFilesAreCheckedToo) {
  JobFolder folder;
  folder.write("m.toml", "rapid = 1\nfile = 'm.toml'\n");
  const std::string text = folder.refusal(kSmallJob + "[machine]\nfile = 'm.toml'\n");
  EXPECT_THAT(text, HasSubstr("m.toml:2:1: error[job-unknown-key]: the machine file has no key 'file'"));
}

TEST(BadJob, TablesWithoutAnEnd) {
  const auto dotted = [](std::size_t dots) {
    std::string key = "a";
    for (std::size_t i = 0; i < dots; ++i) key += ".a";
    return key;
  };
  // Each table takes stack where the document is read and freed; 200 kB of dots took more than there is.
  for (const std::size_t dots : {300u, 200'000u}) {
    EXPECT_THAT(refused(dotted(dots) + " = 1\n"),
                HasSubstr("job.toml:1:515: error[job-syntax]: a key with more"));
    EXPECT_THAT(refused("x = 1\n[ " + dotted(dots) + " ]\n"), HasSubstr("job.toml:2:517: error[job-syntax]"));
    EXPECT_THAT(refused("[[" + dotted(dots) + "]]\n"), HasSubstr("more than 256 dots"));
    EXPECT_THAT(refused("x = [1.5, {" + dotted(dots) + " = 1}]\n"), HasSubstr("more than 256 dots"));
  }
  std::string braces;
  for (int i = 0; i < 200; ++i) braces += "{" + dotted(200) + " = ";
  EXPECT_THAT(refused("x = " + braces), HasSubstr("more than 256 dots"));
}

TEST(BadJob, BrokenDocumentsDoNotEndTheProgram) {
  // Assertions of the TOML library.
  EXPECT_THAT(refused(kSmallJob + "[[ = 4\n"), HasSubstr("job.toml:12:4: error[job-syntax]"));
  EXPECT_THAT(refused(kSmallJob + "[ = 4\n"), HasSubstr("job.toml:12:3: error[job-syntax]"));
  // Points of it that are never reached, it says: among them are e acute, all Cyrillic letters and U+FEE7.
  for (const std::string letter : {"\u00e9", "\u0431", "\u3001", "\ufee7", "\U0001f600", "\xff"}) {
    const std::string said = "job.toml:12:3: error[job-syntax]: a character that is not ASCII";
    EXPECT_THAT(refused(kSmallJob + "ab" + letter + " = 1\n"), HasSubstr(said)) << letter;
    EXPECT_THAT(refused(kSmallJob + "x=" + letter + "\n"), HasSubstr(said)) << letter;
    EXPECT_THAT(refused(kSmallJob + "x=99\"" + letter + "''\n"), HasSubstr("a character that is not ASCII"))
        << letter;
    EXPECT_THAT(refused(kSmallJob + "x=\"a\"'" + letter + "'\n"), HasSubstr("a character that is not ASCII"))
        << letter;
    EXPECT_THAT(refused(kSmallJob + "[a" + letter + "]\n"), HasSubstr(said)) << letter;
    EXPECT_THAT(refused(kSmallJob + "{ " + letter), HasSubstr(said)) << letter;
  }
}

TEST(BadJob, LettersBehindABackslashDoNotEndTheProgram) {
  for (const std::string letter : {"\u00e9", "\u0431", "\u3001", "\ufeef", "\U0001f600"})
    EXPECT_THAT(refused(kSmallJob + "x = \"\"\"\nMov\\" + letter + "\n\"\"\"\n"),
                HasSubstr("error[job-syntax]"))
        << letter;
}

TEST(BadJob, TextsAndCommentsHoldAnyLetters) {
  for (const std::string line : {"name = '\u0431\u00e9'", "name = \"\u0431\"  # \u00e9", "# \ufee7",
                                 "name = \"\"\"\n\u0431\n\"\"\"", "\ufeff"}) {
    JobFolder folder;
    EXPECT_TRUE(folder.load(line + "\n" + kSmallJob).has_value()) << folder.text();
  }
}

TEST(BadJob, DotsThatAreNoTables) {
  std::string numbers, text(1000, '.');
  for (int i = 0; i < 400; ++i) numbers += "[0.5, 1.5],\n";
  // A text of several lines may end with quotes of its own.
  for (const std::string& line : {"name = '" + text + "'", "name = \"\\\"" + text + "\"",
                                  "name = \"\"\"\n" + text + "\n\"\"\"\"\"", "name = '''a''''  # " + text}) {
    JobFolder folder;
    EXPECT_TRUE(folder.load(line + "\n" + kSmallJob).has_value()) << folder.text();
  }
  EXPECT_THAT(refusedEnd("[x]\ny = [\n" + numbers + "]"), HasSubstr("has no key 'x'"));
  EXPECT_THAT(refusedEnd("[x]\nz = ['''a'''']\ny = [\n" + numbers + "]"), HasSubstr("has no key 'x'"));
}

TEST(BadJob, Syntax) {
  EXPECT_THAT(refused(kSmallJob + "x = = 1\n"),
              AllOf(HasSubstr("job.toml:12:5: error[job-syntax]:"), HasSubstr("    x = = 1\n        ^")));
  EXPECT_THAT(refused(kSmallJob + "diameter = 10\n"), HasSubstr("error[job-syntax]"));
  EXPECT_THAT(refused("name = \"\xff\"\n" + kSmallJob), HasSubstr("error[job-syntax]"));
  EXPECT_THAT(refused("name = \"open\n"), HasSubstr("error[job-syntax]"));
  EXPECT_THAT(refused("x = " + std::string(100000, '[')), HasSubstr("error[job-syntax]"));
  EXPECT_THAT(refused(std::string("\0\0\0", 3)), HasSubstr("error[job-syntax]"));
  // Columns count bytes, so that the caret stands under the place whatever stands before it.
  EXPECT_THAT(refused("name = \"\xc3\xa9\xc3\xa9\" @\n"), HasSubstr("job.toml:1:15: error[job-syntax]"));
}

TEST(BadJob, AllErrorsAreReportedAtOnce) {
  JobFolder folder;
  folder.refusal(
      replacedOnce(replacedOnce(kSmallJob, "diameter = 10", "diameter = -1"), "bracket.nc", "none.nc") +
      "[simulation]\nresolution = -1\nthreads = 'all'\n");
  EXPECT_EQ(folder.diagnostics.errorCount(), 4) << folder.text();
}

std::string listOf(std::size_t count, const std::string& item) {
  std::string list = item;
  for (std::size_t i = 1; i < count; ++i) list += ", " + item;
  return "[" + list + "]";
}

TEST(BadJob, ListsAreCountedFirst) {
  EXPECT_THAT(refusedEnd("[output]\nsections = " + listOf(80'000, "-1.5")),
              HasSubstr("sections has 80000 entries, 100 are allowed"));
  EXPECT_THAT(refusedTool("type = 'flat'\ndiameter = 6\nholder = " + listOf(20'000, "[1, 10]")),
              HasSubstr("holder has 20000 entries, 1000 are allowed"));
  EXPECT_THAT(refusedTool("type = 'form'\nprofile = " + listOf(20'000, "[1, 10]")),
              HasSubstr("profile has 20000 entries, 1000 are allowed"));
  std::string tools;
  for (int k = 2; k < 20'000; ++k)
    tools += "[[tool]]\nnumber = " + std::to_string(k) + "\ntype = 'flat'\ndiameter = 6\n";
  EXPECT_THAT(refusedEnd(tools), HasSubstr("tool has 19999 entries, 10000 are allowed"));
  EXPECT_THAT(refusedEnd("x = " + listOf(600'000, "1")), HasSubstr("more than 500000 lines and values"));
  EXPECT_THAT(refused(kSmallJob + std::string(600'000, '\n')), HasSubstr("more than 500000 lines"));
}

TEST(BadJob, SoManyToolsAreRead) {
  std::string tools;
  for (int k = 2; k <= 10'000; ++k)
    tools += "[[tool]]\nnumber = " + std::to_string(k) + "\ntype = 'flat'\ndiameter = 6\n";
  JobFolder folder;
  const auto job = folder.load(kSmallJob + tools);
  ASSERT_TRUE(job) << folder.text();
  EXPECT_EQ(job->tools.size(), 10'000u);
  EXPECT_THAT(refusedEnd(tools + "[[tool]]\nnumber = 7\n"), HasSubstr("entries, 10000 are allowed"));
  EXPECT_THAT(refusedTool("type = 'flat'\ndiameter = 6\n[[tool]]\nnumber = 2\ntype = 'flat'\ndiameter = 1"),
              HasSubstr("there are two tools with number 2"));
}

TEST(BadJob, PlacesOnALongLine) {
  // Letters of two bytes in front: columns are bytes.
  std::string text = "name = 'жжж'\n" + kSmallJob + "[output]\nsections = [ # ж\n 1.5, ";
  for (int k = 0; k < 80; ++k) text += "'ж', ";
  JobFolder folder;
  EXPECT_THAT(folder.refusal(text + "]\n"), HasSubstr("sections must be a list of heights"));
  EXPECT_THAT(refusedEnd("[output]\nviews = ['iso', \"жж\", 'left'] # x"),
              HasSubstr("there is no view 'жж'"));
  EXPECT_THAT(refused("x = { ж = 1 }\n" + kSmallJob), HasSubstr(":1:7:"));
  EXPECT_THAT(refused("'жж' = 1\n" + kSmallJob), HasSubstr(":1:1: error[job-unknown-key]"));
}

TEST(BadJob, ErrorsAreBoundedInNumberAndLength) {
  std::string many;
  for (int k = 0; k < 5'000; ++k) many += "zzkey" + std::to_string(k) + " = 1\n";
  const std::string told = refused(many + kSmallJob);
  EXPECT_THAT(told, AllOf(HasSubstr("'zzkey19'"), Not(HasSubstr("'zzkey20'")),
                          HasSubstr("there are more than 20 errors; the others are not told")));
  EXPECT_LT(told.size(), 15'000u);
  const std::string word(300'000, 'z');
  for (const std::string& text :
       {word + " = 1\n" + kSmallJob, kSmallJob + "[output]\nviews = ['" + word + "']\n",
        kSmallJob + "[simulation]\n" + word + " = 1\n", "units = '" + word + "'\n" + kSmallJob,
        kSmallJob + "[offsets.work]\n" + word + " = 1\n", "control = '" + word + "'\n"}) {
    const std::string one = refused(text);
    EXPECT_THAT(one, Not(HasSubstr(std::string(200, 'z')))) << text.substr(0, 40);
    EXPECT_LT(one.size(), 3'000u) << text.substr(0, 40);
  }
}

}  // namespace
}  // namespace proveout
