=== about
The manual's part with G12.1: X in diameter, C in radius, no offset. In the part the path is plain: lines, two quarter
circles; C turns once about. Points and angles of the table; G59 holds the zero on the axis of C.
proves: nct-4.5-G12.1 nct-4.5-G13.1 nct-4.5-plane nct-4.5-arc nct-1.1-ABC
=== settings
axis = C 4 rotary
N0106.DIA.1 = 1
D1 = 0
=== main
N050 T808
N060 G59
N070 G17 G0 X200 C0
N080 G94 Z-3 S1000 M3
N090 G12.1
N100 G42 G1 X100 F1000 D1
N110 C30
N120 G3 X60 C50 I-20 J0
N130 G1 X-40
N140 X-100 C20
N150 C-30
N160 G3 X-60 C-50 R20
N170 G1 X40
N180 X100 C-20
N190 C0
N200 G40 G0 X150
N210 G13.1
N220 G0 Z100
N230 X200 C370
M30
=== truth
rapid 100 0 0
rapid 100 0 -3
feed 50 0 -3 F 1000 t 3 rotary 0
feed 50 30 -3 F 1000 t 1.8 rotary 30.9638
feed 30 50 -3 center 30 30 -3 sweep 90 rotary 59.0362
feed -20 50 -3 F 1000 rotary 111.8014
feed -50 20 -3 rotary 158.1986
feed -50 -30 -3 rotary 210.9638
feed -30 -50 -3 center -30 -30 -3 sweep 90 rotary 239.0362
feed 20 -50 -3 rotary 291.8014
feed 50 -20 -3 rotary 338.1986
feed 50 0 -3 rotary 360
rapid 75 0 -3 rotary 360
rapid 75 0 100 rotary 360
rapid 98.4808 17.3648 100 rotary 370
=== expect
file 0 main.nc
main.nc:2:1: warning[nct-offset-missing]: G59 has no value in the job: 0 is taken (--offset G59=X,Y,Z)
    N060 G59
    ^~~~~~~~
3 N70: rapid from 0 0 0 to 100 0 0 C 0 to 0 t0.4
4 N80: event spindle rpm=1000 direction="cw"
4 N80: rapid to 100 0 -3 C 0 to 0 t0.012
5 N90: event virtual_plane code="G12.1" on=true axes="X C"
6 N100: feed to 50 0 -3 C 0 to 0 F1000 t3
7 N110: feed to 50 30 -3 C 0 to 30.9638 F1000 t1.8
8 N120: feed arc to 30 50 -3 center 30 30 -3 normal 0 0 1 sweep 90 C 30.9638 to 59.0362 F1000 t1.885
9 N130: feed to -20 50 -3 C 59.0362 to 111.8014 F1000 t3
10 N140: feed to -50 20 -3 C 111.8014 to 158.1986 F1000 t2.5456
11 N150: feed to -50 -30 -3 C 158.1986 to 210.9638 F1000 t3
12 N160: feed arc to -30 -50 -3 center -30 -30 -3 normal 0 0 1 sweep 90 C 210.9638 to 239.0362 F1000 t1.885
13 N170: feed to 20 -50 -3 C 239.0362 to 291.8014 F1000 t3
14 N180: feed to 50 -20 -3 C 291.8014 to 338.1986 F1000 t2.5456
15 N190: feed to 50 0 -3 C 338.1986 to 360 F1000 t1.2
16 N200: rapid to 75 0 -3 C 360 to 360 t0.1
17 N210: event virtual_plane code="G12.1" on=false axes="X C"
18 N220: rapid to 75 0 100 C 360 to 360 t0.412
19 N230: rapid arc to 98.4808 17.3648 100 center 0 0 100 normal 0 0 1 sweep 10 C 360 to 370 t0.1
20: event end code="M30"
end of program: 20 blocks, 15 motions, 0 errors, 1 warnings
