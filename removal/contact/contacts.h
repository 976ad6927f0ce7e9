// Contacts of a path with the stock, from what its watched passes met in the leaves.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "removal/contact/stock_depth.h"
#include "removal/cut/leaf_cutter.h"

namespace proveout {

/// What contacts are told of. The stock is as it was before the path; `record` holds its passes.
struct ContactScene {
  const Stock::Impl& stock;
  const StockDepth& depth;
  const Toolpath& path;
  const CutRecord& record;
  bool fixture = false;  ///< the stock is a fixture: every touch counts
};

/// Whether any motion of the path has the spindle on.
bool startsSpindle(const Toolpath& path);

/// One contact for each unbroken run of motions with the same kind, tool and block, in program order, with
/// the deepest point of what the tool's part sweeps. The order of `samples` does not count; a cancelled run
/// leaves contacts away.
std::vector<Contact> gatherContacts(const ContactScene& scene, std::vector<ContactSample> samples,
                                    Progress& progress);

}  // namespace proveout
