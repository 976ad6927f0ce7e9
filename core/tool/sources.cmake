target_sources(proveout_core PRIVATE tool/tool.cpp tool/profile.cpp)
