=== about
Zero points by variable, low and high numbers and names of the same cells. The common one counts for all; a written cell
of the system in force acts at once.
proves: nct-23.1.19-#5201 nct-23.1.19-#5221 nct-23.1.19-#5241 nct-23.1.19-#5261 nct-23.1.19-#5281
nct-23.1.19-#5301 nct-23.1.19-#5321
=== main
#5201=1
G0 X0 Y0 Z0
#5221=10
#100352=20
#_WZG54[3]=30
G54 X0 Y0 Z0
X#5222 Y#100353 Z#_WZG54[1]
#5241=20
#100402=40
#_WZG55[3]=60
G55 X0 Y0 Z0
X#5242 Y#100403 Z#_WZG55[1]
#5261=30
#100452=60
#_WZG56[3]=90
G56 X0 Y0 Z0
X#5262 Y#100453 Z#_WZG56[1]
#5281=40
#100502=80
#_WZG57[3]=120
G57 X0 Y0 Z0
X#5282 Y#100503 Z#_WZG57[1]
#5301=50
#100552=100
#_WZG58[3]=150
G58 X0 Y0 Z0
X#5302 Y#100553 Z#_WZG58[1]
#5321=60
#100602=120
#_WZG59[3]=180
G59 X0 Y0 Z0
X#5322 Y#100603 Z#_WZG59[1]
#_WZCMN[1]=0
G54
X0 Y0 Z#100301
M30
=== truth
1 0 0
11 20 30
31 50 40
21 40 60
61 100 80
31 60 90
91 150 120
41 80 120
121 200 160
51 100 150
151 250 200
61 120 180
181 300 240
10 20 30
=== expect
file 0 main.nc
2: rapid from 0 0 0 to 1 0 0 t0.004
6: rapid to 11 20 30 t0.12
7: rapid to 31 50 40 t0.12
11: rapid to 21 40 60 t0.08
12: rapid to 61 100 80 t0.24
16: rapid to 31 60 90 t0.16
17: rapid to 91 150 120 t0.36
21: rapid to 41 80 120 t0.28
22: rapid to 121 200 160 t0.48
26: rapid to 51 100 150 t0.4
27: rapid to 151 250 200 t0.6
31: rapid to 61 120 180 t0.52
32: rapid to 181 300 240 t0.72
35: rapid to 10 20 30 t1.12
36: event end code="M30"
end of program: 36 blocks, 14 motions, 0 errors, 0 warnings
