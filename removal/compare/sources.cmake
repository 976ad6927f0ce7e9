proveout_add_library(compare
  compare/body_gap.cpp
  compare/compare.cpp
  compare/cracks.cpp
  compare/shape/curved_facets.cpp
  compare/deepest_point.cpp
  compare/deviation_patches.cpp
  compare/deviation_statistics.cpp
  compare/difference_volume.cpp
  compare/exact_part.cpp
  compare/features/boss_finder.cpp
  compare/features/dimensions.cpp
  compare/features/face_fits.cpp
  compare/features/face_network.cpp
  compare/features/feature.cpp
  compare/fit/datums.cpp
  compare/fit/fit.cpp
  compare/fit/model_frame.cpp
  compare/fit/point_cells.cpp
  compare/fit/scan.cpp
  compare/features/found_features.cpp
  compare/features/general_tolerance.cpp
  compare/features/hole_finder.cpp
  compare/features/judgement.cpp
  compare/features/measured_features.cpp
  compare/part/crests.cpp
  compare/part/inner_radius.cpp
  compare/part/part_feature.cpp
  compare/part/part_measure.cpp
  compare/part/wall_thickness.cpp
  compare/features/pocket_finder.cpp
  compare/features/recognition.cpp
  compare/features/single_faces.cpp
  compare/join_bodies.cpp
  compare/local_tolerance.cpp
  compare/measured_sides.cpp
  compare/shape/mesh_facets.cpp
  compare/nominal.cpp
  compare/shape/nominal_shape.cpp
  compare/point_deviation.cpp
  compare/sample_mesh.cpp
  compare/self_crossing.cpp
  compare/shape/shape_reader.cpp
  compare/shell_sides.cpp
  compare/spots.cpp
  compare/stray_facets.cpp)
# CGAL::CGAL carries -frounding-math, which would keep other code from being vectorised: one source has it.
add_library(proveout_boolean OBJECT compare/mesh_boolean.cpp)
target_include_directories(proveout_boolean PRIVATE ${PROJECT_SOURCE_DIR})
# CGAL's own headers make the compiler doubt.
target_compile_options(proveout_boolean PRIVATE -Wno-maybe-uninitialized)
target_link_libraries(proveout_boolean PRIVATE proveout_warnings proveout_options Eigen3::Eigen CGAL::CGAL)
target_sources(proveout_compare PRIVATE $<TARGET_OBJECTS:proveout_boolean>)
target_link_libraries(proveout_compare PUBLIC proveout::core PRIVATE $<LINK_ONLY:CGAL::CGAL> TBB::tbb fmt::fmt)
