# Install tree and package config: find_package(proveout), then link proveout::core, ::removal, ::vdb_grids, ::compare, ::io,
# ::render or ::session.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(${CMAKE_CURRENT_LIST_DIR}/Licences.cmake)

set(PROVEOUT_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/proveout)
set(PROVEOUT_EXPORTED proveout_options)
set_target_properties(proveout_options PROPERTIES EXPORT_NAME options)
foreach(library core removal vdb_grids compare io render session)
  if(TARGET proveout_${library})
    list(APPEND PROVEOUT_EXPORTED proveout_${library})
  endif()
endforeach()

install(TARGETS ${PROVEOUT_EXPORTED} EXPORT proveoutTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS proveout_vdb LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/proveout)
if(TARGET proveout)
  install(TARGETS proveout RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

# Headers that a user of the libraries includes; the others are nobody's business outside.
foreach(folder core/base core/geometry core/path core/tool core/nc)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/${folder} FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES core/mesh/tri_mesh.h core/mesh/mesh_placement.h core/mesh/image.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/core/mesh)
install(FILES removal/grid/start_hole.h removal/grid/stock.h removal/grid/stock_shape.h removal/grid/vdb_tree.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/removal/grid)
install(FILES removal/vdb/vdb_grids.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/removal/vdb)
install(DIRECTORY removal/process/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/removal/process
        FILES_MATCHING PATTERN "*.h")
install(FILES removal/turning/section.h removal/turning/turned_stock.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/removal/turning)
install(FILES removal/wire/body_exit.h removal/wire/lean_solid.h removal/wire/lean_stretch.h
              removal/wire/level_section.h removal/wire/plane_region.h removal/wire/wire_holding.h
              removal/wire/wire_stock.h removal/wire/wire_stretch.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/removal/wire)
install(FILES removal/compare/compare.h removal/compare/exact_part.h removal/compare/nominal.h
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/removal/compare)
foreach(folder io render)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/${folder} FILES_MATCHING PATTERN "*.h")
endforeach()

foreach(header blank interpretation job_defaults prediction run_result session)
  install(FILES app/session/${header}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/app/session)
endforeach()

install(EXPORT proveoutTargets NAMESPACE proveout:: DESTINATION ${PROVEOUT_PACKAGE_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/proveoutConfig.cmake.in
  ${PROJECT_BINARY_DIR}/proveoutConfig.cmake INSTALL_DESTINATION ${PROVEOUT_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/proveoutConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/proveoutConfig.cmake ${PROJECT_BINARY_DIR}/proveoutConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/Dependencies.cmake
        DESTINATION ${PROVEOUT_PACKAGE_DIR})

# The consumer installs this build into a folder of the build tree and uses it from outside.
if(PROVEOUT_BUILD_TESTS)
  add_test(NAME Consumer.FindsTheInstalledPackage
    COMMAND ${CMAKE_COMMAND} -DBUILD=${PROJECT_BINARY_DIR} -DSOURCE=${PROJECT_SOURCE_DIR}/tests/consumer
            -DWORK=${PROJECT_BINARY_DIR}/consumer -DCOMPILER=${CMAKE_CXX_COMPILER}
            -DLAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER} -P ${PROJECT_SOURCE_DIR}/tests/consumer/run.cmake)
  set_tests_properties(Consumer.FindsTheInstalledPackage PROPERTIES TIMEOUT 300)
endif()
