=== about
A plane with a rotary axis holds no circles, no compensation and no polar data outside G12.1 and G7.1; two parallel
axes cannot be one axis of a plane.
proves: nct-4.5-plane
=== settings
axis = C 4 rotary
axis = U 5 linear parallel X
axis = U2 6 linear parallel X
max_errors = 9
D1 = 2
=== main
G17 G0 X10 C0
G2 X20 C10 R20 F100
G1 G41 D1 X30
G16 X10 C20
G17 U1 U2=1
M30
=== says
main.nc:2:1: error[nct-2015]
main.nc:3:1: error[nct-2088]
main.nc:4:1: error[nct-2088]
main.nc:5:8: error[nct-2088]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 C 0 to 0 t0.04
main.nc:2:1: error[nct-2015]: circle definition error: the plane has the rotary axis C, named beside G17, G18 or G19: circles need linear axes
    G2 X20 C10 R20 F100
    ^~~~~~~~~~~~~~~~~~~
main.nc:3:1: error[nct-2088]: illegal plane selection: the plane has the rotary axis C, named beside G17, G18 or G19: G41 and G42 need linear axes
    G1 G41 D1 X30
    ^~~~~~~~~~~~~
main.nc:4:1: error[nct-2088]: illegal plane selection: G16 needs a plane of linear axes
    G16 X10 C20
    ^~~~~~~~~~~
main.nc:5:8: error[nct-2088]: illegal plane selection: two parallel axes for one axis of the plane
    G17 U1 U2=1
           ^~~~
6: event end code="M30"
end of program: 6 blocks, 1 motions, 4 errors, 0 warnings
