#include "core/nc/wedm/wedm_context.h"

namespace proveout::nc {

std::vector<LoopBudget::Named> WedmContext::loopState() const {
  std::vector<LoopBudget::Named> named;
  for (int h = 0; h < kWedmOffsets; ++h) {
    if (variables.assigned(h)) named.push_back({fmt::format("H{}", h), variables.value(h)});
  }
  named.push_back({"X", state.main.x()});
  named.push_back({"Y", state.main.y()});
  named.push_back({"U", state.uv.x()});
  named.push_back({"V", state.uv.y()});
  return named;
}

}  // namespace proveout::nc
