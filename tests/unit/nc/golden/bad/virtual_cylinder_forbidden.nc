=== about
What G7.1 excludes: planes, shifts, work systems, machine positions, centres of arcs, drilling cycles; and its conditions.
proves: nct-4.6-forbid nct-4.6-R nct-4.6-comp
=== settings
axis = A 4 rotary
axis = C 5 rotary
D1 = 2
max_errors = 30
=== main
G7.1 A20
G18 G0 X-20 A0
G7.1 C20
G7.1 A20 X1
G7.1 A-5
G7.1 X5
G7.1 A20
G17
G52 X1
G92 X1
G54
G53 X0
G81 X0 R1 Z-1
G2 X10 A30 I5 F100
G12.1
G41 D1 G1 X10 F100
G7.1 A0
G40 X0
G7.1 A0
M30
=== says
main.nc:1:1: error[nct-2088]
main.nc:3:6: error[nct-2088]
main.nc:4:1: error[nct-own-block]
main.nc:5:6: error[nct-2002]
main.nc:6:6: error[nct-2035]
main.nc:8:1: error[nct-virtual-forbidden]
main.nc:9:1: error[nct-virtual-forbidden]
main.nc:10:1: error[nct-virtual-forbidden]
main.nc:11:1: error[nct-virtual-forbidden]
main.nc:12:1: error[nct-virtual-forbidden]
main.nc:13:1: error[nct-virtual-forbidden]
main.nc:14:12: error[nct-2017]
main.nc:15:1: error[nct-virtual-forbidden]
main.nc:17:1: error[nct-virtual-comp]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2088]: illegal plane selection: a block G17, G18 or G19 with a linear and a rotary axis must stand before
    G7.1 A20
    ^~~~~~~~
2: rapid from 0 0 0 to -20 0 0 A 0 to 0 C 0 to 0 t0.08
main.nc:3:6: error[nct-2088]: illegal plane selection: the rotary axis of G7.1 is not in the plane
    G7.1 C20
         ^~~
main.nc:4:1: error[nct-own-block]: G7.1 takes a rotary axis with the radius of the cylinder, in a block of its own
    G7.1 A20 X1
    ^~~~~~~~~~~
main.nc:5:6: error[nct-2002]: A data out of range: the radius of the cylinder is not negative
    G7.1 A-5
         ^~~
main.nc:6:6: error[nct-2035]: wrong axis data X: G7.1 takes a rotary axis
    G7.1 X5
         ^~
7: event virtual_plane code="G7.1" on=true axes="X A" radius=20
main.nc:8:1: error[nct-virtual-forbidden]: G17 is not allowed during G7.1
    G17
    ^~~
main.nc:9:1: error[nct-virtual-forbidden]: G52 is not allowed during G7.1
    G52 X1
    ^~~~~~
main.nc:10:1: error[nct-virtual-forbidden]: G92 is not allowed during G7.1
    G92 X1
    ^~~~~~
main.nc:11:1: error[nct-virtual-forbidden]: G54 is not allowed during G7.1
    G54
    ^~~
main.nc:12:1: error[nct-virtual-forbidden]: G53 is not allowed during G7.1
    G53 X0
    ^~~~~~
main.nc:13:1: error[nct-virtual-forbidden]: G81 is not allowed during G7.1
    G81 X0 R1 Z-1
    ^~~~~~~~~~~~~
main.nc:14:12: error[nct-2017]: illegal address I: arcs during G7.1 are given by R
    G2 X10 A30 I5 F100
               ^~
main.nc:15:1: error[nct-virtual-forbidden]: G12.1 during G7.1
    G12.1
    ^~~~~
main.nc:17:1: error[nct-virtual-comp]: G7.1 needs G40: cutter compensation is on
    G7.1 A0
    ^~~~~~~
16: feed to 10 0 0 axis 0 0 1 to 0 0.0998 0.995 A 0 to -5.7296 C 0 to 0 F99.7785 t18.04
18: feed to 0 0 0 axis 0 0.0998 0.995 to 0 0 1 A -5.7296 to 0 C 0 to 0 F98.0581 t6.1188
19: event virtual_plane code="G7.1" on=false axes="X A"
20: event end code="M30"
end of program: 20 blocks, 3 motions, 14 errors, 0 warnings
