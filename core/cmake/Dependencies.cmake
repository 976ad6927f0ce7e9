# What the libraries and the program use: Debian 12 packages. Also installed, for the package config.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt 9 REQUIRED)
find_package(TBB REQUIRED)
find_package(Imath 3 REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(assimp REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)  # libpng-dev brings it
find_package(nlohmann_json 3 REQUIRED)

# OpenVDB's own find module asks for Boost.Iostreams headers that libopenvdb-dev does not pull in, so the
# library is looked up here by hand. An imported target, so that an export names it instead of its paths.
find_path(PROVEOUT_OPENVDB_INCLUDE openvdb/openvdb.h REQUIRED)
find_library(PROVEOUT_OPENVDB_LIBRARY openvdb REQUIRED)
if(NOT TARGET proveout_openvdb)
  add_library(proveout_openvdb INTERFACE IMPORTED GLOBAL)
  target_include_directories(proveout_openvdb SYSTEM INTERFACE ${PROVEOUT_OPENVDB_INCLUDE})
  target_link_libraries(proveout_openvdb INTERFACE ${PROVEOUT_OPENVDB_LIBRARY} TBB::tbb Imath::Imath)
endif()

# Nettle comes without a package config.
find_path(PROVEOUT_NETTLE_INCLUDE nettle/sha2.h REQUIRED)
find_library(PROVEOUT_NETTLE_LIBRARY nettle REQUIRED)
if(NOT TARGET proveout_nettle)
  add_library(proveout_nettle INTERFACE IMPORTED GLOBAL)
  target_include_directories(proveout_nettle SYSTEM INTERFACE ${PROVEOUT_NETTLE_INCLUDE})
  target_link_libraries(proveout_nettle INTERFACE ${PROVEOUT_NETTLE_LIBRARY})
endif()

# 3MF packages: ZIP archives of XML.
find_package(EXPAT REQUIRED)
find_path(PROVEOUT_MINIZIP_INCLUDE minizip/zip.h REQUIRED)
find_library(PROVEOUT_MINIZIP_LIBRARY minizip REQUIRED)
if(NOT TARGET proveout_minizip)
  add_library(proveout_minizip INTERFACE IMPORTED GLOBAL)
  target_include_directories(proveout_minizip SYSTEM INTERFACE ${PROVEOUT_MINIZIP_INCLUDE})
  target_link_libraries(proveout_minizip INTERFACE ${PROVEOUT_MINIZIP_LIBRARY})
endif()

# Polygon clipping (Clipper 6) comes with a pkg-config file only.
find_path(PROVEOUT_POLYCLIPPING_INCLUDE polyclipping/clipper.hpp REQUIRED)
find_library(PROVEOUT_POLYCLIPPING_LIBRARY polyclipping REQUIRED)
if(NOT TARGET proveout_polyclipping)
  add_library(proveout_polyclipping INTERFACE IMPORTED GLOBAL)
  target_include_directories(proveout_polyclipping SYSTEM INTERFACE ${PROVEOUT_POLYCLIPPING_INCLUDE})
  target_link_libraries(proveout_polyclipping INTERFACE ${PROVEOUT_POLYCLIPPING_LIBRARY})
endif()

set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE ON)
find_package(CGAL 5.5 REQUIRED QUIET)

if(NOT PROVEOUT_LIBRARIES_ONLY)
  # Reads STEP files, where it is installed (`make step`).
  find_package(OpenCASCADE QUIET CONFIG)
  find_package(CLI11 2 REQUIRED)
  find_path(PROVEOUT_TOMLPP_INCLUDE toml++/toml.h REQUIRED)
  find_library(PROVEOUT_JEMALLOC_LIBRARY jemalloc REQUIRED)
endif()
