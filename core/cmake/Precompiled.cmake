# What makes a clean build short. Both are off in the presets dev, asan and tsan, which so tell a source that forgets an
# include, and have all of the compiler's warnings.
#   PROVEOUT_PRECOMPILED_HEADERS  headers of other people that most sources read: parsed once a target, not once a source
#   PROVEOUT_UNITY                the sources of a library or test in batches: the templates that they share are compiled once
# A source with flags of its own (SIMD levels, CGAL's rounding) must not use them: SKIP_PRECOMPILE_HEADERS.
option(PROVEOUT_PRECOMPILED_HEADERS "Parse the headers of other libraries once a target" ON)
option(PROVEOUT_UNITY "Compile sources in batches" ON)
set(PROVEOUT_PRECOMPILED
  <algorithm> <array> <bit> <charconv> <cmath> <cstddef> <cstdint> <filesystem> <functional> <limits> <map> <memory>
  <numeric> <optional> <set> <span> <string> <string_view> <unordered_map> <utility> <variant> <vector>
  <Eigen/Geometry> <fmt/format.h>)
# With it GCC's output tells ccache what the precompiled header holds.
if(PROVEOUT_PRECOMPILED_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(proveout_options INTERFACE $<BUILD_INTERFACE:-fpch-preprocess>)
endif()

# proveout_precompile(TARGET [<header>...] [FROM OTHER]): its own precompiled headers with some more, or those of a target
# with the same flags.
function(proveout_precompile target)
  cmake_parse_arguments(ARG "" "FROM" "" ${ARGN})
  if(NOT PROVEOUT_PRECOMPILED_HEADERS)
    return()
  endif()
  if(ARG_FROM)
    target_precompile_headers(${target} REUSE_FROM ${ARG_FROM})
  else()
    target_precompile_headers(${target} PRIVATE ${PROVEOUT_PRECOMPILED} ${ARG_UNPARSED_ARGUMENTS})
  endif()
  # GCC 12 doubts operations of strings whose source it has read from a precompiled header.
  target_compile_options(${target} PRIVATE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>")
endfunction()

# Precompiled headers for all libraries without flags of their own.
if(PROVEOUT_PRECOMPILED_HEADERS)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")
  add_library(proveout_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(proveout_precompiled PRIVATE proveout_warnings proveout_options Eigen3::Eigen fmt::fmt)
  proveout_precompile(proveout_precompiled)
endif()

# proveout_apart(SOURCES...): compiled alone in a unity build, since they use names that others have for themselves, too.
function(proveout_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
