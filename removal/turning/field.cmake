# Turned parts as blanks of the grid.
target_sources(proveout_removal PRIVATE
  turning/section_field.cpp
  turning/thread_field.cpp
  turning/thread_outline.cpp
  turning/turned_field.cpp)
