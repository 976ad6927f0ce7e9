=== about
What G12.1 needs: a plane with a rotary second axis, its zero, the linear axis off the centre, no compensation, a block of
its own.
proves: nct-4.5-G12.1 nct-4.5-comp nct-4.5-plane
=== settings
axis = C 4 rotary
D1 = 2
max_errors = 20
=== main
G0 X10 Y0
G12.1
G17 Y0 C0
G12.1
G17 X10 C5
G12.1
G17 X0 C0
G12.1
G0 X10
G12.1 X10
G12.1
G12.1
G41 D1 G1 X5 F100
G13.1
G40 X10
G13.1 M8
G13.1
M30
=== says
main.nc:2:1: error[nct-2088]
main.nc:4:1: error[nct-2088]
main.nc:6:1: error[nct-polar-start]
main.nc:8:1: error[nct-polar-start]
main.nc:10:1: error[nct-own-block]
main.nc:14:1: error[nct-virtual-comp]
main.nc:16:1: error[nct-own-block]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
main.nc:2:1: error[nct-2088]: illegal plane selection: a block G17, G18 or G19 with a linear and a rotary axis must stand before
    G12.1
    ^~~~~
main.nc:4:1: error[nct-2088]: illegal plane selection: the linear axis must be the first of the plane
    G12.1
    ^~~~~
5: rapid arc to 9.9619 0.8716 0 center 0 0 0 normal 0 0 1 sweep 5 C 0 to 5 t0.02
main.nc:6:1: error[nct-polar-start]: G12.1: axis C must stand at 0
    G12.1
    ^~~~~
7: rapid arc to 0 0 0 center 0 0 0 normal 0 0 1 sweep -5 C 5 to 0 t0.04
main.nc:8:1: error[nct-polar-start]: G12.1: axis X must not stand at 0
    G12.1
    ^~~~~
9: rapid to 10 0 0 C 0 to 0 t0.04
main.nc:10:1: error[nct-own-block]: G12.1 stands in a block of its own
    G12.1 X10
    ^~~~~~~~~
11: event virtual_plane code="G12.1" on=true axes="X C"
main.nc:12:1: warning[nct-virtual-on]: G12.1 is on already: no effect
    G12.1
    ^~~~~
main.nc:14:1: error[nct-virtual-comp]: G13.1 needs G40: cutter compensation is on
    G13.1
    ^~~~~
13: feed to 5 -2 0 C 0 to -21.8014 F100 t3.2311
15: feed to 10 0 0 C -21.8014 to 0 F100 t3.2311
main.nc:16:1: error[nct-own-block]: G13.1 stands in a block of its own
    G13.1 M8
    ^~~~~~~~
17: event virtual_plane code="G12.1" on=false axes="X C"
18: event end code="M30"
end of program: 18 blocks, 6 motions, 7 errors, 1 warnings
