# Installs BUILD below WORK, builds the consumer in SOURCE against it and checks what it prints.
function(step name)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${name} failed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
step("install" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
step("configure" ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
     -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
step("build" ${CMAKE_COMMAND} --build ${WORK}/build)
step("run" ${WORK}/build/consumer)

# 20 x 20 x 10 less a slot 4 wide and 2 deep across: 3840 mm3, flat faces only.
if(NOT output STREQUAL "volume 3840.0 mm3, closed 1\n")
  message(FATAL_ERROR "the consumer printed: ${output}")
endif()
# The same slot; the tool ends in the clamp behind it.
step("session" ${WORK}/build/consumer_session)
if(NOT output STREQUAL "fixture_contact in N7\nvolume 3840.0 mm3, closed 1, progress 1\ncancelled 1\n")
  message(FATAL_ERROR "the consumer of the session printed: ${output}")
endif()
foreach(leftover IN ITEMS ${BUILD} ${SOURCE})
  file(STRINGS ${WORK}/prefix/lib/cmake/proveout/proveoutTargets.cmake hits REGEX "${leftover}/")
  if(hits)
    message(FATAL_ERROR "the exported targets name paths of the build: ${hits}")
  endif()
endforeach()
