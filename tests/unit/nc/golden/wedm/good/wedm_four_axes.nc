=== about
Digest wedm, EX-13 (5.9.1): U and V of the secondary plane; then the upper guide by itself.
Truth: EX-13; then U12 of 120 mm between the guides leans the wire 2 mm over the 20 of the planes.
proves: wedm-5.9.1-G74 wedm-5.9.1-G75 wedm-6-UV
=== settings
control = wedm
param.ZL = -40
param.ZU = 80
=== main
T84T86C001G92 X0 Y-1.;
G74;
G01 Y0;
X10.;
Y10. U-3. V-4.;
X5. U0 V0;
X0 U3. V-4.;
Y0 U0 V0;
G75;
Y-1.;
G01U12.;
G02X2.I1.;
G00U0;
M02;
=== truth
feed 0 0 0 upper 0 0 20
feed 10 0 0 upper 10 0 20
feed 10 10 0 upper 7 6 20
feed 5 10 0 upper 5 10 20
feed 0 10 0 upper 3 6 20
feed 0 0 0 upper 0 0 20
feed 0 -1 0 upper 0 -1 20
feed 0 -1 0 upper 2 -1 20
feed 2 -1 0 center 1 -1 sweep -180 upper 4 -1 20 center 3 -1 sweep -180
rapid 2 -1 0 upper 2 -1 20
length 45.14159 39.50227
=== expect
file 0 main.nc
1: event function code="C001"
1: event coolant code="T84" on=true
1: event coolant code="T86" on=true
3: cut wire lower to 0 0 0 upper to 0 0 20 F3 t20
4: cut wire lower to 10 0 0 upper to 10 0 20 F3 t200
5: cut wire lower to 10 10 0 upper to 7 6 20 F3 t200
6: cut wire lower to 5 10 0 upper to 5 10 20 F3 t100
7: cut wire lower to 0 10 0 upper to 3 6 20 F3 t100
8: cut wire lower to 0 0 0 upper to 0 0 20 F3 t200
10: cut wire lower to 0 -1 0 upper to 0 -1 20 F3 t20
11: cut wire lower to 0 -1 0 upper to 2 -1 20 F3 t40
12: cut wire lower arc to 2 -1 0 center 1 -1 sweep -180 upper arc to 4 -1 20 center 3 -1 sweep -180 F3 t62.8319
13: rapid wire lower to 2 -1 0 upper to 2 -1 20 F0 t0.008
14: event end code="M02"
end of program: 14 blocks, 10 motions, 0 errors, 0 warnings
