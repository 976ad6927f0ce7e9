=== about
Tools counted by the time that they cut; their warning comes before their end.
proves: nct-12.3.1-table nct-12.3.1-warning
=== main
G10 L75 P1
N1 T5 Q11 B1 L20 I12
N2 T5 Q11 B1 L20
G11
T5 M6
(ten seconds in feed; rapids do not count)
G1 X100 F600
G0 X0
G1 X#8403
T5 M6
G1 X#8401 Y100
T5 M6
G1 X#8401 Y0
M30
=== truth
feed 100 0 0 t 10
rapid 0 0 0
feed 10 0 0 t 1
feed 1 100 0
feed 2 0 0
=== expect
file 0 main.nc
5: event tool tool=5 row=1
7: feed from 0 0 0 to 100 0 0 F600 t10
8: rapid to 0 0 0 t0.4
main.nc:8:1: note[nct-tool-life]: tool 5 (row 1) will soon be at the end of its life
    G0 X0
    ^~~~~
9: feed to 10 0 0 F600 t1
10: event tool tool=5 row=1
11: feed to 1 100 0 F600 t10.0404
12: event tool tool=5 row=2
13: feed to 2 0 0 F600 t10.0005
14: event end code="M30"
end of program: 13 blocks, 5 motions, 0 errors, 0 warnings
