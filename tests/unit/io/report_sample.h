// A report with something in every field.
#pragma once

#include <cmath>

#include "io/report.h"

namespace proveout::io_test {

/// Features of a CAD model: a hole as it was machined, and one that is missing.
inline std::vector<ReportFeature> sampleFeatures() {
  ReportCharacteristic diameter, position;
  diameter.name = "diameter";
  diameter.label = "seat <H7>";
  diameter.nominal = 8.0;
  diameter.measured = 8.02;
  diameter.lower = 0.0;
  diameter.upper = 0.015;
  diameter.tolerance = "job";
  diameter.verdict = "fail";
  position.name = "position";
  position.measured = 0.01;
  position.upper = 0.04;
  position.tolerance = "surface";
  position.verdict = "pass";
  return {{"F1", "hole", "hole of diameter 8 at X20.000 Y5.000", Vec3(20, 5, 0), false, {diameter, position}},
          {"F2", "slot", "<slot>", Vec3(1, 2, 3), true, {}}};
}

inline ReportAlignment sampleAlignment() {
  ReportAlignment out;
  out.kind = "fit";
  out.matrix = {{{1, 0, 0, 0.25}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  out.rms_mm = 0.0201;
  out.moved_mm = 0.25;
  out.points = 12345;
  out.left_out = 32;
  out.free_directions = 1;
  return out;
}

inline ReportScan sampleScan() { return {"<scan>.ply", false, 98765, 12, 0.6219, 0.375}; }

inline Report sampleReport() {
  Report r;
  r.name = "bracket <A&B>";
  r.version = "0.1.0";
  r.checks = {true, true, true, true, true, true};
  r.program = {"nct", {"bracket.nc", "O0100.nc"}, 1204, 15159, ""};
  r.time = {431.24,
            380.5,
            40.74,
            {{1, "ball nose", "ball 3.175", 300.5, 30.74, 39730.12, 14000},
             {2, "", "flat 10", 80, 10, 5892.7, 1159}}};
  ReportAccounting accounting;
  accounting.total = {380.5, 40.74, 10, 22.5, 9000, 358, 4000, 45622.82};
  accounting.per_tool = {{1, {300.5, 30.74, 5, 20, 7000, 280.5, 4000, 39730.12}}, {2, {80, 10, 5, 80, 2000}}};
  accounting.rate = {0.5, false, {0, 120, 40}, {0, 200, 80}, {{0, 0.9, "T1"}, {0.9, 1.5, "<T2>"}}};
  r.accounting = accounting;
  ReportStock stock;
  stock.initial_mm3 = 128000;
  stock.removed_mm3 = 45622.82;
  stock.final_mm3 = 82377.18;
  stock.mesh_mm3 = 82377.91;
  stock.bodies = {{82377.18, {Vec3(0, 0, -20), Vec3(80, 80, 0)}, "part"}};
  stock.triangles = 245812;
  stock.vertices = 122908;
  stock.closed = true;
  r.stock = stock;
  r.resolution_mm = 0.25;
  Finding gouge(FindingKind::kGouge);
  gouge.where = Vec3(20.125, 31.5, -5.25);
  gouge.depth_mm = 0.25;
  gouge.area_mm2 = 30.5;
  gouge.volume_mm3 = 4.125;
  gouge.source = BlockRef{"O0100.nc", 12, 70, 1, "N70 G1 X20.5 Y31.5 (\"too\" deep <!>)"};
  gouge.motion = 815;
  gouge.tool = 1;
  gouge.message = "0.250 mm below nominal over 30.5 mm2";
  Finding rapid(FindingKind::kRapidContact);
  rapid.where = Vec3(1, 2, -0.0);
  rapid.depth_mm = 1.5;
  rapid.source = BlockRef{"bracket.nc", 40, -1, 0, "G0 Z-1.5"};
  rapid.tool = 2;
  rapid.message = "tool 2 touches stock in rapid";
  Finding note(FindingKind::kSpindleOff);
  note.severity = Severity::kWarning;
  note.message = "cut without spindle";
  r.findings = {gouge, rapid, note};
  ReportComparison c;
  c.nominal = "bracket.stl";
  c.gouge_tolerance_mm = 0.02;
  c.excess_tolerance_mm = 0.05;
  c.max_gouge_mm = 0.25;
  c.max_excess_mm = 0.031;
  c.rms_mm = 0.0123;
  c.p95_mm = 0.018;
  for (int i = 0; i <= 60; ++i) c.histogram_edges_mm.push_back(-0.3 + 0.01 * i);
  for (int i = 0; i < 60; ++i) {
    const double x = c.histogram_edges_mm[i] + 0.005;
    c.histogram_area_mm2.push_back(i < 5 ? 0.0 : 9000 * std::exp(-x * x / 0.0004) + (x < -0.15 ? 6.0 : 0.0));
  }
  r.comparison = c;
  r.error_budget = {{"grid", 0.0012,
                     "Crossings are exact; facets between them leave a wall of radius 1.6 mm by up to this."},
                    {"tool", 0.0, "Tools are exact solids of revolution."},
                    {"arcs", 0.0, "Arcs are cut as arcs."},
                    {"nominal", std::nullopt, "The job does not say how the nominal was tessellated."}};
  Diagnostic d;
  d.severity = Severity::kWarning;
  d.code = "nct-1001";
  d.message = "no reference point given; the start position stands for it";
  d.where = {"bracket.nc", 3, 5, 8};
  d.source_line = "N30 G28 Z0";
  d.notes = {"called from nowhere"};
  r.diagnostics = {d};
  r.inputs = {{"program", "bracket.nc", 33012, std::string(64, 'a')},
              {"nominal", "bracket.stl", 125084, std::string(64, 'b')}};
  r.part_sha256 = std::string(64, 'c');
  r.outputs = {{{"part.stl", "stl", std::string(64, 'd')}}, {{"iso.png", "iso"}}, {}, "report.html"};
  r.performance = {3.25, 0.1, 1.2, 0.8, 0.9, 0.25, 0.15, 412.0, 380.0, 3.5, 2};
  r.verdict = verdictOf(r);
  return r;
}

}  // namespace proveout::io_test
