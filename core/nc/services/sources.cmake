target_sources(proveout_core PRIVATE
  nc/services/arc_corner_comp.cpp
  nc/services/arcs.cpp
  nc/services/bell_profile.cpp
  nc/services/circular_pocket.cpp
  nc/services/contour/contour_clearance.cpp
  nc/services/contour/contour_corner.cpp
  nc/services/contour/contour_crossing.cpp
  nc/services/contour/contour_elements.cpp
  nc/services/contour/contour_offset.cpp
  nc/services/contour/contour_parallel.cpp
  nc/services/contour/contour_passes.cpp
  nc/services/contour/contour_profile.cpp
  nc/services/contour/contour_shift.cpp
  nc/services/cutter_comp.cpp
  nc/services/cutter_comp_check.cpp
  nc/services/cutter_comp_corner.cpp
  nc/services/cutter_comp_roll.cpp
  nc/services/drilling.cpp
  nc/services/outline_pocket.cpp
  nc/services/pocket.cpp
  nc/services/plane_curves.cpp
  nc/services/rapid_overlap.cpp
  nc/services/speed_plan.cpp
  nc/services/splines.cpp
  nc/services/stroke_font.cpp
  nc/services/surface_speed.cpp
  nc/services/virtual_plane.cpp
  nc/services/wire_offset.cpp
  nc/services/wire_taper.cpp
  nc/services/zone_check.cpp)
# These use a detail namespace as a whole, which must not leak into their neighbours of a unity batch.
set_source_files_properties(
  nc/services/cutter_comp.cpp nc/services/cutter_comp_check.cpp
  PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
