=== about
Digest wedm, EX-16 (7.1): a punch that is wider at the top; then R of both planes (K18).
Truth: EX-16, 20 tan 2.5 deg = 0.873219 further out above; radius 2 there on the corner (10.873219, 10.873219); way 70
+ 6.5 pi below.
proves: wedm-5.7-G50 wedm-5.7-G52 wedm-5.7-A wedm-7.4-RR wedm-7.2-start
=== settings
control = wedm
param.ZL = -40
param.ZU = 80
=== main
T84T86;
H000=0;
G90 G92 X-18.Y0.U0.V0.;
C001;
G42H000;
G52A0.;
G01 X-10.Y0.;
G42H000;
G52A2.5;
X-10.Y-6.;
G03X-6.Y-10.I4.J0.;
G01X6.Y-10.;
G03X10.Y-6.J4.;
G01X10.Y10.R1.R2.;
G01X-6.Y10.;
G03X-10.Y6.J-4.;
G01X-10.Y0.;
G40H000G50A0.X-18.Y0.;
M02;
=== truth
feed -10 0 0 upper -10.8732 0 20
feed -10 -6 0 upper -10.8732 -6 20
feed -6 -10 0 center -6 -6 sweep 90 upper -6 -10.8732 20 center -6 -6 sweep 90
feed 6 -10 0 upper 6 -10.8732 20
feed 10 -6 0 center 6 -6 sweep 90 upper 10.8732 -6 20 center 6 -6 sweep 90
feed 10 9 0 upper 10.8732 8.8732 20
feed 9 10 0 center 9 9 sweep 90 upper 8.8732 10.8732 20 center 8.8732 8.8732 sweep 90
feed -6 10 0 upper -6 10.8732 20
feed -10 6 0 center -6 6 sweep 90 upper -10.8732 6 20 center -6 6 sweep 90
feed -10 0 0 upper -10.8732 0 20
feed -18 0 0 upper -18 0 20
length 90.42035 94.10610
=== expect
file 0 main.nc
1: event coolant code="T84" on=true
1: event coolant code="T86" on=true
4: event function code="C001"
7: cut wire lower to -10 0 0 upper to -10.8732 0 20 F3 t160
10: cut wire lower to -10 -6 0 upper to -10.8732 -6 20 F3 t120
11: cut wire lower arc to -6 -10 0 center -6 -6 sweep 90 upper arc to -6 -10.8732 20 center -6 -6 sweep 90 F3 t125.6637
12: cut wire lower to 6 -10 0 upper to 6 -10.8732 20 F3 t240
13: cut wire lower arc to 10 -6 0 center 6 -6 sweep 90 upper arc to 10.8732 -6 20 center 6 -6 sweep 90 F3 t125.6637
14: cut wire lower to 10 9 0 upper to 10.8732 8.8732 20 F3 t300
14: cut wire lower arc to 9 10 0 center 9 9 sweep 90 upper arc to 8.8732 10.8732 20 center 8.8732 8.8732 sweep 90 F3 t31.4159
15: cut wire lower to -6 10 0 upper to -6 10.8732 20 F3 t300
16: cut wire lower arc to -10 6 0 center -6 6 sweep 90 upper arc to -10.8732 6 20 center -6 6 sweep 90 F3 t125.6637
17: cut wire lower to -10 0 0 upper to -10.8732 0 20 F3 t120
18: cut wire lower to -18 0 0 upper to -18 0 20 F3 t160
19: event end code="M02"
end of program: 19 blocks, 11 motions, 0 errors, 0 warnings
