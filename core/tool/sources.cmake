target_sources(proveout_core PRIVATE
  tool/convex_outline.cpp tool/insert.cpp tool/insert_holder.cpp tool/outline.cpp tool/profile.cpp tool/tool.cpp tool/tool_option.cpp tool/tool_solid.cpp tool/tool_table.cpp)
