=== about
G54.1 with its P among motion words.
proves: nct-10.2.2-G54.1
=== main
G10 L20 P16 X5 Y-5 Z1
G0 G54.1 P16 X100 Y20
M30
=== truth
105 15 0
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 105 15 0 t0.42
3: event end code="M30"
end of program: 3 blocks, 1 motions, 0 errors, 0 warnings
