# Compiler settings of every proveout target.
#   proveout_options   flags that change code: no FMA contraction, so that every
#                      machine computes the same bits; sanitizers on request.
#   proveout_warnings  warnings for our own sources only.
add_library(proveout_options INTERFACE)
target_compile_options(proveout_options INTERFACE -ffp-contract=off)
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

# proveout_add_library(NAME SOURCES...) makes target proveout_NAME and alias proveout::NAME.
function(proveout_add_library name)
  add_library(proveout_${name} STATIC ${ARGN})
  add_library(proveout::${name} ALIAS proveout_${name})
  set_target_properties(proveout_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(proveout_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/proveout>)
  target_link_libraries(proveout_${name} PRIVATE $<BUILD_INTERFACE:proveout_warnings>
                                         PUBLIC proveout_options)
  proveout_precompile(proveout_${name})
  set_target_properties(proveout_${name} PROPERTIES UNITY_BUILD ${PROVEOUT_UNITY} UNITY_BUILD_BATCH_SIZE 6)
endfunction()
