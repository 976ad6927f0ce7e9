=== about
Basic rotations by variable: index 1 turns in XY about Z, 2 in ZX about Y, 3 in YZ about X.
proves: nct-23.1.19-#120001 nct-23.1.19-#120011 nct-23.1.19-#120021 nct-23.1.19-#120031 nct-23.1.19-#120041
nct-23.1.19-#120051
=== main
G0
G54
#120001=90
X10 Y1 Z2
#120001=0
#120002=90
X10 Y1 Z2
#120002=0
#_WRG54[3]=90
X10 Y1 Z2
X#120001 Y#_WRG54[2] Z#120003
#120003=0
G55
#120011=90
X10 Y1 Z2
#120011=0
#120012=90
X10 Y1 Z2
#120012=0
#_WRG55[3]=90
X10 Y1 Z2
X#120011 Y#_WRG55[2] Z#120013
#120013=0
G56
#120021=90
X10 Y1 Z2
#120021=0
#120022=90
X10 Y1 Z2
#120022=0
#_WRG56[3]=90
X10 Y1 Z2
X#120021 Y#_WRG56[2] Z#120023
#120023=0
G57
#120031=90
X10 Y1 Z2
#120031=0
#120032=90
X10 Y1 Z2
#120032=0
#_WRG57[3]=90
X10 Y1 Z2
X#120031 Y#_WRG57[2] Z#120033
#120033=0
G58
#120041=90
X10 Y1 Z2
#120041=0
#120042=90
X10 Y1 Z2
#120042=0
#_WRG58[3]=90
X10 Y1 Z2
X#120041 Y#_WRG58[2] Z#120043
#120043=0
G59
#120051=90
X10 Y1 Z2
#120051=0
#120052=90
X10 Y1 Z2
#120052=0
#_WRG59[3]=90
X10 Y1 Z2
X#120051 Y#_WRG59[2] Z#120053
#120053=0
M30
=== truth
-1 10 2
2 1 -10
10 -2 1
0 -90 0
-1 10 2
2 1 -10
10 -2 1
0 -90 0
-1 10 2
2 1 -10
10 -2 1
0 -90 0
-1 10 2
2 1 -10
10 -2 1
0 -90 0
-1 10 2
2 1 -10
10 -2 1
0 -90 0
-1 10 2
2 1 -10
10 -2 1
0 -90 0
=== expect
file 0 main.nc
4: rapid from 0 0 0 to -1 10 2 t0.04
7: rapid to 2 1 -10 t0.048
10: rapid to 10 -2 1 t0.044
11: rapid to 0 -90 0 t0.352
main.nc:13:1: warning[nct-offset-missing]: G55 has no value in the job: 0 is taken (--offset G55=X,Y,Z)
    G55
    ^~~
15: rapid to -1 10 2 t0.4
18: rapid to 2 1 -10 t0.048
21: rapid to 10 -2 1 t0.044
22: rapid to 0 -90 0 t0.352
main.nc:24:1: warning[nct-offset-missing]: G56 has no value in the job: 0 is taken (--offset G56=X,Y,Z)
    G56
    ^~~
26: rapid to -1 10 2 t0.4
29: rapid to 2 1 -10 t0.048
32: rapid to 10 -2 1 t0.044
33: rapid to 0 -90 0 t0.352
main.nc:35:1: warning[nct-offset-missing]: G57 has no value in the job: 0 is taken (--offset G57=X,Y,Z)
    G57
    ^~~
37: rapid to -1 10 2 t0.4
40: rapid to 2 1 -10 t0.048
43: rapid to 10 -2 1 t0.044
44: rapid to 0 -90 0 t0.352
main.nc:46:1: warning[nct-offset-missing]: G58 has no value in the job: 0 is taken (--offset G58=X,Y,Z)
    G58
    ^~~
48: rapid to -1 10 2 t0.4
51: rapid to 2 1 -10 t0.048
54: rapid to 10 -2 1 t0.044
55: rapid to 0 -90 0 t0.352
main.nc:57:1: warning[nct-offset-missing]: G59 has no value in the job: 0 is taken (--offset G59=X,Y,Z)
    G59
    ^~~
59: rapid to -1 10 2 t0.4
62: rapid to 2 1 -10 t0.048
65: rapid to 10 -2 1 t0.044
66: rapid to 0 -90 0 t0.352
68: event end code="M30"
end of program: 68 blocks, 24 motions, 0 errors, 5 warnings
