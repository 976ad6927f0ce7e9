=== about
The plane with the rotary axis outlives G13.1: circles need another one. G12.1 in a plane of linear axes is an illegal plane.
proves: nct-4.5-plane nct-4.5-G13.1
=== settings
axis = C 4 rotary
max_errors = 5
=== main
G17 G0 X10 C0
G12.1
G13.1
G2 X5 Y5 R10 F100
G17 X10 Y0
G12.1
M30
=== says
error[nct-2015]
error[nct-2088]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
2: event virtual_plane code="G12.1" on=true axes="X C"
3: event virtual_plane code="G12.1" on=false axes="X C"
main.nc:4:1: error[nct-2015]: circle definition error: the plane has the rotary axis C, named beside G17, G18 or G19: circles need linear axes
    G2 X5 Y5 R10 F100
    ^~~~~~~~~~~~~~~~~
main.nc:6:1: error[nct-2088]: illegal plane selection: a block G17, G18 or G19 with a linear and a rotary axis must stand before
    G12.1
    ^~~~~
7: event end code="M30"
end of program: 7 blocks, 1 motions, 2 errors, 0 warnings
