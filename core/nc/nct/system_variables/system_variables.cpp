#include "core/nc/nct/system_variables/system_variables.h"

#include "core/nc/nct/context/context.h"

namespace proveout::nc {

SystemVariables::SystemVariables(NctContext& context)
    : tools_(context),
      modal_(context),
      frames_(context),
      offsets_(context),
      positions_(context),
      plc_(context.host.person),
      status_(context),
      messages_(context) {
  VariableStore& store = context.variables;
  tools_.addTo(store);
  modal_.addTo(store);
  frames_.addTo(store);
  offsets_.addTo(store);
  positions_.addTo(store);
  plc_.addTo(store);
  status_.addTo(store);
  messages_.addTo(store);
}

}  // namespace proveout::nc
