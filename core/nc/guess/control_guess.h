// Which control a program looks like: by signs that its words, comments and name show, each with a weight.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/nc/control/control_info.h"

namespace proveout {

/// One control that a program may be for.
struct ControlGuess {
  std::string control;  ///< name, as in ControlInfo
  std::string flavour;  ///< word of the control's setting `flavour`; empty: its default, or it has none
  int weight = 0;       ///< sum of the signs: above 0 what speaks for it, below what speaks against it
  std::vector<std::string> reasons;  ///< what speaks for it, heaviest first, with words and lines
  std::vector<std::string> doubts;   ///< what speaks against it, the same

  /// "fanuc-mill" or "fanuc-mill (flavour haas)".
  std::string name() const;
};

struct GuessedControl {
  std::optional<ControlGuess> chosen;  ///< none: nothing in the program tells enough
  std::vector<ControlGuess> ranked;    ///< the best of each control that is built, best first
  std::string foreign;  ///< the language of a control that is none of ours, with what shows it; else empty

  /// Of a choice: "fanuc-mill: length offset with H (line 9: G43 Z15. H1); ...", at most three reasons.
  std::string choiceText() const;
  /// Of a refusal: what it is, or the two best with their reasons, and what to do.
  std::string refusalText() const;
};

/// `file_name`: of the program, for its extension; may be empty. `text`: its bytes, in any encoding that
/// writes letters as ASCII does. Looks at the first 100,000 lines. Chooses nothing unless one control leads
/// all others clearly: a wrong guess is worse than none.
GuessedControl guessControl(std::string_view file_name, std::string_view text);

/// The flavour that `guess` names, as the value of the control's parameter `flavour`; nothing: it has none.
std::optional<double> flavourValue(ControlId control, std::string_view flavour);

}  // namespace proveout
