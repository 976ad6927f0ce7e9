target_sources(proveout_core PRIVATE
  nc/frames.cpp
  nc/interpreter.cpp
  nc/lexer.cpp
  nc/path_emitter.cpp
  nc/program_source.cpp
  nc/source_text.cpp
  nc/nct/nct_block.cpp
  nc/nct/nct_codes.cpp
  nc/nct/nct_comp.cpp
  nc/nct/nct_control.cpp
  nc/nct/nct_cycles.cpp
  nc/nct/nct_execute.cpp
  nc/nct/nct_flow.cpp
  nc/nct/nct_frames.cpp
  nc/nct/nct_motion.cpp
  nc/nct/nct_parameters.cpp)
include(nc/services/sources.cmake OPTIONAL)
