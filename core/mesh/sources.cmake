target_sources(proveout_core PRIVATE
  geometry/box_tree.cpp
  mesh/corner_table.cpp
  mesh/crowded_places.cpp
  mesh/edge_collapser.cpp
  mesh/exact_meeting.cpp
  mesh/flat_triangles.cpp
  mesh/intersections.cpp
  mesh/level_cut.cpp
  mesh/mesh_editor.cpp
  mesh/mesh_placement.cpp
  mesh/mesh_simplifier.cpp
  mesh/mesh_topology.cpp
  mesh/shells.cpp
  mesh/signed_distance.cpp
  mesh/tri_mesh.cpp
  mesh/triangle_tree.cpp
  mesh/vertex_star.cpp)
