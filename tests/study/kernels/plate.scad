// The plate of milled_part.cpp as OpenSCAD exports it: openscad -D chord=0.02 -o plate.stl plate.scad
chord = 0.02;
function facets(r) = max(8, 4 * ceil(180 / acos(1 - chord / r) / 4));
module upright(x, y, z, r, h) translate([x, y, z]) cylinder(r = r, h = h, $fn = facets(r));
module rounded(x0, y0, x1, y1, z0, z1, r)
  hull() for (x = [x0 + r, x1 - r], y = [y0 + r, y1 - r]) upright(x, y, z0, r, z1 - z0);
module slot(x0, x1, y, z, r) hull() for (x = [x0, x1]) translate([x, y, z]) sphere(r = r, $fn = facets(r));
module pocket(x, y) translate([x, y, 0]) rotate_extrude($fn = facets(6)) union() {
  translate([0, -2]) square([6, 5]);
  translate([0, -3]) square([5, 2]);
  translate([5, -2]) circle(r = 1, $fn = facets(1));
}
tip = 2.5 / tan(59);
difference() {
  union() {
    translate([0, 0, -16]) cube([60, 40, 10]);
    rounded(5, 5, 55, 35, -8, 0, 5);
  }
  rounded(14, 15, 30, 25, -4, 3, 3);
  for (at = [[12, 11], [48, 11], [48, 29], [12, 29]]) upright(at[0], at[1], -20, 2.5, 23);
  translate([36, 11, -10]) cylinder(r1 = 0, r2 = 2.5, h = tip, $fn = facets(2.5));
  upright(36, 11, -10 + tip, 2.5, 13 - tip);
  slot(20, 40, 31, 1, 3);
  slot(20, 30, 8.5, 2, 3);
  pocket(43, 20);
  for (x = [12, 48]) translate([x, 11, -2]) cylinder(r1 = 2, r2 = 6, h = 4, $fn = facets(6));
}
