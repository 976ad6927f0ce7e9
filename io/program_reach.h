// Where called programs may lie: what a program names must not lead out of the folders that the job names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace proveout {

/// Folders with all that is below them, and single files. Places are compared with symbolic links followed,
/// so that a link that the job names opens what it points to, and a link within a folder opens nothing
/// outside.
class ProgramReach {
 public:
  /// An empty path is the working folder. What cannot be resolved adds nothing.
  void addFolder(const std::filesystem::path& folder);
  void addFile(const std::filesystem::path& file);
  /// The folder `name` beside `folder`, and no other place to which a link of that name leads.
  void addSibling(const std::filesystem::path& folder, const std::string& name);

  /// Whether the file or folder, links followed, is one of those or below one. It need not exist: what is
  /// missing has no links.
  bool holds(const std::filesystem::path& place) const;

 private:
  std::vector<std::filesystem::path> roots_, files_;  ///< resolved
};

/// "C:/x.nc": names of controls with DOS and Windows file systems may begin with a drive.
bool namesDrive(const std::string& path);

}  // namespace proveout
