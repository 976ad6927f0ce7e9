=== about
The manual's example of 21.2: the tool presses against a surface at Z12, which is stored; the program goes on.
proves: nct-21.2-G31P98
=== settings
start = 0 0 100
probe = plane 0 0 -1 -42
=== main
N1 G31 P98 Q50 Z30 F100
#100=#5063
N2 G0 Z200
X#100
G31 P98 Q254 Y5
M30
=== truth
probe 0 0 42 F 100
0 0 200
42 0 200
probe 42 5 200
=== expect
file 0 main.nc
1 N1: probe from 0 0 100 to 0 0 42 F100 t34.8
1 N1: event probe contact=true
3 N2: rapid to 0 0 200 t0.632
4: rapid to 42 0 200 t0.168
5: probe to 42 5 200 F100 t3
5: event probe contact=false
6: event end code="M30"
end of program: 6 blocks, 4 motions, 0 errors, 0 warnings
