=== about
Digest wedm, EX-8 (5.5.5): punch with corner overcut, offset by H with H000 as lead-in.
Truth: EX-8; 3 x 3 mm, 0.11 outside, 0.05 straight on at each corner; way 12.69115 + 8 x 0.05 + 2 x 1.39.
proves: wedm-5.5.5-G37 wedm-5.5.5-G36 wedm-5.6.4-H0
=== settings
control = wedm
=== main
H000=+00000000;
H001=+00000110;
H005=+00000000;
T84 T86 G54 G90 G92X+1500Y-1500;
C007;
G01X+1500Y-1000;G04X0.0+H005;
G41H000;
G01X+1500Y+0;G04X0.0+H005;
G41H001;
G37X50;
X+0Y+0;G04X0.0+H005;
X+0Y+3000;G04X0.0+H005;
X+3000Y+3000;G04X0.0+H005;
X+3000Y+0;G04X0.0+H005;
G36;
X+1500Y+0;G04X0.0+H005;
G40H000G01X+1500Y-1000;
M00;
C007;
G01X+1500Y-1500;G04X0.0+H005;
T85 T87 M02;
=== truth
feed 1.5 -1 0 upper 1.5 -1 20
feed 1.5 -0.11 0 upper 1.5 -0.11 20
feed 0 -0.11 0 upper 0 -0.11 20
feed -0.05 -0.11 0 upper -0.05 -0.11 20
feed 0 -0.11 0 upper 0 -0.11 20
feed -0.11 0 0 center 0 0 sweep -90 upper -0.11 0 20 center 0 0 sweep -90
feed -0.11 3 0 upper -0.11 3 20
feed -0.11 3.05 0 upper -0.11 3.05 20
feed -0.11 3 0 upper -0.11 3 20
feed 0 3.11 0 center 0 3 sweep -90 upper 0 3.11 20 center 0 3 sweep -90
feed 3 3.11 0 upper 3 3.11 20
feed 3.05 3.11 0 upper 3.05 3.11 20
feed 3 3.11 0 upper 3 3.11 20
feed 3.11 3 0 center 3 3 sweep -90 upper 3.11 3 20 center 3 3 sweep -90
feed 3.11 0 0 upper 3.11 0 20
feed 3.11 -0.05 0 upper 3.11 -0.05 20
feed 3.11 0 0 upper 3.11 0 20
feed 3 -0.11 0 center 3 0 sweep -90 upper 3 -0.11 20 center 3 0 sweep -90
feed 1.5 -0.11 0 upper 1.5 -0.11 20
feed 1.5 -1 0 upper 1.5 -1 20
feed 1.5 -1.5 0 upper 1.5 -1.5 20
length 15.87115
=== expect
file 0 main.nc
4: event coolant code="T84" on=true
4: event coolant code="T86" on=true
5: event function code="C007"
6: cut wire lower to 1.5 -1 0 upper to 1.5 -1 20 F3 t10
6: event dwell seconds=0
8: cut wire lower to 1.5 -0.11 0 upper to 1.5 -0.11 20 F3 t17.8
8: event dwell seconds=0
11: cut wire lower to 0 -0.11 0 upper to 0 -0.11 20 F3 t30
11: cut wire lower to -0.05 -0.11 0 upper to -0.05 -0.11 20 F3 t1
11: cut wire lower to 0 -0.11 0 upper to 0 -0.11 20 F3 t1
11: cut wire lower arc to -0.11 0 0 center 0 0 sweep -90 upper arc to -0.11 0 20 center 0 0 sweep -90 F3 t3.4558
11: event dwell seconds=0
12: cut wire lower to -0.11 3 0 upper to -0.11 3 20 F3 t60
12: cut wire lower to -0.11 3.05 0 upper to -0.11 3.05 20 F3 t1
12: cut wire lower to -0.11 3 0 upper to -0.11 3 20 F3 t1
12: cut wire lower arc to 0 3.11 0 center 0 3 sweep -90 upper arc to 0 3.11 20 center 0 3 sweep -90 F3 t3.4558
12: event dwell seconds=0
13: cut wire lower to 3 3.11 0 upper to 3 3.11 20 F3 t60
13: cut wire lower to 3.05 3.11 0 upper to 3.05 3.11 20 F3 t1
13: cut wire lower to 3 3.11 0 upper to 3 3.11 20 F3 t1
13: cut wire lower arc to 3.11 3 0 center 3 3 sweep -90 upper arc to 3.11 3 20 center 3 3 sweep -90 F3 t3.4558
13: event dwell seconds=0
14: cut wire lower to 3.11 0 0 upper to 3.11 0 20 F3 t60
14: cut wire lower to 3.11 -0.05 0 upper to 3.11 -0.05 20 F3 t1
14: cut wire lower to 3.11 0 0 upper to 3.11 0 20 F3 t1
14: cut wire lower arc to 3 -0.11 0 center 3 0 sweep -90 upper arc to 3 -0.11 20 center 3 0 sweep -90 F3 t3.4558
14: event dwell seconds=0
16: cut wire lower to 1.5 -0.11 0 upper to 1.5 -0.11 20 F3 t30
16: event dwell seconds=0
17: cut wire lower to 1.5 -1 0 upper to 1.5 -1 20 F3 t17.8
18: event stop code="M00"
20: cut wire lower to 1.5 -1.5 0 upper to 1.5 -1.5 20 F3 t10
20: event dwell seconds=0
21: event coolant code="T85" on=false
21: event coolant code="T87" on=false
21: event end code="M02"
end of program: 29 blocks, 21 motions, 0 errors, 0 warnings
