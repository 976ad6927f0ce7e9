#include "core/path/word_origin.h"

#include "core/base/assert.h"

namespace proveout {
namespace {

struct KindRow {
  std::string_view name;
  bool coordinate = false, length = false;
};
constexpr KindRow coordinate(std::string_view name, bool length) { return {name, true, length}; }
constexpr KindRow length(std::string_view name) { return {name, false, true}; }
constexpr KindRow plain(std::string_view name) { return {name}; }

/// In the order of OriginKind.
constexpr std::array<KindRow, kOriginKinds + 4> kRows{{
    coordinate("X", true),
    coordinate("Y", true),
    coordinate("Z", true),
    coordinate("A", false),
    coordinate("B", false),
    coordinate("C", false),
    coordinate("U", true),
    coordinate("V", true),
    coordinate("W", true),
    coordinate("further axis", false),
    length("I"),
    length("J"),
    length("K"),
    length("radius of the arc"),
    plain("direction of the line"),
    length("chamfer or rounding"),
    plain("cycle"),
    coordinate("depth of the cycle", true),
    coordinate("R plane of the cycle", true),
    length("step of the cycle"),
    length("shift of the cycle"),
    plain("return of the cycle"),
    length("allowance"),
    plain("contour"),
    plain("tool"),
    plain("next tool"),
    plain("H"),
    plain("length compensation"),
    plain("D"),
    plain("cutter compensation"),
    plain("work offset"),
    plain("shift of the coordinates"),
    plain("units"),
    plain("absolute or incremental"),
    plain("plane"),
    plain("mirroring"),
    plain("scaling"),
    plain("rotation"),
    plain("polar data"),
    plain("virtual plane"),
    plain("diameter programming"),
    plain("motion code"),
    plain("feed"),
    plain("feed mode"),
    length("lead"),
    plain("spindle speed"),
    plain("spindle speed mode"),
    plain("spindle direction"),
    plain("variable"),
    plain("argument"),
    plain("table value"),
    plain("call"),
}};
static_assert(kRows.back().name == "call");

const KindRow& row(OriginKind kind) { return kRows[static_cast<std::size_t>(kind)]; }

}  // namespace

std::string_view originKindName(OriginKind kind) { return row(kind).name; }
bool isCoordinate(OriginKind kind) { return row(kind).coordinate; }
bool isLength(OriginKind kind) { return row(kind).length; }

OriginCode OriginTables::code(std::int32_t index, OriginKind kind) const {
  const auto k = static_cast<std::size_t>(kind);
  if (index < 0 || k >= kOriginKinds) return {};
  PROVEOUT_ASSERT(static_cast<std::size_t>(index) < sets.size());
  const OriginSet& set = sets[static_cast<std::size_t>(index)];
  PROVEOUT_ASSERT(set.modal < modal.size());
  return k < set.axis.size() ? set.axis[k] : modal[set.modal].code[k - set.axis.size()];
}

std::size_t OriginTables::bytes() const {
  std::size_t sum = words.size() * sizeof(WordOrigin) + data.size() * sizeof(DataInForce) +
                    modal.size() * sizeof(ModalOrigins) + sets.size() * sizeof(OriginSet);
  for (const WordOrigin& word : words) sum += word.from.size() * sizeof(word.from.front());
  return sum;
}

}  // namespace proveout
