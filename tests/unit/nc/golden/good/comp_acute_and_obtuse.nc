=== about
Corner of heading change -135: (10,10), (14.1421,0).
proves: nct-15.5-alpha nct-15.5.2-acute nct-15.5.2-obtuse nct-15.5-G41
=== settings
D1 = 10
H1 = 0
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X0
X-50 Y-50
G40 X-100
M30
=== truth
-100 0 0
-50 10 0
10 10 0
14.1421 0 0
*  * 0
-100 -50 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
2: rapid to -50 10 0 t0.2
3: feed to 10 10 0 F100 t36
3: feed to 14.1421 0 0 F100 t6.4944
4: feed to -45.8579 -60 0 F100 t50.9117
5: feed to -100 -50 0 F100 t33.0347
6: event end code="M30"
end of program: 6 blocks, 6 motions, 0 errors, 0 warnings
