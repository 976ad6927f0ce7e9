target_sources(proveout_core PRIVATE
  nc/linuxcnc/alarms.cpp
  nc/linuxcnc/dialect.cpp
  nc/linuxcnc/formulas.cpp
  nc/linuxcnc/linuxcnc_row.cpp
  nc/linuxcnc/coverage/rows.cpp
  nc/linuxcnc/coverage/rows_motion.cpp
  nc/linuxcnc/coverage/rows_text.cpp
  nc/linuxcnc/parameters/linuxcnc_parameters.cpp
  nc/linuxcnc/tables/motion.cpp)
