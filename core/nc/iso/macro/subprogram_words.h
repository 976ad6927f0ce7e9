// Words of a block that call subprograms because parameters say so: M codes and letters
// (manual 23.3.6-23.3.8).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/nc/iso/model/call_stack.h"
#include "core/nc/iso/model/program_store.h"

namespace proveout::nc {

struct IsoContext;

/// May an assigned code call here (manual 23.3.4-23.3.8)? Inside the program that it started it may not;
/// inside other system programs only where N1755 ENC says so, and never a G code inside one of a G code.
bool mayCall(const IsoContext& c, std::int32_t code);

/// What was loaded becomes the program of the frame. False: it was not found or cannot be read, reported.
bool takeProgram(IsoContext& c, const ProgramStore::Loaded& loaded, CallFrame& frame);

/// Those of the block in hand.
class SubprogramWords {
 public:
  /// Does a word of the block call a subprogram?
  static bool any(const IsoContext& c);
  /// Takes them out of the block. False: a program was not found or there are too many, reported.
  bool take(IsoContext& c);
  /// Puts their calls off until the block is done.
  void defer(IsoContext& c) const;

 private:
  struct Taken {
    CallFrame frame;
    Value value;
    int variable = 0;  ///< the global that gets the value; 0: none
  };
  std::array<Taken, 8> words_;
  std::size_t count_ = 0;
};

}  // namespace proveout::nc
