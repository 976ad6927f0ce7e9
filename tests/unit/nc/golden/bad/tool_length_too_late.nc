=== about
The gauge lies 1 mm behind the window of N3005: the move ends there, 2104, and the offset stays.
proves: nct-21.3-G37
=== settings
H5 = 10
max_errors = 2
probe = plane 0 0 -1 -54
=== main
F100
G43 G0 Z100 H5
G37 Z50
G0 X#10005
M30
=== says
probe to 0 0 55
error[nct-2104]
rapid to 10 0 55
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 110 t0.44
3: rapid to 0 0 70 t0.16
3: probe to 0 0 55 F100 t9
3: event probe contact=false
main.nc:3:1: error[nct-2104]: probe position out of limits: the contact lies 6 mm behind where it should be, 5 allowed
    G37 Z50
    ^~~~~~~
4: rapid to 10 0 55 t0.04
5: event end code="M30"
end of program: 5 blocks, 4 motions, 1 errors, 0 warnings
