// The rows of the types of tools, each with its source. A new type is a row here and in tool_type.cpp.
#pragma once

#include "core/tool/tool_type.h"

namespace proveout::tool_types {

extern const ToolTypeRow kFlat, kBall, kBull;  // end_mills.cpp
extern const ToolTypeRow kCone, kTaperBall;    // tapers.cpp
extern const ToolTypeRow kDrill;
extern const ToolTypeRow kDovetail;
extern const ToolTypeRow kTSlot;
extern const ToolTypeRow kLollipop;
extern const ToolTypeRow kThreadMill;
extern const ToolTypeRow kForm;
extern const ToolTypeRow kInsert;
extern const ToolTypeRow kWire;

}  // namespace proveout::tool_types
