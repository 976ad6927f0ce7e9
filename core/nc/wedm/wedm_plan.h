// Plans a block of the wire EDM control on a copy of the modal state (digest wedm, D4 to D10).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/nc/wedm/wedm_context.h"

namespace proveout::nc {

struct WedmCall {
  std::int64_t label = 0;
  int times = 1;
};

struct WedmPlan {
  explicit WedmPlan(const WedmState& state) : next(state) {}

  WedmState next;
  std::vector<const WedmGCode*> codes;
  std::vector<const WedmFunction*> functions;
  std::optional<WedmRecord> motion;
  std::optional<double> dwell_s;
  bool sets_point = false;  ///< G92
  std::optional<WedmCall> call;

  bool has(int g) const {
    for (const WedmGCode* code : codes) {
      if (code->code == g) return true;
    }
    return false;
  }
  bool has(char address, int number) const {
    for (const WedmFunction* f : functions) {
      if (f->address == address && f->code == number) return true;
    }
    return false;
  }
};

/// False: the block is bad, reported; variables may have been assigned.
bool planWedmBlock(WedmContext& c, WedmPlan& p);

// The steps of that, in files of their own.

/// Value of a word or an assignment; lengths mm. Errors: reported, none.
std::optional<double> wedmLength(WedmContext& c, const WedmState& s, const std::vector<WedmTerm>& terms,
                                 Columns at);
/// Seconds.
std::optional<double> wedmSeconds(WedmContext& c, const WedmState& s, const std::vector<WedmTerm>& terms,
                                  Columns at);
/// G92.
bool planWedmPoint(WedmContext& c, WedmPlan& p);
/// The motion, where the block has axis words.
bool planWedmMotion(WedmContext& c, WedmPlan& p);

}  // namespace proveout::nc
