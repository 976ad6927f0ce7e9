target_sources(proveout_core PRIVATE
  machine/machine_chain.cpp
  machine/machine_model.cpp
  machine/reach.cpp
  machine/rotary_pair.cpp)
