// The system variables of a channel.
#pragma once

#include "core/nc/nct/system_variables/frame_bank.h"
#include "core/nc/nct/system_variables/message_bank.h"
#include "core/nc/nct/system_variables/modal_bank.h"
#include "core/nc/nct/system_variables/plc_bank.h"
#include "core/nc/nct/system_variables/position_bank.h"
#include "core/nc/nct/system_variables/status_bank.h"
#include "core/nc/nct/system_variables/tool_offset_bank.h"
#include "core/nc/nct/tools/tools.h"

namespace proveout::nc {

/// All banks, known to the variables of the context by number and by name. One a channel; the context
/// must outlive it.
class SystemVariables {
 public:
  explicit SystemVariables(NctContext& context);

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

}  // namespace proveout::nc
