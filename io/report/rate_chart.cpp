// The material removal rate over the machining time as SVG.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "io/report/report_html_parts.h"
#include "io/report_text.h"

namespace proveout {

namespace {

// User units; a page scales the chart to its width.
constexpr double kWidth = 900, kHeight = 300;
constexpr double kLeft = 66, kRight = 12, kTop = 44, kBottom = 44;
constexpr double kPlotWidth = kWidth - kLeft - kRight, kPlotHeight = kHeight - kTop - kBottom;
/// Room that a letter of a label needs, user units.
constexpr double kLetter = 7;

/// What the page's style sheet says of charts, for a file that stands alone.
constexpr const char* kOwnStyle =
    "<style>text{font:12px sans-serif;fill:#5c6770}.grid{stroke:#d9dee3}.axis,.tick{stroke:#5c6770}"
    ".mean{fill:#2e7acc;fill-opacity:.75}.peak{fill:none;stroke:#e39b2d;stroke-width:1}"
    ".span{fill:#f4f6f8}</style>";

/// 1, 2 or 5 times a power of ten, so that `range` holds about `count` of it.
double niceStep(double range, double count) {
  const double wanted = range / count, decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (wanted <= step * decade * (1 + 1e-9)) return step * decade;
  }
  return 10.0 * decade;
}

class RateChart {
 public:
  explicit RateChart(const RateSeries& rate) : rate_(rate) {
    PROVEOUT_ASSERT(!rate.max.empty() && rate.mean.size() == rate.max.size());
    total_s_ = rate.step_s * static_cast<double>(rate.mean.size());
    const double largest = *std::max_element(rate.max.begin(), rate.max.end());
    y_step_ = niceStep(largest, 5.0);
    top_ = y_step_ * std::ceil(largest / y_step_ - 1e-9);
    unit_s_ = total_s_ >= 7200.0 ? 3600.0 : total_s_ >= 180.0 ? 60.0 : 1.0;
  }

  std::string draw(const char* attributes, const char* style) const {
    return fmt::format(
        "<svg {} viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{} over "
        "time\">{}{}{}{}{}{}</svg>",
        attributes, kWidth, kHeight, rate_.by_area ? "Cutting rate" : "Material removal rate", style, spans(),
        rateAxis(), mean(), peak(), timeAxis());
  }

 private:
  double x(double s) const { return kLeft + kPlotWidth * std::clamp(s / total_s_, 0.0, 1.0); }
  double y(double rate) const { return kTop + kPlotHeight * (1.0 - std::clamp(rate / top_, 0.0, 1.0)); }

  /// Every second span is shaded, so that tool changes show; its name stands above where it fits.
  std::string spans() const {
    std::string out;
    for (std::size_t i = 0; i < rate_.spans.size(); ++i) {
      const auto& span = rate_.spans[i];
      const double from = x(span.from_s), to = x(span.to_s);
      if (i % 2 == 0) {
        out += fmt::format("<rect class=\"span\" x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\"/>",
                           from, kTop, to - from, kPlotHeight);
      }
      if (to - from < kLetter * static_cast<double>(span.label.size() + 1)) continue;
      out += fmt::format("<text x=\"{:.2f}\" y=\"{}\" text-anchor=\"middle\">{}</text>", 0.5 * (from + to),
                         kTop - 6, report_text::escape(span.label));
    }
    return out;
  }

  std::string rateAxis() const {
    std::string out = fmt::format("<text x=\"4\" y=\"16\">{}</text>",
                                  rate_.by_area ? "cutting rate, mm²/min" : "removal rate, mm³/min");
    for (int i = 0; i * y_step_ <= top_ * (1 + 1e-9); ++i) {
      const double at = y(i * y_step_);
      out += fmt::format(
          "<line class=\"grid\" x1=\"{0}\" x2=\"{1}\" y1=\"{2:.2f}\" y2=\"{2:.2f}\"/><text x=\"{3}\" "
          "y=\"{4:.2f}\" text-anchor=\"end\">{5:g}</text>",
          kLeft, kWidth - kRight, at, kLeft - 6, at + 4, i * y_step_);
    }
    return out;
  }

  /// Steps: equal neighbours become one.
  std::string steps(const std::vector<double>& values) const {
    std::string out;
    double last = -1.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double at = std::round(100.0 * y(values[i])) / 100.0;
      if (at == last) continue;
      out += fmt::format("H{:.2f}V{:.2f}", x(static_cast<double>(i) * rate_.step_s), at);
      last = at;
    }
    return out + fmt::format("H{:.2f}", x(total_s_));
  }

  std::string mean() const {
    const double base = kTop + kPlotHeight;
    return fmt::format("<path class=\"mean\" d=\"M{0} {1}{2}V{1}Z\"/>", kLeft, base, steps(rate_.mean));
  }
  std::string peak() const {
    return fmt::format("<path class=\"peak\" d=\"M{} {}{}\"/>", kLeft, kTop + kPlotHeight, steps(rate_.max));
  }

  std::string timeAxis() const {
    const double base = kTop + kPlotHeight;
    std::string out = fmt::format("<line class=\"axis\" x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\"/>", kLeft,
                                  kWidth - kRight, base, base);
    const double step = niceStep(total_s_ / unit_s_, 8.0);
    for (int i = 0; i * step * unit_s_ <= total_s_ * (1 + 1e-9); ++i) {
      out += fmt::format(
          "<line class=\"tick\" x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1}\" y2=\"{2}\"/>"
          "<text x=\"{0:.2f}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>",
          x(i * step * unit_s_), base, base + 5, base + 18, i * step);
    }
    const char* unit = unit_s_ == 3600.0 ? "h" : unit_s_ == 60.0 ? "min" : "s";
    return out + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">machining time, {}</text>",
                             kLeft + 0.5 * kPlotWidth, kHeight - 6, unit);
  }

  const RateSeries& rate_;
  double total_s_ = 0.0, top_ = 0.0, y_step_ = 1.0, unit_s_ = 1.0;
};

bool drawable(const RateSeries& rate) {
  const auto fine = [](double v) { return std::isfinite(v) && v >= 0.0; };
  return rate.step_s > 0.0 && !rate.max.empty() && rate.mean.size() == rate.max.size() &&
         std::all_of(rate.max.begin(), rate.max.end(), fine) &&
         std::all_of(rate.mean.begin(), rate.mean.end(), fine) &&
         *std::max_element(rate.max.begin(), rate.max.end()) > 0.0;
}

}  // namespace

std::string report_html::rateSvg(const RateSeries& rate) {
  if (!drawable(rate)) return {};
  return RateChart(rate).draw("class=\"chart wide-chart\"", "");
}

std::string rateSvgFile(const RateSeries& rate) {
  if (!drawable(rate)) return {};
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
         RateChart(rate).draw("xmlns=\"http://www.w3.org/2000/svg\" width=\"900\" height=\"300\"",
                              kOwnStyle) +
         "\n";
}

}  // namespace proveout
