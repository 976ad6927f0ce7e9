#include "core/nc/flexnc/template/template_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/geometry/types.h"
#include "core/nc/flexnc/cycles/cycle_checks.h"

namespace proveout::nc {

namespace {

/// P and K say which form it is.
std::optional<CycleNote> readForm(const TemplateRow& row, const CycleArguments& a, TemplateCheck& check) {
  const std::string name = cycleName(row.code);
  const std::optional<double> p = a.find('P'), k = a.find('K');
  if (k) {
    check.form = TemplateForm::kContour;
    check.goes_on = *k == 0.0;
    if (p && *p != 0.0) {
      return CycleNote{"fnc-p-fin",
                       fmt::format("{}: a contour block, with K, has P0 and not P{:g}", name, *p)};
    }
    if (*k == 0.0 || *k == 1.0) return std::nullopt;
    return CycleNote{"fnc-k",
                     fmt::format("{}: K{:g} is neither 1, first contour block, nor 0, a next one", name, *k)};
  }
  if (!p) {
    return CycleNote{"fnc-param-missing",
                     name + " needs P: above 0 to rough, or P0 with K1 or K0 for the contour"};
  }
  if (*p > 0.0) return std::nullopt;
  if (*p < 0.0 || a.has('B')) {
    return CycleNote{"fnc-p-rough", fmt::format("{}: P{:g}, the depth of a pass, has to be above 0 in a "
                                                "roughing block; a contour block has P0 and K",
                                                name, *p)};
  }
  check.form = TemplateForm::kContour;
  check.warnings.push_back({"fnc-k", name + ": a contour block without K counts as the first one, K1"});
  return std::nullopt;
}

std::optional<CycleNote> checkSide(const TemplateRow& row, double c) {
  const std::string name = cycleName(row.code);
  if (c == 0.0) {
    return CycleNote{"fnc-c-sign", name + ": C0 is neither a shaft, above 0, nor a hole, below it"};
  }
  if (c < 0.0 && row.shaft_only) {
    return CycleNote{"fnc-c-sign", fmt::format("{} has no form for holes: C{:g} has to be above 0", name, c)};
  }
  return std::nullopt;
}

/// Letters that may be 0 or have a zero of their own to tell of.
std::optional<CycleNote> checkZeros(const TemplateRow& row, const CycleArguments& a, TemplateCheck& check) {
  const std::string name = cycleName(row.code);
  const bool shaft = a.value('C') > 0.0,
             compound = row.shape_letters.has('G') || row.code == CycleCode::kG8_1;
  for (const char letter : {'A', 'R', 'U', 'Y'}) {
    if (!row.shape_letters.has(letter) || a.value(letter) != 0.0) continue;
    if (row.zero_letters.has(letter) && (shaft || letter == 'Y')) continue;
    if (letter == 'Y') return CycleNote{"fnc-y-zero", name + ": Y0 leaves no length: above 0"};
    if (letter == 'A' || !compound) {
      return CycleNote{"fnc-param-sign", fmt::format("{}: {} has to be above 0", name, addressText(letter))};
    }
    check.warnings.push_back({"fnc-param-sign", fmt::format("{}: {}0 is not described: there is no arc then",
                                                            name, addressText(letter))});
  }
  return std::nullopt;
}

std::optional<CycleNote> checkAngle(const TemplateRow& row, const CycleArguments& a) {
  const std::optional<double> g = a.find('G');
  if (!g || (*g > 0.0 && *g < 90.0)) return std::nullopt;
  return CycleNote{"fnc-angle-90", fmt::format("{}: the angle G{:g} between cone and Z has to be above 0 and "
                                               "below 90 degrees",
                                               cycleName(row.code), *g)};
}

/// Diameters that do not go together.
std::optional<CycleNote> checkDiameters(const TemplateRow& row, const CycleArguments& a) {
  const bool shaft = a.value('C') > 0.0;
  const double x = a.value('X');
  if (row.shape == TemplateShape::kQuarter && shaft && x < 2.0 * a.value('R')) {
    return CycleNote{"fnc-x-2r", fmt::format("{}: X{:g} has to be at least twice R{:g}: a smaller radius",
                                             cycleName(row.code), x, a.value('R'))};
  }
  const bool cone = row.given == TemplateGiven::kBoth && row.head == TemplateHead::kNone;
  if (!cone && row.shape != TemplateShape::kPartArc) return std::nullopt;
  const double start = a.value('A');
  if (shaft && x <= start) {
    return CycleNote{"fnc-x-le-a",
                     fmt::format("{}: X{:g}, the initial diameter of the shaft, has to be above A{:g}",
                                 cycleName(row.code), x, start)};
  }
  if (!shaft && start <= x) {
    return CycleNote{"fnc-a-le-x",
                     fmt::format("{}: X{:g}, the initial diameter of the hole, has to be below A{:g}",
                                 cycleName(row.code), x, start)};
  }
  return std::nullopt;
}

/// X is a stock that has to be there; Z is one where it is the length of the profile itself.
AddressSet aboveZero(const TemplateRow& row, TemplateForm form) {
  const AddressSet length = row.shape == TemplateShape::kPartArc ? AddressSet("XZ") : AddressSet("X");
  return form == TemplateForm::kRoughing ? length | AddressSet("B") : length;
}
/// Below 0 some profiles end in front of the face, which has a note of its own.
AddressSet notBelowZero(const TemplateRow& row) {
  return row.z_to_end ? AddressSet("VBARUY") : AddressSet("ZVBARUY");
}

}  // namespace

TemplateCheck checkTemplate(const TemplateRow& row, const CycleArguments& a) {
  TemplateCheck check;
  const CycleCode code = row.code;
  const auto letters = [&] {
    return check.form == TemplateForm::kRoughing ? checkLetters(code, a, roughingLetters(row), "V")
                                                 : checkLetters(code, a, contourLetters(row), "ZPKBV");
  };
  const auto signs = [&] { return checkSigns(code, a, aboveZero(row, check.form), notBelowZero(row)); };
  check.alarm =
      firstNote([&] { return readForm(row, a, check); }, letters,
                [&] { return checkSide(row, a.value('C')); }, signs, [&] { return checkAngle(row, a); },
                [&] { return checkZeros(row, a, check); }, [&] { return checkDiameters(row, a); });
  return check;
}

TemplateInput templateInput(const TemplateRow& row, const CycleArguments& a, ArcView view) {
  return {.row = row,
          .side = a.value('C') > 0.0 ? 1.0 : -1.0,
          .convex = row.convex_down == (view == ArcView::kXDown),
          .x = 0.5 * a.value('X'),
          .a = 0.5 * a.value('A'),
          .y = a.value('Y'),
          .z = a.value('Z'),
          .r = a.value('R'),
          .u = a.value('U'),
          .angle = degToRad(a.value('G')),
          .c = a.value('C'),
          .v = a.value('V')};
}

}  // namespace proveout::nc
