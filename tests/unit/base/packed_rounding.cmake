# No instruction in LIBRARIES rounds several doubles to floats at once: what GCC leaves out comes from roundings that it
# made one of, such as those in headers of other people, which the test of the sources (rounding_test.cpp) does not see.
foreach(library ${LIBRARIES})
  execute_process(COMMAND ${OBJDUMP} -d --no-show-raw-insn ${library} COMMAND grep -E "^[0-9a-f]+ <|cvtpd2ps"
    RESULT_VARIABLE result OUTPUT_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${library} could not be read")
  endif()
  string(REGEX MATCH "[^\n]*\n[^<\n]*cvtpd2ps[^\n]*" packed "${output}")
  if(packed)
    message(FATAL_ERROR "${library} rounds two doubles to floats at once; round with core/geometry/to_float.h:\n${packed}")
  endif()
endforeach()
