target_sources(proveout_core PRIVATE
  nc/guess/candidates.cpp
  nc/guess/control_guess.cpp
  nc/guess/program_signs.cpp
  nc/guess/sign_line.cpp
  nc/guess/sign_table.cpp)
