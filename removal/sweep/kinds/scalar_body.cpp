#include "removal/sweep/kinds/scalar_body.h"

#include <atomic>

namespace proveout {

std::uint64_t nextPieceId() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace proveout
