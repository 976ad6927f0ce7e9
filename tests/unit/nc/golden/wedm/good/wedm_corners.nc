=== about
Both sides, outer corners by arcs and straight, extended lines, rounded corners; change of side; point named within the offset.
Truth: K1 and K2 by the rules 5.5.2, 5.5.3, 5.6.2 to 5.6.6 and 14, each end by hand: V + r n, extension min(1,
tan(turn/2)) r.
proves: wedm-5.6-G40 wedm-5.6.4-cancel wedm-5.6-G41 wedm-5.6-G42 wedm-5.5.2-G28 wedm-5.5.2-G29 wedm-5.5.3-G30 wedm-5.5.3-G31 wedm-14-R wedm-5.6.6-G92
=== settings
control = wedm
param.H.1 = 0.5
=== main
T84T86;C001;
G92X0Y-5.;
G42H001G01Y0;
G29X10.;
X5.Y8.660;
G28X-5.;
G31X1.X-10.;
G30Y2.R1.;
X0;
G41X20.;
Y10.;
G92X0Y0;
G01X5.;
Y5.;
G40X9.;
M02;
=== truth
feed 0 -0.5 0 upper 0 -0.5 20
feed 10 -0.5 0 upper 10 -0.5 20
feed 10.5 -0.5 0 upper 10.5 -0.5 20
feed 10.683 -0.183 0 upper 10.683 -0.183 20
feed 10.433 0.25 0 upper 10.433 0.25 20
feed 5.433 8.91 0 upper 5.433 8.91 20
feed 5.2887 9.16 0 upper 5.2887 9.16 20
feed 5 9.16 0 upper 5 9.16 20
feed -5 9.16 0 upper -5 9.16 20
feed -10 9.16 0 upper -10 9.16 20
feed -11 9.16 0 upper -11 9.16 20
feed -10 9.16 0 upper -10 9.16 20
feed -10.5 8.66 0 center -10 8.66 sweep 90 upper -10.5 8.66 20 center -10 8.66 sweep 90
feed -10.5 3 0 upper -10.5 3 20
feed -9 1.5 0 center -9 3 sweep 90 upper -9 1.5 20 center -9 3 sweep 90
feed 0 1.5 0 upper 0 1.5 20
feed 20 2.5 0 upper 20 2.5 20
feed 20 10 0 upper 20 10 20
feed 24.5 10 0 upper 24.5 10 20
feed 24.5 15 0 upper 24.5 15 20
feed 29 15 0 upper 29 15 20
length 102.76973
=== expect
file 0 main.nc
1: event coolant code="T84" on=true
1: event coolant code="T86" on=true
1: event function code="C001"
3: cut wire lower to 0 -0.5 0 upper to 0 -0.5 20 F3 t90
4: cut wire lower to 10 -0.5 0 upper to 10 -0.5 20 F3 t200
4: cut wire lower to 10.5 -0.5 0 upper to 10.5 -0.5 20 F3 t10
4: cut wire lower to 10.683 -0.183 0 upper to 10.683 -0.183 20 F3 t7.3207
4: cut wire lower to 10.433 0.25 0 upper to 10.433 0.25 20 F3 t10
5: cut wire lower to 5.433 8.91 0 upper to 5.433 8.91 20 F3 t199.9956
5: cut wire lower to 5.2887 9.16 0 upper to 5.2887 9.16 20 F3 t5.7734
5: cut wire lower to 5 9.16 0 upper to 5 9.16 20 F3 t5.7734
6: cut wire lower to -5 9.16 0 upper to -5 9.16 20 F3 t200
7: cut wire lower to -10 9.16 0 upper to -10 9.16 20 F3 t100
7: cut wire lower to -11 9.16 0 upper to -11 9.16 20 F3 t20
7: cut wire lower to -10 9.16 0 upper to -10 9.16 20 F3 t20
7: cut wire lower arc to -10.5 8.66 0 center -10 8.66 sweep 90 upper arc to -10.5 8.66 20 center -10 8.66 sweep 90 F3 t15.708
8: cut wire lower to -10.5 3 0 upper to -10.5 3 20 F3 t113.2
8: cut wire lower arc to -9 1.5 0 center -9 3 sweep 90 upper arc to -9 1.5 20 center -9 3 sweep 90 F3 t47.1239
9: cut wire lower to 0 1.5 0 upper to 0 1.5 20 F3 t180
10: cut wire lower to 20 2.5 0 upper to 20 2.5 20 F3 t400.4997
11: cut wire lower to 20 10 0 upper to 20 10 20 F3 t150
13: cut wire lower to 24.5 10 0 upper to 24.5 10 20 F3 t90
14: cut wire lower to 24.5 15 0 upper to 24.5 15 20 F3 t100
15: cut wire lower to 29 15 0 upper to 29 15 20 F3 t90
16: event end code="M02"
end of program: 17 blocks, 21 motions, 0 errors, 0 warnings
