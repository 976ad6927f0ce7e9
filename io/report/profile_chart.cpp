#include "io/report/profile_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "io/report_text.h"

namespace proveout {
namespace {

// User units; a page scales the chart to its width.
constexpr double kWidth = 900, kLeft = 56, kRight = 16, kTop = 76, kBottom = 46;
constexpr double kPad = 26;  ///< around the profile: room for the deviations
constexpr double kPlotWidth = kWidth - kLeft - kRight - 2 * kPad;
constexpr double kMaxHeight = 420, kMinHeight = 150, kMinWidth = 150;
constexpr double kLeastTickZ = 55, kLeastTickR = 26;
/// The largest deviation takes about this share of the height.
constexpr double kDeviationShare = 0.05;
/// Larger deviations are cut off at this many tolerances, so that a part on its bar still shows its cuts.
constexpr double kMostTolerances = 20.0;
constexpr double kLeastDrawn = 0.15;  ///< user units
constexpr double kLetter = 6.6;       ///< room for one, user units

constexpr const char* kMetal = "#e3e7ea";
constexpr const char* kNominal = "#1d2329";
constexpr const char* kOutline = "#7b858d";
constexpr const char* kBlank = "#8a949c";
constexpr const char* kTool = "#b7791f";

/// What the page's style sheet says of charts, for a file that stands alone.
constexpr const char* kOwnStyle =
    "<style>text{font:12px sans-serif;fill:#5c6770}.grid{stroke:#d9dee3}.axis,.tick{stroke:#5c6770}"
    ".gouge{fill:#2e7acc}.excess{fill:#d94d38}.within{fill:#9aa6ae}</style>"
    "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>";

/// 1, 2 or 5 times a power of ten: the largest that is not above `x`, or the least that is not below it.
double niceNumber(double x, bool below) {
  const double decade = std::pow(10.0, std::floor(std::log10(x) + 1e-12));
  double result = below ? decade : 10.0 * decade;
  for (const double step : {1.0, 2.0, 5.0}) {
    if (below && step * decade <= x * (1 + 1e-9)) result = step * decade;
    if (!below && step * decade >= x * (1 - 1e-9)) result = std::min(result, step * decade);
  }
  return result;
}

/// Extent of everything drawn, mm.
struct Extent {
  Vec2 least = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 most = -least;
  bool finite = true;
  void add(const Vec2& p) {
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
    finite = finite && p.allFinite();
  }
};

class Drawing {
 public:
  Drawing(const std::vector<std::vector<Vec2>>& machined, const std::vector<SectionSegment>& nominal,
          const ProfileChartOptions& options, const Extent& extent)
      : machined_(machined),
        nominal_(nominal),
        options_(options),
        deviations_(profileDeviations(machined, nominal, options.ignored)),
        r_low_(extent.least.x() > 0.6 * extent.most.x() ? extent.least.x() : 0.0),
        r_high_(extent.most.x()),
        z_low_(extent.least.y()),
        z_high_(extent.most.y()) {
    PROVEOUT_ASSERT(r_high_ > r_low_ && z_high_ > z_low_);
    chooseScales();
    chooseMagnification();
  }

  std::string draw(const std::string& attributes, const char* style) const {
    return fmt::format(
        "<svg {} viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"Half section of the part and its "
        "nominal\">{}{}{}{}{}{}{}{}{}{}{}{}</svg>",
        attributes, kWidth, height(), style, heading(), legend(), grid(), blank(), material(), bands(),
        nominal(), tools(), marks(), labels(), axes());
  }
  double height() const { return base() + kBottom; }

 private:
  enum class Side { kGouge, kWithin, kExcess };

  void chooseScales() {
    const double r = r_high_ - r_low_, z = z_high_ - z_low_;
    scale_z_ = scale_r_ = std::min(kPlotWidth / z, kMaxHeight / r);
    if (scale_r_ * r < kMinHeight) scale_r_ = kMinHeight / r;
    if (scale_z_ * z < kMinWidth) scale_z_ = kMinWidth / z;
    left_ = kLeft + 0.5 * (kPlotWidth - scale_z_ * z);
  }

  void chooseMagnification() {
    const double least = std::min(options_.gouge_mm, options_.excess_mm);
    const double largest = std::max(deviations_.largest_gouge_mm, deviations_.largest_excess_mm);
    const double most = kMostTolerances * std::max(options_.gouge_mm, options_.excess_mm);
    drawn_limit_ = std::max(largest, least);
    if (most > 0) drawn_limit_ = std::min(drawn_limit_, most);
    cut_off_ = largest > drawn_limit_;
    magnification_ = options_.magnification;
    if (magnification_ > 0 || !(drawn_limit_ > 0)) return;
    magnification_ = std::max(1.0, niceNumber(kDeviationShare * (r_high_ - r_low_) / drawn_limit_, true));
  }

  double x(double z) const { return left_ + kPad + (z - z_low_) * scale_z_; }
  double y(double r) const { return kTop + kPad + (r_high_ - r) * scale_r_; }
  double right() const { return x(z_high_) + kPad; }
  double base() const { return y(r_low_) + (r_low_ > 0 ? kPad : 0.0); }
  Vec2 at(const Vec2& p) const { return {x(p.y()), y(p.x())}; }

  bool over() const {
    return deviations_.largest_gouge_mm > options_.gouge_mm ||
           deviations_.largest_excess_mm > options_.excess_mm;
  }

  std::string heading() const {
    std::string out = fmt::format(
        "<text x=\"12\" y=\"20\" style=\"font-size:15px;font-weight:600;fill:#1d2329\">Profile of {}</text>",
        report_text::escape(options_.name));
    if (deviations_.samples.empty()) {
      return out + "<text x=\"12\" y=\"40\">no nominal to compare with</text>";
    }
    const auto figure = [](const char* what, double mm, const Vec2& p, double allowed) {
      std::string text = fmt::format("largest {} {:.4f} mm", what, mm);
      if (mm >= 5e-5) text += fmt::format(" at z {:.2f}, r {:.2f}", p.y(), p.x());
      return text + fmt::format(" (allowed {:g})", allowed);
    };
    return out +
           fmt::format(
               "<text x=\"12\" y=\"40\"><tspan style=\"font-weight:600;fill:{}\">{}:</tspan> {}; "
               "{}</text>",
               over() ? "#b42318" : "#1a7f4b", over() ? "over tolerance" : "within tolerance",
               figure("gouge", deviations_.largest_gouge_mm, deviations_.gouge_at, options_.gouge_mm),
               figure("excess", deviations_.largest_excess_mm, deviations_.excess_at, options_.excess_mm));
  }

  std::string legend() const {
    double from = 12;
    std::string out;
    const auto label = [&](const std::string& swatch, const std::string& text) {
      if (!swatch.empty()) from += 18;
      out += fmt::format("{}<text x=\"{:.1f}\" y=\"62\">{}</text>", swatch, from, text);
      from += kLetter * static_cast<double>(text.size()) + 16;
    };
    const auto box = [&](const std::string& paint) {
      return fmt::format("<rect x=\"{:.1f}\" y=\"52\" width=\"12\" height=\"11\" {}/>", from, paint);
    };
    label(box(fmt::format("fill=\"{}\" stroke=\"{}\"", kMetal, kOutline)), "machined");
    if (!options_.blank.empty()) {
      label(fmt::format("<path d=\"M{:.1f} 57.5h12\" stroke=\"{}\" stroke-dasharray=\"4 3\"/>", from, kBlank),
            "blank");
    }
    if (!options_.tools.empty())
      label(box(fmt::format("fill=\"{0}\" fill-opacity=\".25\" stroke=\"{0}\"", kTool)), "tool");
    if (!deviations_.samples.empty()) {
      label(fmt::format("<path d=\"M{:.1f} 57.5h12\" stroke=\"{}\" stroke-width=\"1.2\"/>", from, kNominal),
            "nominal");
      label(box("class=\"gouge\""), "gouge");
      label(box("class=\"excess\""), "excess");
      label(box("class=\"within\""), "within tolerance");
      std::string text = fmt::format("deviations \u00d7 {:g}", magnification_);
      if (cut_off_) text += fmt::format(", cut off at {:g} mm", drawn_limit_);
      label("", text);
    }
    const double stretch = scale_r_ / scale_z_;
    if (std::abs(stretch - 1.0) > 1e-9) {
      const char* stretched = stretch > 1 ? "r" : "z";
      label("", fmt::format("{} stretched {:.3g} times", stretched, stretch > 1 ? stretch : 1 / stretch));
    }
    return out;
  }

  template <typename Line>
  static void forEachTick(double low, double high, double step, const Line& line) {
    const auto first = static_cast<long long>(std::ceil(low / step - 1e-9));
    const auto last = static_cast<long long>(std::floor(high / step + 1e-9));
    for (long long i = first; i <= last; ++i) line(static_cast<double>(i) * step);
  }
  double stepZ() const { return niceNumber(kLeastTickZ / scale_z_, false); }
  double stepR() const { return niceNumber(kLeastTickR / scale_r_, false); }

  std::string grid() const {
    std::string out;
    forEachTick(z_low_, z_high_, stepZ(), [&](double z) {
      out += fmt::format("<line class=\"grid\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1}\" y2=\"{2:.2f}\"/>",
                         x(z), kTop, base());
    });
    forEachTick(r_low_, r_high_, stepR(), [&](double r) {
      out += fmt::format(
          "<line class=\"grid\" x1=\"{0:.2f}\" x2=\"{1:.2f}\" y1=\"{2:.2f}\" y2=\"{2:.2f}\"/>"
          "<text x=\"{3:.2f}\" y=\"{4:.2f}\" text-anchor=\"end\">{5:g}</text>",
          left_, right(), y(r), left_ - 6, y(r) + 4, r);
    });
    return out;
  }

  std::string axes() const {
    std::string out;
    forEachTick(z_low_, z_high_, stepZ(), [&](double z) {
      out += fmt::format(
          "<line class=\"tick\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1:.2f}\" y2=\"{2:.2f}\"/>"
          "<text x=\"{0:.2f}\" y=\"{3:.2f}\" text-anchor=\"middle\">{4:g}</text>",
          x(z), base(), base() + 5, base() + 18, z);
    });
    // The axis of the part is drawn as on drawings.
    out += fmt::format("<line class=\"axis\" x1=\"{:.2f}\" x2=\"{:.2f}\" y1=\"{:.2f}\" y2=\"{:.2f}\"{}/>",
                       left_, right(), base(), base(), r_low_ > 0 ? "" : " stroke-dasharray=\"14 3 3 3\"");
    out += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"middle\">z, mm</text>",
                       0.5 * (left_ + right()), base() + 36);
    return out + fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"end\">r, mm</text>", left_ - 6,
                             kTop + 2.0);
  }

  std::string closedPath(const std::vector<Vec2>& loop) const {
    std::string path;
    Vec2 last = Vec2::Constant(-1e9);
    const char* command = "M";
    for (const Vec2& point : loop) {
      const Vec2 p = at(point);
      if ((p - last).norm() < 0.02) continue;
      path += fmt::format("{}{:.2f} {:.2f}", command, p.x(), p.y());
      last = p;
      command = "L";
    }
    return path + "Z";
  }

  std::string material() const {
    std::string path;
    for (const auto& loop : machined_) path += closedPath(loop);
    return fmt::format("<path fill=\"{}\" fill-rule=\"evenodd\" stroke=\"{}\" stroke-width=\".8\" d=\"{}\"/>",
                       kMetal, kOutline, path);
  }

  /// What lies beyond the chart goes along its border.
  std::string blank() const {
    std::string path;
    for (std::vector<Vec2> loop : options_.blank) {
      for (Vec2& p : loop) p = Vec2(std::clamp(p.x(), r_low_, r_high_), std::clamp(p.y(), z_low_, z_high_));
      path += closedPath(loop);
    }
    if (path.empty()) return {};
    return fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-dasharray=\"4 3\" d=\"{}\"/>", kBlank, path);
  }

  std::string tools() const {
    if (options_.tools.empty()) return {};
    std::string out = fmt::format(
        "<clipPath id=\"plot\"><rect x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{:.2f}\"/></clipPath>"
        "<g clip-path=\"url(#plot)\">",
        left_, kTop, right() - left_, base() - kTop);
    for (const ProfileTool& tool : options_.tools) {
      out += fmt::format("<path fill=\"{0}\" fill-opacity=\".25\" stroke=\"{0}\" d=\"{1}\"/>", kTool,
                         closedPath(tool.outline));
    }
    return out + "</g>";
  }

  /// Texts stand above their places, one over the other where places are near.
  std::string labels() const {
    std::vector<ProfileMark> all = options_.marks;
    for (const ProfileTool& tool : options_.tools) {
      if (!tool.label.empty() && !tool.outline.empty()) all.push_back({innermost(tool.outline), tool.label});
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const ProfileMark& a, const ProfileMark& b) { return a.at.y() < b.at.y(); });
    std::string out;
    std::vector<Vec2> taken;  // lower left corners
    for (const ProfileMark& mark : all) {
      const Vec2 p = at(mark.at);
      const double width = kLetter * static_cast<double>(mark.label.size());
      Vec2 text(std::clamp(p.x() + 8.0, kLeft, std::max(kLeft, kWidth - kRight - width)), p.y() - 12.0);
      const auto overlaps = [&](const Vec2& other) {
        return std::abs(other.y() - text.y()) < 13.0 && std::abs(other.x() - text.x()) < width + 8.0;
      };
      while (text.y() > kTop + 12.0 && std::any_of(taken.begin(), taken.end(), overlaps)) text.y() -= 13.0;
      taken.push_back(text);
      out += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2.6\" fill=\"#8f2415\"/><path d=\"M{:.2f} {:.2f}L{:.2f} "
          "{:.2f}\" stroke=\"#8f2415\" stroke-width=\".7\"/><text x=\"{:.2f}\" y=\"{:.2f}\" "
          "style=\"fill:#8f2415;font-weight:600\">{}</text>",
          p.x(), p.y(), p.x(), p.y(), text.x(), text.y() + 2, text.x(), text.y(),
          report_text::escape(mark.label));
    }
    return out;
  }

  /// The point of a tool that is nearest to the axis: its nose.
  static Vec2 innermost(const std::vector<Vec2>& outline) {
    return *std::min_element(outline.begin(), outline.end(),
                             [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  }

  std::string nominal() const {
    std::string path;
    Vec2 last = Vec2::Constant(-1e9);
    for (const auto& [from, to] : nominal_) {
      const Vec2 a = at(from), b = at(to);
      if ((a - last).norm() > 0.005) path += fmt::format("M{:.2f} {:.2f}", a.x(), a.y());
      path += fmt::format("L{:.2f} {:.2f}", b.x(), b.y());
      last = b;
    }
    if (path.empty()) return {};
    return fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"1.1\" d=\"{}\"/>", kNominal, path);
  }

  Side sideOf(const SectionSample& sample) const {
    if (sample.deviation_mm < -options_.gouge_mm) return Side::kGouge;
    return sample.deviation_mm > options_.excess_mm ? Side::kExcess : Side::kWithin;
  }

  /// The end of the sample's magnified deviation, which leads away from the nominal.
  Vec2 tip(const SectionSample& sample) const {
    const double deviation = std::abs(sample.deviation_mm);
    const double share = deviation > drawn_limit_ ? drawn_limit_ / deviation : 1.0;
    return at(sample.at) + (at(sample.at) - at(sample.nearest)) * (share * magnification_);
  }

  /// Neighbours on one side of the tolerances make one band; the step between two sides belongs to the worse.
  std::string bands() const {
    const auto& samples = deviations_.samples;
    std::string out;
    for (std::size_t first = 0; first < samples.size();) {
      const Side side = sideOf(samples[first]);
      std::size_t end = first + 1;
      const auto goesOn = [&](std::size_t i) { return i < samples.size() && !samples[i].starts_stretch; };
      while (goesOn(end) && sideOf(samples[end]) == side) ++end;
      const bool from_before = side != Side::kWithin && goesOn(first) && first > 0;
      const bool into_next = side != Side::kWithin && goesOn(end);
      out += band(side, from_before ? first - 1 : first, into_next ? end + 1 : end);
      first = end;
    }
    return out;
  }

  std::string band(Side side, std::size_t first, std::size_t end) const {
    std::string there, back;
    double longest = 0.0;
    for (std::size_t i = first; i < end; ++i) {
      const SectionSample& sample = deviations_.samples[i];
      const Vec2 foot = at(sample.at), head = tip(sample);
      there += fmt::format("{}{:.2f} {:.2f}", i == first ? "M" : "L", foot.x(), foot.y());
      back.insert(0, fmt::format("L{:.2f} {:.2f}", head.x(), head.y()));
      longest = std::max(longest, (head - foot).norm());
    }
    if (longest < kLeastDrawn) return {};
    const char* name = side == Side::kGouge ? "gouge" : side == Side::kExcess ? "excess" : "within";
    return fmt::format("<path class=\"{}\" fill-opacity=\".85\" d=\"{}{}Z\"/>", name, there, back);
  }

  /// Rings about the places of the figures that are over tolerance.
  std::string marks() const {
    std::string out;
    const auto ring = [&](const Vec2& p, const char* color) {
      out += fmt::format(
          "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"7\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>",
          at(p).x(), at(p).y(), color);
    };
    if (deviations_.largest_gouge_mm > options_.gouge_mm) ring(deviations_.gouge_at, "#0f4f95");
    if (deviations_.largest_excess_mm > options_.excess_mm) ring(deviations_.excess_at, "#8f2415");
    return out;
  }

  const std::vector<std::vector<Vec2>>& machined_;
  const std::vector<SectionSegment>& nominal_;
  const ProfileChartOptions& options_;
  ProfileDeviations deviations_;
  double r_low_, r_high_, z_low_, z_high_;  ///< mm
  double scale_z_ = 1.0, scale_r_ = 1.0;    ///< user units a mm
  double left_ = kLeft;
  double magnification_ = 1.0, drawn_limit_ = 0.0;
  bool cut_off_ = false;
};

bool usable(const ProfileChartOptions& options) {
  const auto fine = [](double v) { return std::isfinite(v) && v >= 0.0; };
  return fine(options.gouge_mm) && fine(options.excess_mm) && fine(options.magnification);
}

}  // namespace

ProfileChart drawProfileChart(const std::vector<std::vector<Vec2>>& machined,
                              const std::vector<SectionSegment>& nominal,
                              const ProfileChartOptions& options) {
  Extent extent;
  for (const auto& loop : machined)
    for (const Vec2& p : loop) extent.add(p);
  // What has no area is no material.
  const bool material =
      extent.finite && extent.least.x() >= 0.0 && (extent.most - extent.least).minCoeff() > 0.0;
  if (!material || !usable(options)) return {};
  for (const auto& [a, b] : nominal) {
    extent.add(a);
    extent.add(b);
  }
  // Of the blank what is beside the part: a tenth of its size about it.
  const Vec2 margin = 0.1 * (extent.most - extent.least);
  const Extent part = extent;
  for (const auto& loop : options.blank) {
    for (const Vec2& p : loop) {
      if (!p.allFinite()) return {};
      const Vec2 near = p.cwiseMax(part.least - margin).cwiseMin(part.most + margin);
      extent.add({std::max(0.0, near.x()), near.y()});
    }
  }
  const auto finite = [](const std::vector<Vec2>& points) {
    return std::all_of(points.begin(), points.end(), [](const Vec2& p) { return p.allFinite(); });
  };
  if (!extent.finite ||
      !std::all_of(options.marks.begin(), options.marks.end(),
                   [](const ProfileMark& mark) { return mark.at.allFinite(); }) ||
      !std::all_of(options.tools.begin(), options.tools.end(),
                   [&](const ProfileTool& tool) { return finite(tool.outline); }))
    return {};
  const Drawing drawing(machined, nominal, options, extent);
  ProfileChart chart;
  chart.page = drawing.draw("class=\"chart wide-chart\"", "");
  chart.file = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
               drawing.draw(fmt::format("xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{:.0f}\"",
                                        kWidth, drawing.height()),
                            kOwnStyle) +
               "\n";
  return chart;
}

}  // namespace proveout
