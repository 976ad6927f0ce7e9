=== about
Digest wedm, EX-17 (7.5): a die with a taper that changes from side to side.
Truth: EX-17, 20 tan 2 deg = 0.698415 further out above but at the side of A0.
proves: wedm-5.7-G51 wedm-7.5-variable
=== settings
control = wedm
param.H.1 = 0.1
param.ZL = -40
param.ZU = 80
=== main
H000=0;
T84T86;
G90G92X0.Y0.U0.V0.;
C096;
G01X0.Y4.;
C001;
G42H000;
G51A0G01X0.Y5.;
G42H001;
G51A2.X5.Y5.;
G51A2.X5.Y-5.;
G51A2.X-5.Y-5.;
G51A0.X-5.Y5.;
G51A2.X0.Y5.;
G40H000G50A0X0.Y4.5;
X0.Y0.;
M02;
=== truth
feed 0 4 0 upper 0 4 20
feed 0 4.9 0 upper 0 5.5984 20
feed 4.9 4.9 0 upper 5.5984 5.5984 20
feed 4.9 -4.9 0 upper 5.5984 -5.5984 20
feed -4.9 -4.9 0 upper -4.9 -5.5984 20
feed -4.9 4.9 0 upper -4.9 5.5984 20
feed 0 4.9 0 upper 0 5.5984 20
feed 0 4.5 0 upper 0 4.5 20
feed 0 0 0 upper 0 0 20
length 49.00000 54.58732
=== expect
file 0 main.nc
2: event coolant code="T84" on=true
2: event coolant code="T86" on=true
4: event function code="C096"
5: cut wire lower to 0 4 0 upper to 0 4 20 F3 t80
6: event function code="C001"
8: cut wire lower to 0 4.9 0 upper to 0 5.5984 20 F3 t18
10: cut wire lower to 4.9 4.9 0 upper to 5.5984 5.5984 20 F3 t98
11: cut wire lower to 4.9 -4.9 0 upper to 5.5984 -5.5984 20 F3 t196
12: cut wire lower to -4.9 -4.9 0 upper to -4.9 -5.5984 20 F3 t196
13: cut wire lower to -4.9 4.9 0 upper to -4.9 5.5984 20 F3 t196
14: cut wire lower to 0 4.9 0 upper to 0 5.5984 20 F3 t98
15: cut wire lower to 0 4.5 0 upper to 0 4.5 20 F3 t8
16: cut wire lower to 0 0 0 upper to 0 0 20 F3 t90
17: event end code="M02"
end of program: 17 blocks, 9 motions, 0 errors, 0 warnings
