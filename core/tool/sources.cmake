target_sources(proveout_core PRIVATE tool/tool.cpp tool/tool_solid.cpp tool/profile.cpp)
