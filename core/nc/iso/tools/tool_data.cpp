// G10 L75, L76, L77: the tables of tool management, filled by programs (manual 12.4).
#include <fmt/core.h>

#include <cmath>

#include "core/nc/iso/context/words.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {
namespace {

constexpr double kMaxCount = 99999999.0;

/// An integer of the block, if it is there. False: reported.
bool integer(IsoContext& c, Address a, std::int64_t min, std::int64_t max, int& out) {
  const Word* w = c.word(a);
  std::int64_t value = 0;
  if (w == nullptr) return true;
  if (!integerWord(c, *w, min, max, value)) return false;
  out = static_cast<int>(value);
  return true;
}
/// An integer that the block must have.
bool neededInteger(IsoContext& c, Address a, std::int64_t min, std::int64_t max, int& out) {
  if (c.word(a) == nullptr) return c.alarm(SharedAlarm::kMissingData, addressText(a), "in tool data");
  return integer(c, a, min, max, out);
}

bool number(IsoContext& c, Address a, double max, double& out) {
  const Word* w = c.word(a);
  if (w == nullptr) return true;
  if (!(w->value >= 0.0 && w->value <= max))
    return c.alarm(SharedAlarm::kOutOfRange, *w, fmt::format("from 0 to {}", max));
  out = w->value;
  return true;
}

/// A word of 0 and 1, the highest bit first: Q10001. False: reported.
bool bits(IsoContext& c, const Word& w, int count, unsigned& out) {
  double left = w.value;
  unsigned value = 0;
  for (int k = 0; k < count && w.is_integer && left >= 0.0; ++k, left = std::floor(left / 10.0)) {
    const double digit = std::fmod(left, 10.0);
    if (digit > 1.0) return c.alarm(SharedAlarm::kOutOfRange, w, "digits 0 and 1");
    if (digit == 1.0) value |= 1u << k;
  }
  if (!w.is_integer || left != 0.0)
    return c.alarm(SharedAlarm::kOutOfRange, w, fmt::format("up to {} digits 0 and 1", count));
  out = value;
  return true;
}

bool onlyWords(IsoContext& c, AddressSet legal) {
  for (const Word& w : c.block.words) {
    if (!legal.has(w.address)) return c.alarm(SharedAlarm::kIllegalAddress, w, "in tool data");
  }
  return true;
}

int rowCount(const IsoContext& c) { return static_cast<int>(c.parameters[ToolParam::kRows]); }

/// P0 R.. the user bits, P1 R.. and on the user values.
bool userData(IsoContext& c, ToolRow& row) {
  int index = 0;
  const Word* r = c.word('R');
  if (!integer(c, 'P', 0, static_cast<std::int64_t>(c.parameters[ToolParam::kUserColumns]), index))
    return false;
  if (r == nullptr) return c.alarm(SharedAlarm::kMissingData, "R", "the value of the column");
  if (index == 0) return bits(c, *r, 8, row.user_bits);
  row.user[static_cast<std::size_t>(index - 1)] = r->value;
  return true;
}

/// Fields of a row. False: reported.
bool rowData(IsoContext& c, ToolRow& row) {
  const auto offsets = static_cast<std::int64_t>(c.parameters[CompParam::kToolOffsets]);
  int status = static_cast<int>(row.status);
  const Word* q = c.word('Q');
  const bool good = integer(c, 'T', 0, 99999999, row.type) && (q == nullptr || bits(c, *q, 5, row.info)) &&
                    integer(c, 'A', 0, 20, row.shape) && integer(c, 'B', 0, 4, status) &&
                    number(c, 'C', kMaxCount, row.counter) && number(c, 'L', kMaxCount, row.limit) &&
                    number(c, 'I', kMaxCount, row.warning) && integer(c, 'H', 0, offsets, row.length_row) &&
                    integer(c, 'D', 0, offsets, row.radius_row) &&
                    integer(c, 'J', 0, offsets, row.geometry_row) &&
                    integer(c, 'K', 0, offsets, row.wear_row) && number(c, 'S', kMaxCount, row.speed) &&
                    number(c, 'F', 1e6, row.feed);
  row.status = static_cast<ToolStatus>(status);
  return good && (c.word('P') == nullptr || userData(c, row));
}

/// L75 P1 and P2: N opens a row, what follows fills it. The block changes the row whole or not at all.
bool rowBlock(IsoContext& c) {
  ToolInput& input = c.registers.tool_input;
  ToolTables& tools = c.registers.tools();
  if (!onlyWords(c, "NTQABCLIHDJKSFPR")) return false;
  if (c.word('R') != nullptr && c.word('P') == nullptr)
    return c.alarm(SharedAlarm::kMissingData, "P", "the number of the column");
  int row = input.row;
  if (!integer(c, 'N', 1, rowCount(c), row)) return false;
  if (row == 0) return c.alarm(SharedAlarm::kMissingData, "N", "the row of the tool table");
  const bool opens = c.word('N') != nullptr;
  const ToolRow* old = std::as_const(tools).row(row);
  ToolRow data = old == nullptr || (opens && input.clears) ? ToolRow{} : *old;
  if (!rowData(c, data)) return false;
  tools.addRow(row) = data;
  input.row = row;
  return true;
}

/// L75 P3: N deletes a row.
bool deletionBlock(IsoContext& c) {
  int row = 0;
  if (!onlyWords(c, "N") || !neededInteger(c, 'N', 1, rowCount(c), row)) return false;
  c.registers.tools().removeRow(row);
  return true;
}

/// L76 P1: N magazine, P pocket, R row.
bool placeBlock(IsoContext& c) {
  int magazine = 0, row = 0;
  ToolPlace place;
  if (!onlyWords(c, "NPR") || !neededInteger(c, 'N', 1, 91, magazine)) return false;
  const bool single = magazine >= 10;
  if (!(single ? magazine % 10 <= 1 : magazine <= 4)) {
    return c.alarm(SharedAlarm::kOutOfRange, *c.word('N'), "magazines are 1 to 4 and 10, 11, 20, 21, ... 91");
  }
  place.magazine = magazine;
  place.pocket = 1;
  if (!single && !neededInteger(c, 'P', 1, 9999, place.pocket)) return false;
  if (!neededInteger(c, 'R', 0, rowCount(c), row)) return false;
  c.registers.tools().place(place, row);
  if (magazine == 10 * c.channel()) c.state.tool_row = row;  // the channel's spindle
  return true;
}

/// A number of half pockets: P1.5 are three.
bool halfPockets(IsoContext& c, Address a, int& out) {
  double value = 0.0;
  if (!number(c, a, 99.0, value)) return false;
  if (std::floor(value) != value)
    return c.alarm(SharedAlarm::kOutOfRange, *c.word(a), "half pockets are whole numbers");
  out = static_cast<int>(value);
  return true;
}

/// L77 P6: N shape, P Q R S room to the left, right, up, down in half pockets, T 0 rectangular, 1 round.
bool shapeBlock(IsoContext& c) {
  int shape = 0, round = 0;
  ToolShape data;
  if (!onlyWords(c, "NPQRST") || !neededInteger(c, 'N', 1, 20, shape)) return false;
  if (!halfPockets(c, 'P', data.left) || !halfPockets(c, 'Q', data.right) || !halfPockets(c, 'R', data.up) ||
      !halfPockets(c, 'S', data.down) || !integer(c, 'T', 0, 1, round)) {
    return false;
  }
  data.round = round == 1;
  c.registers.tools().setShape(shape, data);
  return true;
}

struct InputForm {
  int l, p;
  DataInput block;
};
constexpr auto kForms = std::to_array<InputForm>({
    {75, 1, rowBlock},
    {75, 2, rowBlock},
    {75, 3, deletionBlock},
    {76, 1, placeBlock},
    {77, 6, shapeBlock},
});

const InputForm* formOf(std::int64_t l, std::int64_t p) {
  for (const InputForm& form : kForms) {
    if (form.l == l && form.p == p) return &form;
  }
  return nullptr;
}

bool openToolInput(IsoContext& c, BlockPlan& plan) {
  const ToolTableInput& input = std::get<ToolTableInput>(plan.payload);
  c.registers.tool_input = {0, input.clears};
  c.data_input = input.block;
  return true;
}

}  // namespace

bool planToolInput(IsoContext& c, BlockPlan& plan) {
  const Word* p = c.ownWord(plan, 'P');
  std::int64_t l = 0, kind = 0;
  if (!integerWord(c, *c.word('L'), 0, 9999, l)) return false;
  if (p == nullptr) return c.alarm(SharedAlarm::kMissingData, "P", "which table G10 L75, L76, L77 fill");
  if (!integerWord(c, *p, 0, 9999, kind)) return false;
  const InputForm* form = formOf(l, kind);
  if (form == nullptr)
    return c.alarm(SharedAlarm::kOutOfRange, *p, "L75 has P1, P2 and P3, L76 has P1, L77 has P6");
  if (c.block.words.size() > 3)
    return c.alarm(SharedAlarm::kIllegalAddress, c.block.words[3], "tool data are opened by a block alone");
  plan.payload = ToolTableInput{form->p == 1, form->block};
  plan.perform = openToolInput;
  return true;
}

}  // namespace proveout::nc
