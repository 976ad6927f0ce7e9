// report.json: the report as data. Keys keep the order in which they are set.
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/printable.h"
#include "io/report.h"

namespace proveout {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinities, and a figure that is not known is null. -0 is written as 0.
Json number(double x) {
  if (!std::isfinite(x)) return nullptr;
  return x + 0.0;
}
Json number(const std::optional<double>& x) { return x ? number(*x) : Json(nullptr); }

Json pointJson(const Vec3& p) { return {{"x", number(p.x())}, {"y", number(p.y())}, {"z", number(p.z())}}; }

Json sourceJson(const BlockRef& source) {
  Json out = {{"file", source.file}, {"line", source.line}};
  if (source.block >= 0) out["block"] = "N" + std::to_string(source.block);
  out["depth"] = source.depth;
  if (!source.text.empty()) out["text"] = source.text;
  return out;
}

Json causeJson(const Cause& c) {
  Json out = {{"what", c.what}, {"value", c.value}};
  if (c.source) out["source"] = sourceJson(*c.source);
  if (c.column > 0) out["column"] = c.column;
  if (c.incremental) out["incremental"] = true;
  if (!c.from.empty()) {
    out["from"] = Json::array();
    for (const BlockRef& from : c.from) out["from"].push_back(sourceJson(from));
  }
  if (!c.along.empty()) out["along"] = c.along;
  if (c.off_mm) out["off_mm"] = number(*c.off_mm);
  if (!c.along.empty()) out["explains"] = number(c.explains);
  if (c.left_mm) {
    out["with"] = c.with;
    out["left_mm"] = number(*c.left_mm);
  }
  return out;
}

Json blockShareJson(const BlockShare& b) {
  Json out = sourceJson(b.block);
  if (!b.setup.empty()) out["setup"] = b.setup;
  if (b.tool) out["tool"] = *b.tool;
  out["share"] = number(b.share);
  return out;
}

Json findingJson(const Finding& f) {
  Json out = {{"kind", findingKindName(f.kind)}, {"severity", severityName(f.severity)}};
  if (f.where) out["where"] = pointJson(*f.where);
  if (f.depth_mm) out["depth_mm"] = number(*f.depth_mm);
  if (f.bound_mm) out["bound_mm"] = number(*f.bound_mm);
  if (f.area_mm2) out["area_mm2"] = number(*f.area_mm2);
  if (f.volume_mm3) out["volume_mm3"] = number(*f.volume_mm3);
  if (f.source) out["source"] = sourceJson(*f.source);
  if (f.last_source) out["last_source"] = sourceJson(*f.last_source);
  if (f.inside) out["inside"] = sourceJson(*f.inside);
  if (f.motion) out["motion"] = *f.motion;
  if (f.tool) out["tool"] = *f.tool;
  if (!f.setup.empty()) out["setup"] = f.setup;
  if (f.spots > 1) out["spots"] = f.spots;
  if (f.known) out["known"] = true;
  if (!f.worse.empty()) out["worse"] = f.worse;
  if (!f.feature.empty()) out["feature"] = f.feature;
  out["message"] = f.message;
  if (!f.blocks.empty()) {
    out["blocks"] = Json::array();
    for (const BlockShare& block : f.blocks) out["blocks"].push_back(blockShareJson(block));
  }
  if (!f.causes.empty()) {
    out["causes"] = Json::array();
    for (const Cause& cause : f.causes) out["causes"].push_back(causeJson(cause));
  }
  if (f.untried_causes > 0) out["untried_causes"] = f.untried_causes;
  return out;
}

Json knownJson(const KnownFinding& f) {
  Json out = {{"kind", findingKindName(f.kind)}, {"severity", severityName(f.severity)}};
  if (f.where) out["where"] = pointJson(*f.where);
  if (f.depth_mm) out["depth_mm"] = number(*f.depth_mm);
  if (f.area_mm2) out["area_mm2"] = number(*f.area_mm2);
  if (f.volume_mm3) out["volume_mm3"] = number(*f.volume_mm3);
  if (!f.file.empty()) out["source"] = {{"file", f.file}, {"line", f.line}, {"text", f.block}};
  if (!f.setup.empty()) out["setup"] = f.setup;
  out["message"] = f.message;
  return out;
}

Json acceptanceJson(const ReportAcceptance& a) {
  const auto names = [](const std::vector<FindingKind>& kinds) {
    Json out = Json::array();
    for (const FindingKind kind : kinds) out.push_back(findingKindName(kind));
    return out;
  };
  Json severities = Json::object(), left_out = Json::array(), baseline = nullptr;
  for (const auto& [kind, severity] : a.severities)
    severities[std::string(findingKindName(kind))] = severity ? severityName(*severity) : "off";
  for (const LeftOut& out : a.left_out)
    left_out.push_back({{"kind", findingKindName(out.kind)}, {"count", out.count}, {"by", out.by}});
  if (a.baseline) {
    baseline = {{"file", a.baseline->file}, {"sha256", a.baseline->sha256}, {"known", a.baseline->known}};
    baseline["gone"] = a.baseline->looked_for_all ? Json::array() : Json(nullptr);
    for (const KnownFinding& gone : a.baseline->gone) baseline["gone"].push_back(knownJson(gone));
  }
  return {{"severities", std::move(severities)},
          {"select", names(a.filter.select)},
          {"ignore", names(a.filter.ignore)},
          {"left_out", std::move(left_out)},
          {"baseline", std::move(baseline)}};
}

Json setupsJson(const std::vector<ReportSetup>& setups) {
  Json out = Json::array();
  for (const ReportSetup& setup : setups) {
    out.push_back({{"name", setup.name},
                   {"program", setup.program},
                   {"blocks", setup.blocks},
                   {"motions", setup.motions},
                   {"cycle_s", number(setup.cycle_s)},
                   {"removed_mm3", number(setup.removed_mm3)},
                   {"final_mm3", number(setup.final_mm3)}});
    if (!setup.control.empty()) out.back()["control"] = setup.control;
  }
  return out;
}

Json timeJson(const ReportTime& time) {
  Json tools = Json::array();
  for (const ToolUse& use : time.per_tool) {
    tools.push_back({{"tool", use.number},
                     {"name", use.name},
                     {"description", use.description},
                     {"cutting_s", number(use.cutting_s)},
                     {"rapid_s", number(use.rapid_s)},
                     {"removed_mm3", number(use.removed_mm3)},
                     {"motions", use.motions}});
  }
  return {{"cycle_s", number(time.cycle_s)},
          {"cutting_s", number(time.cutting_s)},
          {"rapid_s", number(time.rapid_s)},
          {"per_tool", std::move(tools)}};
}

Json figuresJson(const CutFigures& f) {
  return {{"time_s", number(f.time_s())},
          {"feed_s", number(f.feed_s)},
          {"rapid_s", number(f.rapid_s)},
          {"other_s", number(f.other_s)},
          {"air_s", number(f.air_s)},
          {"length_mm", number(f.length_mm)},
          {"engaged_s", number(f.engaged_s)},
          {"engaged_mm", number(f.engaged_mm)},
          {"removed_mm3", number(f.removed_mm3)},
          {"engagement_mm2", number(f.engagement_mm2())},
          {"rate_mm3_min", number(f.rate_mm3_min())},
          {"area_rate_mm2_min", number(f.area_mm2_min())}};
}

Json accountingJson(const ReportAccounting& accounting) {
  Json tools = Json::array();
  for (const ToolFigures& tool : accounting.per_tool) {
    Json entry = {{"tool", tool.tool}};
    entry.update(figuresJson(tool.figures));
    tools.push_back(std::move(entry));
  }
  return {{"total", figuresJson(accounting.total)}, {"per_tool", std::move(tools)}};
}

Json stockJson(const ReportStock& stock) {
  Json bodies = Json::array();
  for (const StockBody& body : stock.bodies) {
    const Json bounds = {{"min", pointJson(body.bounds.min)}, {"max", pointJson(body.bounds.max)}};
    bodies.push_back({{"volume_mm3", number(body.volume_mm3)}, {"bounds", bounds}, {"role", body.role}});
    if (!body.leaves.empty()) bodies.back()["leaves"] = body.leaves;
  }
  return {{"initial_mm3", number(stock.initial_mm3)},
          {"removed_mm3", number(stock.removed_mm3)},
          {"final_mm3", number(stock.final_mm3)},
          {"error_mm3", number(stock.error_mm3)},
          {"initial_error_mm3", number(stock.initial_error_mm3)},
          {"error_is", stock.exact ? "exact" : "estimate"},
          {"mesh_mm3", number(stock.mesh_mm3)},
          {"mesh_bodies", stock.mesh_bodies},
          {"triangles", stock.triangles},
          {"vertices", stock.vertices},
          {"closed", stock.closed},
          {"bodies", std::move(bodies)}};
}

Json numbersJson(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double x : values) out.push_back(number(x));
  return out;
}

/// Values of lengths end on _mm; of others the unit says what they are.
Json characteristicJson(const ReportCharacteristic& c) {
  Json out = {{"name", c.name}};
  if (!c.part.empty()) out["part"] = c.part;
  if (!c.label.empty()) out["label"] = c.label;
  out["unit"] = c.unit;
  out["nominal"] = number(c.nominal);
  out["measured"] = number(c.measured);
  out["deviation"] = c.measured ? number(*c.measured - c.nominal) : Json();
  if (c.lower) out["lower"] = number(*c.lower);
  if (c.upper) out["upper"] = number(*c.upper);
  if (!c.tolerance.empty()) out["tolerance"] = c.tolerance;
  if (!c.verdict.empty()) out["verdict"] = c.verdict;
  return out;
}

/// Of the part as a whole: limits are values.
Json partCharacteristicsJson(const std::vector<ReportCharacteristic>& characteristics) {
  Json out = Json::array();
  for (const ReportCharacteristic& c : characteristics) {
    Json row = {{"name", c.name}};
    if (!c.label.empty()) row["label"] = c.label;
    row["unit"] = c.unit;
    row["measured"] = number(c.measured);
    if (c.where) row["at"] = numbersJson({c.where->x(), c.where->y(), c.where->z()});
    if (c.lower) row["least"] = number(*c.lower);
    if (c.upper) row["most"] = number(*c.upper);
    row["verdict"] = c.verdict;
    out.push_back(std::move(row));
  }
  return out;
}

Json featuresJson(const std::vector<ReportFeature>& features) {
  Json out = Json::array();
  for (const ReportFeature& feature : features) {
    Json rows = Json::array();
    for (const ReportCharacteristic& c : feature.characteristics) rows.push_back(characteristicJson(c));
    out.push_back({{"id", feature.id},
                   {"kind", feature.kind},
                   {"feature", feature.feature},
                   {"at", numbersJson({feature.at.x(), feature.at.y(), feature.at.z()})},
                   {"missing", feature.missing},
                   {"characteristics", rows}});
    if (feature.residual_mm) out.back()["residual_mm"] = number(*feature.residual_mm);
  }
  return out;
}

Json alignmentJson(const ReportAlignment& a) {
  Json matrix = Json::array();
  for (const auto& row : a.matrix) matrix.push_back(numbersJson({row.begin(), row.end()}));
  return {{"kind", a.kind},
          {"matrix", matrix},
          {"rms_mm", number(a.rms_mm)},
          {"moved_mm", number(a.moved_mm)},
          {"turned_deg", number(a.turned_deg)},
          {"points", a.points},
          {"left_out", a.left_out},
          {"free_directions", a.free_directions}};
}

Json scanJson(const ReportScan& s) {
  return {{"file", s.file}, {"kind", s.mesh ? "mesh" : "points"}, {"points", s.points},
          {"off", s.off},   {"coverage", number(s.coverage)},     {"reach_mm", number(s.reach_mm)}};
}

Json comparisonJson(const ReportComparison& c) {
  Json out = {{"nominal", c.nominal},
              {"nominal_unit", c.nominal_unit},
              {"gouge_tolerance_mm", number(c.gouge_tolerance_mm)},
              {"excess_tolerance_mm", number(c.excess_tolerance_mm)},
              {"max_gouge_mm", number(c.max_gouge_mm)},
              {"max_excess_mm", number(c.max_excess_mm)},
              {"rms_mm", number(c.rms_mm)},
              {"p95_mm", number(c.p95_mm)},
              {"decided", c.decided},
              {"deciding_resolution_mm", number(c.deciding_resolution_mm)}};
  if (!c.placement.none()) {
    const auto three = [](const Vec3& v) { return numbersJson({v.x(), v.y(), v.z()}); };
    out["placement"] = {{"scale", number(c.placement.scale)},
                        {"rotate", three(c.placement.rotate_deg)},
                        {"move", three(c.placement.move)}};
  }
  if (c.alignment) out["alignment"] = alignmentJson(*c.alignment);
  if (c.scan) out["scan"] = scanJson(*c.scan);
  out["histogram"] = {{"edges_mm", numbersJson(c.histogram_edges_mm)},
                      {"area_mm2", numbersJson(c.histogram_area_mm2)}};
  if (!c.features.empty()) {
    out["features"] = featuresJson(c.features);
    out["features_found"] = c.features_found;
  }
  return out;
}

Json errorBudgetJson(const std::vector<ErrorTerm>& terms) {
  Json out = Json::array();
  for (const ErrorTerm& term : terms) {
    out.push_back(
        {{"source", term.source}, {"bound_mm", number(term.bound_mm)}, {"statement", term.statement}});
  }
  return out;
}

Json diagnosticsJson(const std::vector<Diagnostic>& diagnostics) {
  Json out = Json::array();
  for (const Diagnostic& d : diagnostics) {
    Json entry = {{"severity", severityName(d.severity)}, {"code", d.code}, {"message", d.message}};
    if (!d.where.file.empty() || d.where.line > 0) {
      entry["source"] = {{"file", d.where.file}, {"line", d.where.line}, {"column", d.where.column}};
      if (d.where.column_end > 0) entry["source"]["column_end"] = d.where.column_end;
      if (!d.source_line.empty()) entry["source"]["text"] = d.source_line;
    }
    if (!d.notes.empty()) entry["notes"] = d.notes;
    out.push_back(std::move(entry));
  }
  return out;
}

Json hashesJson(const Report& report) {
  Json inputs = Json::array();
  for (const FileHash& file : report.inputs) {
    inputs.push_back(
        {{"role", file.role}, {"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  }
  Json part = report.part_sha256.empty() ? Json(nullptr) : Json(report.part_sha256);
  return {{"inputs", std::move(inputs)}, {"part_sha256", std::move(part)}};
}

Json outputsJson(const ReportOutputs& outputs) {
  Json meshes = Json::array(), images = Json::array(), data = Json::array();
  for (const ReportMesh& mesh : outputs.meshes) {
    meshes.push_back({{"path", mesh.path}, {"format", mesh.format}, {"sha256", mesh.sha256}});
  }
  for (const ReportImage& image : outputs.images) {
    images.push_back({{"path", image.path}, {"title", image.title}});
  }
  for (const ReportData& file : outputs.data)
    data.push_back({{"path", file.path}, {"what", file.what}, {"sha256", file.sha256}});
  return {{"meshes", std::move(meshes)},
          {"images", std::move(images)},
          {"tables", outputs.tables},
          {"data", std::move(data)},
          {"html", outputs.html}};
}

Json performanceJson(const ReportPerformance& p) {
  return {{"wall_s", number(p.wall_s)},
          {"interpret_s", number(p.interpret_s)},
          {"remove_s", number(p.remove_s)},
          {"mesh_s", number(p.mesh_s)},
          {"read_s", number(p.read_s)},
          {"compare_s", number(p.compare_s)},
          {"render_s", number(p.render_s)},
          {"peak_memory_mb", number(p.peak_memory_mb)},
          {"predicted_memory_mb", p.predicted_memory_mb > 0 ? number(p.predicted_memory_mb) : Json(nullptr)},
          {"predicted_s", p.predicted_s > 0 ? number(p.predicted_s) : Json(nullptr)},
          {"threads", p.threads}};
}

Json checksJson(const ReportChecks& checks) {
  return {{"interpreted", checks.interpreted}, {"removal", checks.removal},
          {"comparison", checks.comparison},   {"travel_limits", checks.travel_limits},
          {"fixtures", checks.fixtures},       {"mesh", checks.mesh}};
}

}  // namespace

std::string reportJson(const Report& report, const ReportOptions& options) {
  Json out;
  out["schema"] = "proveout.report/1";
  out["version"] = report.version;
  out["name"] = report.name;
  out["verdict"] = verdictName(report.verdict);
  for (const ReportHeadLine& line : report.head) out["head"][line.key] = line.text;
  out["checks"] = checksJson(report.checks);
  out["program"] = {{"control", report.program.control},
                    {"files", report.program.files},
                    {"blocks", report.program.blocks},
                    {"motions", report.program.motions},
                    {"until", report.program.until.empty() ? Json(nullptr) : Json(report.program.until)}};
  out["setups"] = setupsJson(report.setups);
  out["time"] = timeJson(report.time);
  out["accounting"] = report.accounting ? accountingJson(*report.accounting) : Json(nullptr);
  out["stock"] = report.stock ? stockJson(*report.stock) : Json(nullptr);
  out["resolution_mm"] = report.resolution_mm > 0.0 ? number(report.resolution_mm) : Json(nullptr);
  out["findings"] = Json::array();
  for (const Finding& finding : report.findings) out["findings"].push_back(findingJson(finding));
  if (!report.acceptance.none()) out["acceptance"] = acceptanceJson(report.acceptance);
  out["comparison"] = report.comparison ? comparisonJson(*report.comparison) : Json(nullptr);
  if (!report.part_characteristics.empty())
    out["part_characteristics"] = partCharacteristicsJson(report.part_characteristics);
  out["error_budget"] = errorBudgetJson(report.error_budget);
  out["diagnostics"] = diagnosticsJson(report.diagnostics);
  if (!report.command.empty()) out["command"] = report.command;
  out["hashes"] = hashesJson(report);
  out["outputs"] = outputsJson(report.outputs);
  if (options.with_performance) out["performance"] = performanceJson(report.performance);
  // A program's text may be in any encoding; bytes that are not UTF-8 become U+FFFD instead of an exception.
  return jsonPrintable(out.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace proveout
