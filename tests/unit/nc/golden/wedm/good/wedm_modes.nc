=== about
Mirror, change of places, units, work systems, steps, skipped blocks, expressions.
Truth: K21 and K22; 1 inch = 25.4; G55 begins at X1 of G54; EX-19 for H001 = 180 + 2 x 320 = 820 um.
proves: wedm-5.4-G05 wedm-5.4-G06 wedm-5.4-G08 wedm-5.4-G09 wedm-5.5-G11 wedm-5.5-G12 wedm-4-skip wedm-5.5.1-G20 wedm-5.5.1-G21 wedm-1.4-units wedm-5.8-G54 wedm-5.8-G55 wedm-5.8-G56 wedm-5.8-G57 wedm-5.8-G58 wedm-5.8-G59 wedm-5.10-G90 wedm-5.10-G91 wedm-11-expr wedm-12-H wedm-5.6.1-H
=== settings
control = wedm
G56 = 100 0 0
G57 = 200 0 0
G58 = 300 0 0
G59 = 400 0 0
=== main
T84T86;C001;
G92X0Y0;
G05G01X10.Y5.;
G02X20.Y15.I10.;
G09G00X0Y0;
G06G01X10.Y5.;
G02X20.Y15.I10.;
G09G00X0Y0;
G08G01X10.Y5.;
G02X20.Y15.I10.;
G09G00X0Y0;
G11;
/X1.;
G12;
/X2.;
G20X10000;
X1.;
G21X1.;
G92G55X0Y0;
X1.;
G56X1.;
G57X1.;
G58X1.;
G59X1.;
G54X1.;
G91X1.;
Y500;
G90X0;
H000=320;H001=180+2H000;
G01XH001Y2H001-500;
M02;
=== truth
feed -10 5 0 upper -10 5 20
feed -20 15 0 center -20 5 sweep 90 upper -20 15 20 center -20 5 sweep 90
rapid 0 0 0 upper 0 0 20
feed 10 -5 0 upper 10 -5 20
feed 20 -15 0 center 20 -5 sweep 90 upper 20 -15 20 center 20 -5 sweep 90
rapid 0 0 0 upper 0 0 20
feed 5 10 0 upper 5 10 20
feed 15 20 0 center 5 20 sweep 90 upper 15 20 20 center 5 20 sweep 90
rapid 0 0 0 upper 0 0 20
rapid 2 0 0 upper 2 0 20
rapid 25.4 0 0 upper 25.4 0 20
rapid 1 0 0 upper 1 0 20
rapid 2 0 0 upper 2 0 20
rapid 101 0 0 upper 101 0 20
rapid 201 0 0 upper 201 0 20
rapid 301 0 0 upper 301 0 20
rapid 401 0 0 upper 401 0 20
rapid 1 0 0 upper 1 0 20
rapid 2 0 0 upper 2 0 20
rapid 2 0.5 0 upper 2 0.5 20
rapid 0 0.5 0 upper 0 0.5 20
feed 0.82 1.14 0 upper 0.82 1.14 20
length 81.70510
=== expect
file 0 main.nc
1: event coolant code="T84" on=true
1: event coolant code="T86" on=true
1: event function code="C001"
3: cut wire lower to -10 5 0 upper to -10 5 20 F3 t223.6068
4: cut wire lower arc to -20 15 0 center -20 5 sweep 90 upper arc to -20 15 20 center -20 5 sweep 90 F3 t314.1593
5: rapid wire lower to 0 0 0 upper to 0 0 20 F0 t0.08
6: cut wire lower to 10 -5 0 upper to 10 -5 20 F3 t223.6068
7: cut wire lower arc to 20 -15 0 center 20 -5 sweep 90 upper arc to 20 -15 20 center 20 -5 sweep 90 F3 t314.1593
8: rapid wire lower to 0 0 0 upper to 0 0 20 F0 t0.08
9: cut wire lower to 5 10 0 upper to 5 10 20 F3 t223.6068
10: cut wire lower arc to 15 20 0 center 5 20 sweep 90 upper arc to 15 20 20 center 5 20 sweep 90 F3 t314.1593
11: rapid wire lower to 0 0 0 upper to 0 0 20 F0 t0.08
15: rapid wire lower to 2 0 0 upper to 2 0 20 F0 t0.008
16: rapid wire lower to 25.4 0 0 upper to 25.4 0 20 F0 t0.0936
18: rapid wire lower to 1 0 0 upper to 1 0 20 F0 t0.0976
20: rapid wire lower to 2 0 0 upper to 2 0 20 F0 t0.004
21: rapid wire lower to 101 0 0 upper to 101 0 20 F0 t0.396
22: rapid wire lower to 201 0 0 upper to 201 0 20 F0 t0.4
23: rapid wire lower to 301 0 0 upper to 301 0 20 F0 t0.4
24: rapid wire lower to 401 0 0 upper to 401 0 20 F0 t0.4
25: rapid wire lower to 1 0 0 upper to 1 0 20 F0 t1.6
26: rapid wire lower to 2 0 0 upper to 2 0 20 F0 t0.004
27: rapid wire lower to 2 0.5 0 upper to 2 0.5 20 F0 t0.002
28: rapid wire lower to 0 0.5 0 upper to 0 0.5 20 F0 t0.008
30: cut wire lower to 0.82 1.14 0 upper to 0.82 1.14 20 F3 t20.8038
31: event end code="M02"
end of program: 32 blocks, 22 motions, 0 errors, 0 warnings
