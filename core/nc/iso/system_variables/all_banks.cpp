#include "core/nc/iso/system_variables/all_banks.h"

#include "core/nc/iso/context/context.h"
#include "core/nc/iso/system_variables/frame_bank.h"
#include "core/nc/iso/system_variables/message_bank.h"
#include "core/nc/iso/system_variables/modal_bank.h"
#include "core/nc/iso/system_variables/plc_bank.h"
#include "core/nc/iso/system_variables/position_bank.h"
#include "core/nc/iso/system_variables/status_bank.h"
#include "core/nc/iso/system_variables/tool_offset_bank.h"
#include "core/nc/iso/tools/tools.h"

namespace proveout::nc {
namespace {

class AllBanks final : public SystemVariables {
 public:
  explicit AllBanks(IsoContext& context)
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

 private:
  ToolBank tools_;
  ModalBank modal_;
  FrameBank frames_;
  ToolOffsetBank offsets_;
  PositionBank positions_;
  PlcBank plc_;
  StatusBank status_;
  MessageBank messages_;
};

}  // namespace

std::unique_ptr<SystemVariables> allBanks(IsoContext& context) { return std::make_unique<AllBanks>(context); }

}  // namespace proveout::nc
