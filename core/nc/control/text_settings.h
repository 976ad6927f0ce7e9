// Settings of controls that are no numbers: texts, files, tables.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/nc/control/control_info.h"

namespace proveout {

/// A setting of a control that is no number (ControlSettings::texts).
struct TextSetting {
  enum class Kind : std::uint8_t {
    kText,     ///< as it stands
    kFile,     ///< a path: the setting is what the file says
    kFolders,  ///< a path or a list of them, where subprograms lie as well
    kTable     ///< a table of texts and numbers: "name.key" is a setting
  };
  std::string_view name;
  Kind kind = Kind::kText;
  std::string_view meaning;
  /// Settings that a kFile gives by naming files of its own: name of the setting, and path as seen from the
  /// file. Null: it names none.
  std::vector<std::pair<std::string, std::string>> (*files)(std::string_view text) = nullptr;
};

/// Those of a control; empty: it has none.
std::span<const TextSetting> textSettings(ControlId control);

}  // namespace proveout
