# The fuzz targets and what each is made of, for the fuzzer and for the replay of what it has kept.
set(PROVEOUT_FUZZ_TARGETS nct wl4 flexnc wedm template channels mesh stock job options)
set(PROVEOUT_FUZZ_LIBRARIES_mesh proveout::io proveout::removal proveout::compare)
set(PROVEOUT_FUZZ_LIBRARIES_stock proveout::removal proveout_openvdb)
set(PROVEOUT_FUZZ_LIBRARIES_job proveout_app)
set(PROVEOUT_FUZZ_LIBRARIES_options proveout_app)

function(proveout_fuzz_libraries program target)
  target_link_libraries(${program} PRIVATE proveout_warnings proveout::core ${PROVEOUT_FUZZ_LIBRARIES_${target}})
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})
  if(target MATCHES "mesh|stock")
    add_dependencies(${program} proveout_vdb)
  endif()
endfunction()
