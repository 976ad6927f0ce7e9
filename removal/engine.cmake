proveout_add_library(removal
  sweep.cpp
  blank_field.cpp
  blank.cpp
  blank_mesh.cpp
  stock.cpp
  stock_file.cpp
  remove.cpp
  pass.cpp
  column_sweep.cpp
  column_baseline.cpp
  column_avx2.cpp
  column_avx512.cpp
  leaf_changes.cpp
  leaf_cutter.cpp
  leaf_crossings.cpp
  level_cut.cpp
  cell_cycles.cpp
  cell_vertex.cpp
  quad_volume.cpp
  surface.cpp
  surface_grid.cpp)
target_link_libraries(proveout_removal PUBLIC proveout::core PRIVATE proveout_openvdb TBB::tbb fmt::fmt)

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
