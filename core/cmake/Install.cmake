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
if(TARGET proveout_step)
  install(TARGETS proveout_step RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/proveout)
endif()

if(TARGET proveout_report_view)
  install(FILES ${PROJECT_BINARY_DIR}/lib/proveout/report_view.js DESTINATION ${CMAKE_INSTALL_LIBDIR}/proveout)
endif()

# Headers that a user of the libraries includes, with those that they include; the others are nobody's business
# outside.
foreach(folder core/base core/geometry core/machine core/path core/tool removal/process io render)
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/${folder} FILES_MATCHING PATTERN "*.h"
    REGEX "step/reader$" EXCLUDE)  # that sees OpenCASCADE
endforeach()
foreach(header
    core/mesh/cad_faces core/mesh/image core/mesh/mesh_placement core/mesh/tri_mesh
    core/nc/control/channel_program core/nc/control/control_host core/nc/control/control_info
    core/nc/control/control_settings core/nc/control/machine_event core/nc/control/program_source core/nc/control/run_summary
    core/nc/control/kept_data core/nc/control/text_settings
    core/nc/registry/coverage core/nc/registry/interpreter core/nc/text/template_set core/nc/text/template_text
    removal/grid/start_hole removal/grid/stock removal/grid/stock_shape removal/grid/vdb_tree removal/vdb/vdb_grids
    removal/turning/section/section removal/turning/turned_stock
    removal/wire/falls/body_exit removal/wire/falls/wire_holding removal/wire/lean/lean_solid
    removal/wire/lean/lean_stretch removal/wire/lean/level_section removal/wire/section/plane_region
    removal/wire/section/prism_blank removal/wire/section/wire_stretch removal/wire/wire_stock
    removal/compare/comparison removal/compare/compare removal/compare/exact_part removal/compare/nominal
    removal/compare/features/face_fit removal/compare/features/feature removal/compare/features/general_tolerance
    removal/compare/features/judgement removal/compare/fit/alignment removal/compare/fit/datums removal/compare/fit/fit
    removal/compare/fit/scan removal/compare/part/part_feature
    removal/compare/features/face_fit removal/compare/features/feature
    removal/compare/features/general_tolerance removal/compare/features/judgement removal/compare/fit/alignment
    removal/compare/part/part_feature
    app/session/forecast/prediction app/session/programs/interpretation app/session/run/blank
    app/session/run/interpreted app/session/run/job_defaults app/session/run/prepared_run
    app/session/run/recording_source app/session/run/run_result app/session/session)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header}.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/proveout/${folder})
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
