target_sources(proveout_core PRIVATE
  nc/program_source.cpp)
include(nc/services/sources.cmake OPTIONAL)
