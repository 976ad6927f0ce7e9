#include "core/nc/flexnc/template/template_table.h"

#include <algorithm>
#include <array>

namespace proveout::nc {

namespace {

using Code = CycleCode;
using Shape = TemplateShape;
using Head = TemplateHead;
using Tail = TemplateTail;
using Given = TemplateGiven;

constexpr TemplateRow coneRow(Code code, AddressSet letters, AddressSet zero, Head head, Tail tail,
                              Given given) {
  return {code, Shape::kCone, letters, zero, false, head, tail, given, false, false};
}
/// Both diameters and the angle; Z counts to the end.
constexpr TemplateRow endRow(Code code, AddressSet zero, Head head, bool shaft_only) {
  return {code, Shape::kCone, "XARG", zero, false, head, Tail::kNone, Given::kBoth, true, shaft_only};
}

constexpr auto kRows = std::to_array<TemplateRow>({
    {.code = Code::kG3_1,
     .shape = Shape::kPartArc,
     .shape_letters = "XAR",
     .zero_letters = "",
     .shaft_only = true},
    {.code = Code::kG12,
     .shape = Shape::kQuarter,
     .shape_letters = "XR",
     .zero_letters = "",
     .convex_down = true},
    {.code = Code::kG13, .shape = Shape::kQuarter, .shape_letters = "XR", .zero_letters = ""},
    {.code = Code::kG8_1,
     .shape = Shape::kTwoArcs,
     .shape_letters = "XARU",
     .zero_letters = "A",
     .shaft_only = true},
    coneRow(Code::kG77, "XAY", "Y", Head::kNone, Tail::kNone, Given::kBoth),
    coneRow(Code::kG77_1, "XYG", "", Head::kNone, Tail::kNone, Given::kEnd),
    coneRow(Code::kG77_2, "AYG", "", Head::kNone, Tail::kNone, Given::kStart),
    coneRow(Code::kG77_3, "AXG", "", Head::kNone, Tail::kNone, Given::kBoth),
    coneRow(Code::kG13_1, "XYRG", "", Head::kRoot, Tail::kNone, Given::kEnd),
    coneRow(Code::kG13_2, "AYRG", "", Head::kRoot, Tail::kNone, Given::kStart),
    endRow(Code::kG13_5, "", Head::kRoot, true),
    coneRow(Code::kG12_1, "XYRG", "", Head::kNose, Tail::kNone, Given::kEnd),
    coneRow(Code::kG12_2, "AYRG", "A", Head::kNose, Tail::kNone, Given::kStart),
    coneRow(Code::kG12_3, "AYRG", "", Head::kNose, Tail::kNone, Given::kLineStart),
    endRow(Code::kG12_5, "A", Head::kNose, false),
    coneRow(Code::kG22_1, "XYRUG", "RU", Head::kNose, Tail::kCrest, Given::kEnd),
    coneRow(Code::kG22_2, "AYRUG", "", Head::kNose, Tail::kCrest, Given::kStart),
    coneRow(Code::kG22_3, "AYRUG", "RU", Head::kNose, Tail::kCrest, Given::kLineStart),
    coneRow(Code::kG23_1, "XYRUG", "R", Head::kNose, Tail::kShoulder, Given::kLineEnd),
    coneRow(Code::kG23_2, "AYRUG", "", Head::kNose, Tail::kShoulder, Given::kLineStart),
    coneRow(Code::kG23_3, "XYRUG", "", Head::kNose, Tail::kShoulder, Given::kEnd),
    coneRow(Code::kG23_4, "AYRUG", "", Head::kNose, Tail::kShoulder, Given::kStart),
});

}  // namespace

std::span<const TemplateRow> templateRows() { return kRows; }

const TemplateRow* findTemplate(CycleCode code) {
  const auto found =
      std::find_if(kRows.begin(), kRows.end(), [code](const TemplateRow& row) { return row.code == code; });
  return found == kRows.end() ? nullptr : &*found;
}

AddressSet roughingLetters(const TemplateRow& row) { return row.shape_letters | AddressSet("ZPCB"); }

AddressSet contourLetters(const TemplateRow& row) {
  const AddressSet length = row.shape == TemplateShape::kPartArc ? AddressSet("Z") : AddressSet();
  return row.shape_letters | length | AddressSet("C");
}

}  // namespace proveout::nc
