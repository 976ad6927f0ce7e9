// #3000, #3006, #3106, #3107: alarms and messages of programs (manual 23.1.8).
#pragma once

#include <string>

#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

/// #3000=nnn(TEXT) ends the run with an alarm, #3006 stops with a message and goes on, #3106 shows one,
/// #3107 asks: its answer is that of the person at the machine, OK or yes unless told otherwise.
class MessageBank : public VariableBank {
 public:
  /// `boxes`: #3106 and #3107 are there.
  explicit MessageBank(IsoContext& context, bool boxes = true) : c_(context), boxes_(boxes) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int number, const Value& value) override;
  bool takesText(int) const override { return true; }

 private:
  bool textOf(std::string_view note, bool with_values, std::string& out);
  VariableStatus raise(int number, const std::string& text);
  VariableStatus send(const char* kind, int number, std::string code, const std::string& text, int answer);

  IsoContext& c_;
  bool boxes_;
  int answer_ = 0;  ///< of the last message box
};

}  // namespace proveout::nc
