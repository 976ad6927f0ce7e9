target_sources(proveout_core PRIVATE mesh/tri_mesh.cpp mesh/mesh_topology.cpp)
