=== about
Already in contact: no motion, the position is stored. Nothing to touch here at all: a note, once, and the end point.
proves: nct-21.1-G31
=== settings
probe = box -5 -5 -5 5 5 5
=== main
F100
G31 X20
#100=#5061+3
G0 X#100
G0 X30
G31 X60
G0 Y#5061
G31
M30
=== truth
3 0 0
30 0 0
probe 60 0 0
60 60 0
=== expect
file 0 main.nc
2: event probe contact=true
4: rapid from 0 0 0 to 3 0 0 t0.012
5: rapid to 30 0 0 t0.108
6: probe to 60 0 0 F100 t18
6: event probe contact=false
7: rapid to 60 60 0 t0.24
main.nc:8:1: warning[nct-2004]: no axis is named: no motion
    G31
    ^~~
9: event end code="M30"
end of program: 9 blocks, 4 motions, 0 errors, 1 warnings
