proveout_add_library(removal
  sweep.cpp
  sweep_curve.cpp
  sweep_helix.cpp
  stock_depth.cpp
  blank_field.cpp
  placed_field.cpp
  process/milled_piece.cpp
  process/turned_piece.cpp
  blank.cpp
  stock.cpp
  vdb_loader.cpp
  remove.cpp
  pass.cpp
  pass_surface.cpp
  column_sweep.cpp
  body_index.cpp
  contact_depth.cpp
  contact_query.cpp
  contacts.cpp
  convex_cast.cpp
  column_baseline.cpp
  column_avx2.cpp
  column_avx512.cpp
  leaf_changes.cpp
  leaf_index.cpp
  leaf_cutter.cpp
  leaf_crossings.cpp
  narrow_cuts.cpp
  thin_walls.cpp
  turning/revolve.cpp
  turning/section_area.cpp
  turning/section_chains.cpp
  turning/section_depth.cpp
  turning/section_reach.cpp
  turning/section_window.cpp
  turning/slice_faces.cpp
  turning/slice_match.cpp
  turning/sweep_paths.cpp
  turning/thread_cover.cpp
  turning/thread_mesh.cpp
  turning/thread_slices.cpp
  turning/turned_stock.cpp
  turning/turning_tool.cpp
  level_cut.cpp
  moved_stock.cpp
  exact/swept_part.cpp
  cell_cycles.cpp
  cell_faces.cpp
  cell_vertex.cpp
  exact_faces.cpp
  quad_volume.cpp
  surface.cpp
  surface_clusters.cpp
  surface_faults.cpp
  surface_grid.cpp
  surface_intersections.cpp
  surface_mend.cpp
  surface_merge.cpp
  surface_quads.cpp
  surface_sharpen.cpp
  surface_splits.cpp
  vertex_refiner.cpp)
# Eigen's checks of indices cost a twentieth of meshing; the dev and sanitizer presets have them.
target_compile_options(proveout_removal PRIVATE $<$<CONFIG:Release>:-O3>)
# Position independent code calls its own functions by way of tables, in case another library replaces them, which
# none does; errno and floating-point traps of mathematics nobody reads. No result changes.
foreach(library proveout_removal proveout_core)
  target_compile_options(${library} PRIVATE -fno-semantic-interposition -fno-math-errno -fno-trapping-math)
endforeach()
target_compile_definitions(proveout_removal PRIVATE $<$<CONFIG:Release>:EIGEN_NO_DEBUG>)
target_link_libraries(proveout_removal PUBLIC proveout::core PRIVATE TBB::tbb fmt::fmt proveout_polyclipping ${CMAKE_DL_LIBS})

# One source for every SIMD level, chosen at run time. No option here may change a result: no contraction, no
# reassociation; the two below only free the compiler from errno and floating-point traps, which nobody reads.
# The compiler cannot see that the loops over parts of an array run before it is read.
set(kernel_options -O3 -fno-math-errno -fno-trapping-math -Wno-maybe-uninitialized)
set_source_files_properties(column_baseline.cpp PROPERTIES COMPILE_OPTIONS "${kernel_options}")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  set_source_files_properties(column_avx2.cpp PROPERTIES COMPILE_OPTIONS "${kernel_options};-mavx2")
  set_source_files_properties(column_avx512.cpp PROPERTIES
    COMPILE_OPTIONS "${kernel_options};-mavx512f;-mavx512dq;-mavx512vl;-mprefer-vector-width=512")
endif()

# Everything that needs OpenVDB is a module, loaded when it is asked for (see vdb_support.h); it has its own copy of core
# and removal, which must be position independent for that.
set_target_properties(proveout_core proveout_removal PROPERTIES POSITION_INDEPENDENT_CODE ON)
add_library(proveout_vdb MODULE vdb_module.cpp stock_file.cpp blank_mesh.cpp)
target_link_libraries(proveout_vdb PRIVATE proveout_warnings proveout::removal proveout_openvdb TBB::tbb fmt::fmt)
set_target_properties(proveout_vdb PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/proveout
  CXX_VISIBILITY_PRESET default)
target_link_options(proveout_vdb PRIVATE -Wl,--exclude-libs,ALL)
include(GNUInstallDirs)
set_source_files_properties(vdb_loader.cpp PROPERTIES COMPILE_DEFINITIONS
  "PROVEOUT_LIBDIR=\"${CMAKE_INSTALL_LIBDIR}\";PROVEOUT_FULL_LIBDIR=\"${CMAKE_INSTALL_FULL_LIBDIR}\"")
