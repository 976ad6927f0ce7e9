proveout_add_library(removal
  sweep.cpp
  blank_field.cpp
  blank.cpp
  blank_mesh.cpp
  stock.cpp
  stock_file.cpp
  remove.cpp
  leaf_cutter.cpp
  cell_cycles.cpp
  cell_vertex.cpp
  surface.cpp)
target_link_libraries(proveout_removal PUBLIC proveout::core PRIVATE proveout_openvdb TBB::tbb fmt::fmt)
