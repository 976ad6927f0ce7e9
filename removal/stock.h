// The stock: what is left of the blank. A narrow-band level set on a regular grid together with the exact
// crossings of the grid's edges with the surface, their normals and the motion that made each.
//
// Only the .cpp files behind this header see OpenVDB.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/path/toolpath.h"
#include "core/tool/tool.h"
#include "removal/stock_shape.h"

namespace proveout {

struct RemovalOptions {
  double resolution_mm = 0.2;  ///< grid spacing, > 0
  int threads = 0;             ///< 0: all cores
  double max_memory_gb = 0.0;  ///< refuse above it (exit 3); 0: what the machine has free
};

enum class ContactKind { kRapid, kShank, kHolder, kSpindleOff };
std::string_view contactKindName(
    ContactKind kind);  ///< "rapid_contact", "shank_contact", "holder_contact", "spindle_off"

/// The tool touched stock where it must not. One per unbroken run of motions with the same kind, tool and
/// program block.
struct Contact {
  ContactKind kind = ContactKind::kRapid;
  MotionId motion = kNoMotion;  ///< first motion of the contact
  Vec3 where = Vec3::Zero();    ///< deepest sampled point, mm
  /// Deepest penetration of stock by the part in question: exact at faces that the grid's vertical lines meet, at walls
  /// up to one grid step too small.
  double depth_mm = 0.0;
  double volume_mm3 = 0.0;      ///< stock that was in the way, counted in grid cells
};

struct RemovalSummary {
  std::vector<float> removed_mm3;  ///< per motion, counted in parts of grid cells; see fitRemovedVolume
  std::vector<Contact> contacts;   ///< in program order
  std::uint64_t voxel_evaluations = 0;
};

/// Scales the volumes of the motions so that their sum is the exact removed volume (initial less final, mm3).
void fitRemovedVolume(RemovalSummary& summary, double exact_total_mm3);

/// Surface of the stock as a closed 2-manifold, and the volume from the exact edge crossings.
struct StockSurface {
  TriMesh mesh;             ///< with `motion` per triangle
  double volume_mm3 = 0.0;  ///< integrated from the exact crossings
};

class Stock {
 public:
  Stock();
  ~Stock();
  Stock(Stock&&) noexcept;
  Stock& operator=(Stock&&) noexcept;

  /// Builds the blank. Errors: empty or non-finite shape, open mesh (names the place), unreadable .vdb,
  /// grid too large for the memory allowed (names the resolution that fits).
  static Result<Stock> create(const StockShape& shape, const RemovalOptions& options, Progress& progress);

  /// Cuts the path into the stock. `tools` must hold every tool number that the path uses.
  /// The result does not depend on `threads`. A cancelled run leaves the stock unspecified.
  Result<RemovalSummary> remove(const Toolpath& path, const std::vector<Tool>& tools,
                                const RemovalOptions& options, Progress& progress);

  Result<StockSurface> surface(int threads, Progress& progress) const;

  /// Writes grid, crossings and provenance; whole file or none.
  Status save(const std::string& path) const;

  double initialVolume() const;  ///< mm3, of the blank
  double resolution() const;     ///< mm
  Box3 bounds() const;           ///< of the blank, mm

  struct Impl;  ///< removal/stock_impl.h

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace proveout
