=== about
Words of the last block by variable. The last program called stays; the one that runs changes. The extended work system
programmed last stays, the active one changes.
proves: nct-23.1.14-#4107 nct-23.1.14-#4108 nct-23.1.14-#4109 nct-23.1.14-#4111 nct-23.1.14-#4113
nct-23.1.14-#4114 nct-23.1.14-#4115 nct-23.1.14-#4119 nct-23.1.14-#4120 nct-23.1.14-#4130
nct-23.1.14-#4307 nct-23.1.14-#4308 nct-23.1.14-#4309 nct-23.1.14-#4311 nct-23.1.14-#4313
nct-23.1.14-#4314 nct-23.1.14-#4315 nct-23.1.14-#4319 nct-23.1.14-#4320 nct-23.1.14-#4330 nct-23.1.13-4000
=== settings
main_name = o00007.nc
H15 = 0
D12 = 3
=== main
N120 G83 X0 Y0 R0 Z-1 Q1 E0.5 F250 T8 S500 M3
G80
N125 D12 H15
#100=#4114
G0 X#4107 Y#4108 Z#4109
X#_BUFH Y#4113 Z#100
X#4115 Y#4119 Z#_BUFT
X#4307 Y#_ACTE Z#4309
X#4311 Y#4313 Z#_ACTN
X#4315 Y#4319 Z#4320
M98 P11
X#4115 Y#4315 Z#4000
G54.1 P7
X#4130 Y#4330 Z#_MAINO
G55
X#_BUFWZP Y#_ACTWZP Z0
M30
=== sub O0011.nc
X#4115 Y#_ACTO Z#4000
M99
=== truth
0 0 -1
0 0 0
12 0.5 250
15 3 125
7 500 8
12 0.5 250
15 3 125
7 500 8
11 11 7
11 7 7
7 7 7
7 0 0
=== expect
file 0 o00007.nc
1 N120: event spindle rpm=500 direction="cw"
1 N120: feed from 0 0 0 to 0 0 -1 F250 t0.24
1 N120: rapid to 0 0 0 t0.004
5: rapid to 12 0.5 250 t1
6: rapid to 15 3 125 t0.5
7: rapid to 7 500 8 t1.988
8: rapid to 12 0.5 250 t1.998
9: rapid to 15 3 125 t0.5
10: rapid to 7 500 8 t1.988
file 1 O0011.nc
1/1 depth 1: rapid to 11 11 7 t1.956
12: rapid to 11 7 7 t0.016
o00007.nc:13:1: warning[nct-offset-missing]: G54.1 P7 has no value in the job: 0 is taken (--offset G54.1P7=X,Y,Z)
    G54.1 P7
    ^~~~~~~~
14: rapid to 7 7 7 t0.016
o00007.nc:15:1: warning[nct-offset-missing]: G55 has no value in the job: 0 is taken (--offset G55=X,Y,Z)
    G55
    ^~~
16: rapid to 7 0 0 t0.028
17: event end code="M30"
end of program: 19 blocks, 12 motions, 0 errors, 2 warnings
