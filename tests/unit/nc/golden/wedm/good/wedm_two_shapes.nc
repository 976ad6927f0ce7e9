=== about
Digest wedm, EX-12 (5.9): a circle below, a diamond above.
Truth: EX-12, ends of the lines 0.135 / sqrt 2 aside, also at half of the first quarter.
proves: wedm-5.9-G61 wedm-5.9-colon wedm-5.9-G60
=== settings
control = wedm
param.T = 30
=== main
H000=0;
H001=0.135;
T84 T86;
G90 G92 X0 Y0 U0 V0;
C001;
G61;
G41 H000;
G01 X0 Y10. : G01 X0 Y10.;
G41 H001;
G02 X-10. Y20. I0 J10. : X-10. Y20.;
X0 Y30. I10. J0 : X0 Y30.;
X10. Y20. I0 J-10. : X10. Y20.;
X0 Y10. I-10. J0 : X0 Y10.;
G40 H000;
G01 X0 Y0 : X0 Y0;
G60;
M02;
=== truth
feed 0 9.865 0 upper -0.0955 9.9045 30
feed -10.135 20 0 center 0 20 sweep -90 at 0.5 -7.1665 12.8335 0 upper -10.0955 19.9045 30 at 0.5 -5.0955 14.9045 30
feed -10.135 20 0 upper -10.0955 20.0955 30 center -10 20 sweep -90
feed 0 30.135 0 center 0 20 sweep -90 upper -0.0955 30.0955 30
feed 0 30.135 0 upper 0.0955 30.0955 30 center 0 30 sweep -90
feed 10.135 20 0 center 0 20 sweep -90 upper 10.0955 20.0955 30
feed 10.135 20 0 upper 10.0955 19.9045 30 center 10 20 sweep -90
feed 0 9.865 0 center 0 20 sweep -90 upper 0.0955 9.9045 30
feed 0 0 0 upper 0 0 30
length 83.41008 77.01472
=== expect
file 0 main.nc
3: event coolant code="T84" on=true
3: event coolant code="T86" on=true
5: event function code="C001"
8: cut wire lower to 0 9.865 0 upper to -0.0955 9.9045 30 F3 t197.3
10: cut wire lower arc to -10.135 20 0 center 0 20 sweep -90 upper to -10.0955 19.9045 30 F3 t318.4004
10: cut wire lower to -10.135 20 0 upper arc to -10.0955 20.0955 30 center -10 20 sweep -90 F3 t4.2412
11: cut wire lower arc to 0 30.135 0 center 0 20 sweep -90 upper to -0.0955 30.0955 30 F3 t318.4004
11: cut wire lower to 0 30.135 0 upper arc to 0.0955 30.0955 30 center 0 30 sweep -90 F3 t4.2412
12: cut wire lower arc to 10.135 20 0 center 0 20 sweep -90 upper to 10.0955 20.0955 30 F3 t318.4004
12: cut wire lower to 10.135 20 0 upper arc to 10.0955 19.9045 30 center 10 20 sweep -90 F3 t4.2412
13: cut wire lower arc to 0 9.865 0 center 0 20 sweep -90 upper to 0.0955 9.9045 30 F3 t318.4004
15: cut wire lower to 0 0 0 upper to 0 0 30 F3 t197.3
17: event end code="M02"
end of program: 17 blocks, 9 motions, 0 errors, 0 warnings
