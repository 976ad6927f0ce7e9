// The INI file of a LinuxCNC machine.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proveout::nc {

/// Sections and names without regard to case. Of a name that stands twice all values are kept, in order.
class LcnIni {
 public:
  LcnIni() = default;
  explicit LcnIni(std::string_view text);

  /// The first value; nothing: there is none.
  std::optional<std::string> text(std::string_view section, std::string_view name) const;
  std::optional<double> number(std::string_view section, std::string_view name) const;
  const std::vector<std::string>* all(std::string_view section, std::string_view name) const;
  bool empty() const { return values_.empty(); }

 private:
  static std::string key(std::string_view section, std::string_view name);
  std::map<std::string, std::vector<std::string>> values_;
};

}  // namespace proveout::nc
