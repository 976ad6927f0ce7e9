target_sources(proveout_core PRIVATE
  nc/fanuc/alarms.cpp
  nc/fanuc/dialect.cpp
  nc/fanuc/fanuc_row.cpp
  nc/fanuc/formulas.cpp
  nc/fanuc/coverage/rows.cpp
  nc/fanuc/coverage/rows_cycles.cpp
  nc/fanuc/coverage/rows_haas.cpp
  nc/fanuc/coverage/rows_lathe.cpp
  nc/fanuc/coverage/rows_macro.cpp
  nc/fanuc/coverage/rows_text.cpp
  nc/fanuc/parameters/fanuc_parameters.cpp
  nc/fanuc/tables/comp.cpp
  nc/fanuc/tables/cycles.cpp
  nc/fanuc/tables/frames.cpp
  nc/fanuc/tables/macro.cpp
  nc/fanuc/tables/motion.cpp
  nc/fanuc/tables/transforms.cpp)
