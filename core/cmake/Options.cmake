# Compiler settings of every proveout target.
#   proveout_options   flags that change code: no FMA contraction, so that every
#                      machine computes the same bits; no superword vectorizer of
#                      GCC, which leaves out roundings, where these are not made by
#                      core/geometry/to_float.h; sanitizers on request.
#   proveout_warnings  warnings for our own sources only.
# Hardening is core/cmake/Hardening.cmake.
add_library(proveout_options INTERFACE)
target_compile_options(proveout_options INTERFACE -ffp-contract=off)
# Eigen's inline functions are the same in all that is linked together.
target_compile_definitions(proveout_options INTERFACE $<$<CONFIG:Release>:EIGEN_NO_DEBUG>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Seen in 12.2: two doubles side by side that go to float and back are taken for what they were, by way of
  # Eigen's casts or of members; at -O3 three of them. Where all rounding is by core/geometry/to_float.h there is
  # nothing to take: proveout_round_by_to_float.
  target_compile_options(proveout_options INTERFACE
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:PROVEOUT_ROUNDS_BY_TO_FLOAT>>>:-fno-tree-slp-vectorize>)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/Hardening.cmake)
if(PROVEOUT_SANITIZE)
  target_compile_options(proveout_options INTERFACE
    -fsanitize=${PROVEOUT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(proveout_options INTERFACE -fsanitize=${PROVEOUT_SANITIZE})
endif()
if(PROVEOUT_DEAR_ASSERTIONS)
  target_compile_definitions(proveout_options INTERFACE $<BUILD_INTERFACE:PROVEOUT_DEAR_ASSERTIONS>)
endif()

add_library(proveout_warnings INTERFACE)
target_compile_options(proveout_warnings INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor)

# proveout_add_library(NAME [OWN_FLAGS] [BATCH n] SOURCES...) makes target proveout_NAME and alias proveout::NAME.
#   OWN_FLAGS  it gets compiler flags that others do not have
#   BATCH      so many sources are compiled together in a unity build
function(proveout_add_library name)
  cmake_parse_arguments(ARG "OWN_FLAGS" "BATCH" "" ${ARGN})
  if(NOT ARG_BATCH)
    set(ARG_BATCH 10)
  endif()
  add_library(proveout_${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
  add_library(proveout::${name} ALIAS proveout_${name})
  set_target_properties(proveout_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(proveout_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/proveout>)
  target_link_libraries(proveout_${name} PRIVATE $<BUILD_INTERFACE:proveout_warnings>
                                         PUBLIC proveout_options)
  if(ARG_OWN_FLAGS)
    proveout_precompile(proveout_${name})
  else()
    proveout_precompile(proveout_${name} FROM proveout_precompiled)
  endif()
  set_target_properties(proveout_${name} PROPERTIES UNITY_BUILD ${PROVEOUT_UNITY} UNITY_BUILD_BATCH_SIZE ${ARG_BATCH})
endfunction()

# proveout_round_by_to_float(TARGETS...): their sources round to float by core/geometry/to_float.h only (a test reads
# them; the compiler refuses to round by itself), so that they may have the superword vectorizer. Targets with
# precompiled headers of others have those targets' flags.
function(proveout_round_by_to_float)
  set_target_properties(${ARGN} PROPERTIES PROVEOUT_ROUNDS_BY_TO_FLOAT ON)
  foreach(target ${ARGN})
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Werror=float-conversion>)
  endforeach()
endfunction()
