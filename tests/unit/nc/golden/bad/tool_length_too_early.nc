=== about
The gauge answers 6 mm too early: 2104, the offset stays.
Truth: rapid to 50 + N3004 + H = 70; the material answers at Z66, the tip is at 56 then: 6 off, 5 allowed; H stays 10.
proves: nct-21.3-G37
=== settings
H5 = 10
max_errors = 2
probe = plane 0 0 -1 -66
=== main
F100
G43 G0 Z100 H5
G37 Z50
G0 X#10005
M30
=== truth
rapid 0 0 110
rapid 0 0 70
probe 0 0 66 F 100 t 2.4
rapid 10 0 66
=== says
event probe contact=true
main.nc:3:1: error[nct-2104]: probe position out of limits: 6 mm
4 motions, 1 errors
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 0 0 110 t0.44
3: rapid to 0 0 70 t0.16
3: probe to 0 0 66 F100 t2.4
3: event probe contact=true
main.nc:3:1: error[nct-2104]: probe position out of limits: 6 mm from where it should be, 5 allowed
    G37 Z50
    ^~~~~~~
4: rapid to 10 0 66 t0.04
5: event end code="M30"
end of program: 5 blocks, 4 motions, 1 errors, 0 warnings
