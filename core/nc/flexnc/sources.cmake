target_sources(proveout_core PRIVATE
  nc/flexnc/cycle_checks.cpp
  nc/flexnc/cycle_moves.cpp
  nc/flexnc/cycles.cpp
  nc/flexnc/special_facing.cpp
  nc/flexnc/special_grooves.cpp
  nc/flexnc/special_thread.cpp
  nc/flexnc/special_worm.cpp
  nc/flexnc/template_arcs.cpp
  nc/flexnc/template_check.cpp
  nc/flexnc/template_passes.cpp
  nc/flexnc/template_profile.cpp
  nc/flexnc/template_table.cpp)
