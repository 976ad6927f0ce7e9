# Its own library: CGAL::CGAL carries -frounding-math, which would keep other code from being vectorised.
proveout_add_library(compare
  compare.cpp
  deviation_patches.cpp
  deviation_statistics.cpp
  nominal.cpp
  sample_mesh.cpp
  signed_distance.cpp)
target_link_libraries(proveout_compare PUBLIC proveout::core PRIVATE CGAL::CGAL TBB::tbb fmt::fmt)
