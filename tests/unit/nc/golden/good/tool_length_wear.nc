=== about
TMW corrects the wear, TCA adds the difference; the tool comes from below and goes with the feed N0312; N3004 and N3005 set
the distances.
proves: nct-21.3-G37
=== settings
H5 = 10
N3003.TMW = 1
N3003.TCA = 1
N3003.TLF = 1
N0312 = 60
N3004 = 6
N3005 = 2
probe = plane 0 0 1 59.8
=== main
G43 G0 Z20 H5
G37 Z50
G0 X#11005 Y#10005
M30
=== truth
0 0 30
rapid 0 0 54
probe 0 0 59.8 F 60
0.2 10 59.8
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 0 0 30 t0.12
2: rapid to 0 0 54 t0.096
2: probe to 0 0 59.8 F60 t5.8
2: event probe contact=true
3: rapid to 0.2 10 59.8 t0.04
4: event end code="M30"
end of program: 4 blocks, 4 motions, 0 errors, 0 warnings
