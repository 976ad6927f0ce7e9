# The licences of what the program is linked with, installed with it. Each entry is NAME|PACKAGE: the text is that of the
# Debian package, whose name may be a pattern. README.md has the same list with what each library is for; a test holds it
# against what the built program loads (Program.LicencesAreNamed).
set(PROVEOUT_LINKED
  "boost|libboost1.*-dev" "c-library|libc6" "cgal|libcgal-dev" "cli11|libcli11-dev" "eigen|libeigen3-dev"
  "embree|libembree3-[0-9]*" "expat|libexpat1" "fmt|libfmt[0-9]*" "gcc-runtime|libstdc++6" "gmp|libgmp10" "imath|libimath-3-1-[0-9]*"
  "jemalloc|libjemalloc2" "minizip|libminizip1" "mpfr|libmpfr6" "nettle|libnettle[0-9]*" "nlohmann-json|nlohmann-json3-dev"
  "openvdb|libopenvdb[0-9]*" "png|libpng16-16" "polyclipping|libpolyclipping[0-9]*" "tbb|libtbb12"
  "tomlplusplus|libtomlplusplus-dev" "zlib|zlib1g"
  # What OpenVDB's library is linked with.
  "blosc|libblosc1" "boost-iostreams|libboost-iostreams1*" "bzip2|libbz2-1.0" "log4cplus|liblog4cplus-*" "lz4|liblz4-1"
  "lzma|liblzma5" "snappy|libsnappy1*" "zstd|libzstd1")
if(TARGET proveout_step)
  list(APPEND PROVEOUT_LINKED "opencascade|libocct-foundation-[0-9]*")
endif()
if(TARGET proveout_report_view)
  list(APPEND PROVEOUT_LINKED "three|libjs-three")
endif()
set(PROVEOUT_LICENCE_DIR ${CMAKE_INSTALL_DATADIR}/doc/proveout/licenses)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${PROVEOUT_LICENCE_DIR} RENAME proveout.txt COMPONENT licences)
foreach(entry IN LISTS PROVEOUT_LINKED)
  string(REPLACE "|" ";" entry ${entry})
  list(GET entry 0 name)
  list(GET entry 1 package)
  file(GLOB texts /usr/share/doc/${package}/copyright)
  if(texts)
    list(GET texts 0 text)
    install(FILES ${text} DESTINATION ${PROVEOUT_LICENCE_DIR} RENAME ${name}.txt COMPONENT licences)
  else()
    message(STATUS "No licence of ${name} (package ${package}) is found: it will not be installed")
  endif()
endforeach()
# Those texts name these.
foreach(common GPL-2 GPL-3 LGPL-2.1 LGPL-3 Apache-2.0 MPL-2.0)
  if(EXISTS /usr/share/common-licenses/${common})
    install(FILES /usr/share/common-licenses/${common} DESTINATION ${PROVEOUT_LICENCE_DIR}/common COMPONENT licences)
  endif()
endforeach()
