// What job files and the command line share: names of formats, the blank in one word, and its file.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/atomic_file.h"
#include "io/job/job.h"

namespace proveout {

namespace {

struct FormatName {
  OutputFormat format;
  std::string_view name, extension;
};
constexpr FormatName kFormats[] = {
    {OutputFormat::kStl, "stl", "stl"},     {OutputFormat::kStlAscii, "stl-ascii", "stl"},
    {OutputFormat::kObj, "obj", "obj"},     {OutputFormat::kPly, "ply", "ply"},
    {OutputFormat::kThreeMf, "3mf", "3mf"}, {OutputFormat::kGlb, "glb", "glb"},
    {OutputFormat::kVdb, "vdb", "vdb"}};

struct DeviationName {
  DeviationOutput output;
  std::string_view name;
};
constexpr DeviationName kDeviations[] = {
    {DeviationOutput::kPly, "ply"}, {DeviationOutput::kGlb, "glb"}, {DeviationOutput::kCsv, "csv"}};

constexpr double kMaxLength = 1e6;  // mm, as in job files

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> length(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(value) || std::abs(value) > kMaxLength) return std::nullopt;
  return value;
}

std::optional<double> positive(std::string_view text) {
  const auto value = length(text);
  return value && *value > 0.0 ? value : std::nullopt;
}

std::optional<Vec3> point(std::string_view text) {
  const auto parts = split(text, ',');
  if (parts.size() != 3) return std::nullopt;
  Vec3 out;
  for (int i = 0; i < 3; ++i) {
    const auto value = length(parts[i]);
    if (!value) return std::nullopt;
    out[i] = *value;
  }
  return out;
}

Result<StockSpec> boxOption(const std::vector<std::string_view>& parts) {
  const Error usage = inputError("a box is given as box:x0,y0,z0:x1,y1,z1 (mm)");
  if (parts.size() != 3) return usage;
  const auto min = point(parts[1]), max = point(parts[2]);
  if (!min || !max) return usage;
  if ((min->array() >= max->array()).any()) {
    return inputError("the box's second corner must be above its first in x, y and z");
  }
  return StockSpec(BoxShape{*min, *max});
}

/// Parts behind the word: base, diameter, (inner diameter,) length, (axis).
Result<StockSpec> cylinderOption(const std::vector<std::string_view>& parts, bool tube) {
  const Error usage = inputError(
      tube ? "a tube is given as tube:x,y,z:DIAMETER:INNER:LENGTH or with :x, :y or :z for its axis (mm)"
           : "a cylinder is given as cylinder:x,y,z:DIAMETER:LENGTH or with :x, :y or :z for its axis "
             "(mm)");
  const std::size_t needed = tube ? 5 : 4;
  if (parts.size() != needed && parts.size() != needed + 1) return usage;
  CylinderShape shape;
  const auto base = point(parts[1]);
  const auto diameter = positive(parts[2]), long_side = positive(parts[needed - 1]);
  const auto inner = tube ? positive(parts[3]) : std::optional<double>(0.0);
  if (!base || !diameter || !long_side || !inner) return usage;
  if (parts.size() == needed + 1) {
    const std::string_view axis = parts.back();
    if (axis.size() != 1 || axis[0] < 'x' || axis[0] > 'z') return usage;
    shape.axis = axis[0] - 'x';
  }
  if (*inner >= *diameter) return inputError("the tube's inner diameter must be below its diameter");
  shape.base = *base;
  shape.radius = 0.5 * *diameter;
  shape.inner_radius = 0.5 * *inner;
  shape.length = *long_side;
  return StockSpec(shape);
}

}  // namespace

std::string_view outputFormatName(OutputFormat format) {
  for (const FormatName& entry : kFormats) {
    if (entry.format == format) return entry.name;
  }
  return "stl";
}

std::string_view outputFormatExtension(OutputFormat format) {
  for (const FormatName& entry : kFormats) {
    if (entry.format == format) return entry.extension;
  }
  return "stl";
}

Result<OutputFormat> parseOutputFormat(std::string_view name) {
  std::vector<std::string> names;
  for (const FormatName& entry : kFormats) {
    if (entry.name == name) return entry.format;
    names.emplace_back(entry.name);
  }
  const std::string nearest = nearestName(name, names);
  return inputError(fmt::format("there is no output format '{}'{}; there are {}", name, didYouMean(nearest),
                                fmt::join(names, ", ")));
}

namespace {

/// Names with commas between them, none twice.
template <typename Item>
Result<std::vector<Item>> parseNames(std::string_view list, const char* what,
                                     Result<Item> (*parse)(std::string_view)) {
  std::vector<Item> items;
  for (const std::string_view name : split(list, ',')) {
    const Result<Item> item = parse(name);
    if (!item) return item.error();
    if (std::find(items.begin(), items.end(), *item) != items.end())
      return inputError(fmt::format("{} '{}' is listed twice", what, name));
    items.push_back(*item);
  }
  return items;
}

}  // namespace

Result<std::vector<OutputFormat>> parseOutputFormats(std::string_view list) {
  return parseNames(list, "output format", &parseOutputFormat);
}

std::string_view deviationOutputName(DeviationOutput output) {
  for (const DeviationName& entry : kDeviations) {
    if (entry.output == output) return entry.name;
  }
  return "ply";
}

Result<DeviationOutput> parseDeviationOutput(std::string_view name) {
  std::vector<std::string> names;
  for (const DeviationName& entry : kDeviations) {
    if (entry.name == name) return entry.output;
    names.emplace_back(entry.name);
  }
  const std::string nearest = nearestName(name, names);
  return inputError(fmt::format("deviations are not written as '{}'{}; there are {}", name,
                                didYouMean(nearest), fmt::join(names, ", ")));
}

Result<std::vector<DeviationOutput>> parseDeviationOutputs(std::string_view list) {
  return parseNames(list, "deviation output", &parseDeviationOutput);
}

Result<StockSpec> parseStockOption(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  const std::string rest = colon == std::string::npos ? std::string() : text.substr(colon + 1);
  const std::string nearest = nearestName(word, {"box", "cylinder", "tube", "mesh", "vdb"});
  const bool other = !nearest.empty() && nearest != word;
  Result<StockSpec> spec =
      inputError(fmt::format("'{}' is no stock{}; there are box:, cylinder:, tube:, mesh:FILE and vdb:FILE",
                             text, didYouMean(other ? nearest + ":" : "")));
  if (word == "box") spec = boxOption(split(text, ':'));
  if (word == "cylinder" || word == "tube") spec = cylinderOption(split(text, ':'), word == "tube");
  if (word == "mesh" || word == "vdb") {
    const Status file = checkRegularFile(rest);
    if (!file) return file.error();
    spec = word == "mesh" ? StockSpec(MeshFile{rest, MeshUnit::kMillimetre}) : StockSpec(SavedStock{rest});
  }
  if (!spec && colon != std::string::npos) {
    return inputError(fmt::format("stock '{}': {}", text, spec.error().message));
  }
  return spec;
}

Result<StockShape> loadStockShape(const StockSpec& spec) {
  if (const auto* box = std::get_if<BoxShape>(&spec)) return StockShape(*box);
  if (const auto* cylinder = std::get_if<CylinderShape>(&spec)) return StockShape(*cylinder);
  if (const auto* saved = std::get_if<SavedStock>(&spec)) return StockShape(*saved);
  const MeshFile& file = std::get<MeshFile>(spec);
  MeshLoadOptions options;
  options.unit = file.unit;
  options.body = file.body;
  Result<TriMesh> mesh = loadMesh(file.path, options);
  if (!mesh) return mesh.error();
  return StockShape(MeshShape{std::move(*mesh), file.path});
}

}  // namespace proveout
