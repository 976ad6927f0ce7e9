=== about
The manual's example of 21.3: rapid to 10 mm above the gauge, then at feed; the gauge answers 0.2 mm below where a tool of
the set length would touch, which shortens the tool (TCA 0): H5 98 becomes 97.8. The offset in force stays until H is called
again.
proves: nct-21.3-G37 nct-3-G37
=== settings
start = 0 0 300
H5 = 98
G55 = 5 6 7
probe = plane 0 0 -1 -154.8
=== main
G55 G15 G50 G50.1 G69 G94
G43 G0 Z100 H5
X300 Y200
G37 Z50 F200
#100=#10005
G0 Z100
X#100 Y#5063
G43 H5 Z100
M30
=== truth
rapid 0 0 205
rapid 305 206 205
rapid 305 206 165
probe 305 206 154.8 F 200 t 3.06
rapid 305 206 205
rapid 102.8 153.8 205
rapid 102.8 153.8 204.8
=== expect
file 0 main.nc
2: rapid from 0 0 300 to 0 0 205 t0.38
3: rapid to 305 206 205 t1.22
4: rapid to 305 206 165 t0.16
4: probe to 305 206 154.8 F200 t3.06
4: event probe contact=true
6: rapid to 305 206 205 t0.2008
7: rapid to 102.8 153.8 205 t0.8088
8: rapid to 102.8 153.8 204.8 t0.0008
9: event end code="M30"
end of program: 9 blocks, 7 motions, 0 errors, 0 warnings
