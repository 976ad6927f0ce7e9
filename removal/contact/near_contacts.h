// Contacts that the samples of the grid do not show: parts of tools that pass close by material are held
// against the faces of the stock.
#pragma once

#include <optional>

#include "removal/contact/stock_depth.h"
#include "removal/cut/leaf_cutter.h"

namespace proveout {

class NearContacts {
 public:
  /// `h`: spacing of the grid, mm. All must outlive this.
  NearContacts(const StockDepth& stock, const PassTable& table, double h)
      : stock_(stock), table_(table), h_(h) {}

  /// A point of the swept part that lies in the stock deeper than kContactToleranceMm, found from the
  /// sample's surroundings; its volume is 0. From many threads.
  std::optional<ContactSample> at(const NearSample& near) const;

 private:
  const StockDepth& stock_;
  const PassTable& table_;
  double h_;
};

}  // namespace proveout
