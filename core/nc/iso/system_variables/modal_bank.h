// #4000 to #4530: modal codes and words (manual 23.1.13, 23.1.14).
#pragma once

#include "core/nc/macro/variables.h"

namespace proveout::nc {

struct IsoContext;

struct IsoState;
class SourceText;

/// How a control tells codes and programs. Defaults: as nct does.
struct ModalRules {
  /// Of a group, in a state of the channel. Null: modalCode() of the family's.
  double (*code)(const IsoContext&, const IsoState&, int group) = nullptr;
  int groups = 39;
  int (*program)(const SourceText&) = nullptr;  ///< number of a program; null: by the name of its file
  /// #4115 is the program in hand; false: the one that was called last.
  bool program_in_hand = false;
};

/// Read-only. Last programmed and executing are the same here, since blocks run one after the other; only of
/// programs and extended work systems both are known. Variables of the interrupted block are vacant unless an
/// interrupt macro runs.
class ModalBank : public VariableBank {
 public:
  explicit ModalBank(const IsoContext& context, const ModalRules& rules = {}) : c_(context), rules_(rules) {}
  void addTo(VariableStore& store);
  VariableStatus read(int number, Value& out) override;
  VariableStatus write(int, const Value&) override { return VariableStatus::kReadOnly; }

 private:
  int numberOf(const SourceText& text) const;

  const IsoContext& c_;
  ModalRules rules_;
};

/// Number of a program by the name of its file: 11 of "O0011.nc"; 0 if it is not O and 1 to 8 digits.
int programNumber(std::string_view file_name);
/// A G code as these variables tell it: the digit behind the point in front of the number, 154 of G54.1.
double modalCode(int code10);

}  // namespace proveout::nc
