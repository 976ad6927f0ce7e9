// Settings of a control that are no numbers: texts, files and tables of `[control.NAME]`.
#pragma once

#include <string>
#include <vector>

#include "io/job/config_table.h"
#include "io/job/job.h"

namespace proveout {

/// Reads them into ControlSettings::texts, and folders into the job's places of subprograms.
class ControlTexts {
 public:
  /// All but the name of the control must outlive the reader.
  ControlTexts(const ConfigDocument& document, const JobNames& names, const std::string& control, Job& job);
  /// The entry of `[control.NAME]`, if it is one of these settings. False: it is another one. What is wrong
  /// with it is an error of the document.
  bool take(const ConfigEntry& entry);

 private:
  void takeFile(const ConfigEntry& entry, const TextSetting& setting);
  void takeFolders(const ConfigEntry& entry);
  void takeTable(const ConfigEntry& entry);
  void takeNamed(const ConfigEntry& entry, const std::string& folder, const std::string& name,
                 const std::string& path);

  const ConfigDocument& document_;
  Job& job_;
  std::vector<TextSetting> settings_;
};

}  // namespace proveout
