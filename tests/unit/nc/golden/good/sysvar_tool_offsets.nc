=== about
Every column of the offset table by G10, number and name, up to the last digit. Lengths are in the unit in force, the code
of the tip is none.
proves: nct-15.1-table-mill nct-15.1-table-turn nct-15.1-Q nct-15.2-G10-L10 nct-15.2-G10-L11 nct-15.2-G10-L12
nct-15.2-G10-L13 nct-15.2-G10-L110 nct-15.2-G10-L111 nct-15.2-G10-L200 nct-15.2-G10-L201 nct-15.2-G10-L202
nct-15.2-G10-L203 nct-23.1.18-#10001 nct-23.1.18-#11001 nct-23.1.18-#12001 nct-23.1.18-#13001
nct-23.1.18-#21001 nct-23.1.18-#22001 nct-23.1.18-#23001 nct-23.1.18-#135001 nct-23.1.18-#136001
nct-23.1.18-#137001 nct-23.1.18-#138001
=== main
G0
G10 L10 P7 R1
X#10007 Y#_OFSHG[7] Z0
#10009=20
X#_OFSHG[9] Y#10008 Z0
G10 L11 P7 R2
X#11007 Y#_OFSHW[7] Z0
#11009=21
X#_OFSHW[9] Y#11008 Z0
G10 L12 P7 R3
X#12007 Y#_OFSDG[7] Z0
#12009=22
X#_OFSDG[9] Y#12008 Z0
G10 L13 P7 R4
X#13007 Y#_OFSDW[7] Z0
#13009=23
X#_OFSDW[9] Y#13008 Z0
G10 L110 P7 R5
X#21007 Y#_CORR_G[7] Z0
#21009=24
X#_CORR_G[9] Y#21008 Z0
G10 L111 P7 R6
X#22007 Y#_CORR_W[7] Z0
#22009=25
X#_CORR_W[9] Y#22008 Z0
G10 L202 P3 R0.1
G10 L203 P3 R0.2
X#_CORR_W[3] Y#21003 Z#22003
G10 L200 P4 X1 Y2 Z3 R4 Q5
G10 L201 P4 X6 Y7 Z8 R9
X#135004 Y#136004 Z#_OFSZW[4]
X#_OFSRW[4] Y#137004 Z#138004
X#_OFSZG[4] Y#_OFSRG[4] Z#_OFST[4]
X#_OFSXW[4] Y#_OFSYW[4] Z#23004
X#_OFSXG[4] Y#_OFSYG[4] Z#10004
G91 G10 L200 P4 XI1 Y2 Q6
G90 X#135004 Y#136004 Z#23004
G20
#10001=10
#23001=3
G21
X#10001 Y#23001 Z0
M30
=== truth
1 1 0
20 0 0
2 2 0
21 0 0
3 3 0
22 0 0
4 4 0
23 0 0
5 5 0
24 0 0
6 6 0
25 0 0
0.1 0.2 0.1
1 2 3
4 6 7
8 9 5
1 2 5
6 7 8
2 4 6
254 3 0
=== expect
file 0 main.nc
3: rapid from 0 0 0 to 1 1 0 t0.004
5: rapid to 20 0 0 t0.076
7: rapid to 2 2 0 t0.072
9: rapid to 21 0 0 t0.076
11: rapid to 3 3 0 t0.072
13: rapid to 22 0 0 t0.076
15: rapid to 4 4 0 t0.072
17: rapid to 23 0 0 t0.076
19: rapid to 5 5 0 t0.072
21: rapid to 24 0 0 t0.076
23: rapid to 6 6 0 t0.072
25: rapid to 25 0 0 t0.076
28: rapid to 0.1 0.2 0.1 t0.0996
31: rapid to 1 2 3 t0.0116
32: rapid to 4 6 7 t0.016
33: rapid to 8 9 5 t0.016
34: rapid to 1 2 5 t0.028
35: rapid to 6 7 8 t0.02
37: rapid to 2 4 6 t0.016
42: rapid to 254 3 0 t1.008
43: event end code="M30"
end of program: 43 blocks, 20 motions, 0 errors, 0 warnings
