=== about
Digest wedm, EX-1 and EX-3 shortened: holes by subprograms that set the point anew; wire cut and threaded.
Truth: EX-1, holes at X0 and X50 of radius 5; two half turns of radius 1 behind them; way 2 (10 + 10 pi) + 2 pi.
proves: wedm-8.3-M98 wedm-8.4-M99 wedm-10-P wedm-10-L wedm-5.1-G00 wedm-5.2-G01 wedm-5.3-G02 wedm-5.3-G03 wedm-5.3-IJ wedm-8.5-M50 wedm-8.6-M60 wedm-5.11-G92 wedm-6-XY
=== settings
control = wedm
=== main
T84T86;
G90G92X0Y0;
M98P0002;
M50;
G00X50.;
M60;
M98P0002;
M98P0003L2;
T85T87;
M02;
N0002;
G90G92X0Y0;
C004;
G01X5.;
G02X-5.Y0I-5.J0;
X5.Y0I5.J0;
G01X0;
M99;
N0003;
G91G03X2.I1.;
G90;
M99;
=== truth
feed 5 0 0 upper 5 0 20
feed -5 0 0 center 0 0 sweep -180 upper -5 0 20 center 0 0 sweep -180
feed 5 0 0 center 0 0 sweep -180 upper 5 0 20 center 0 0 sweep -180
feed 0 0 0 upper 0 0 20
rapid 50 0 0 upper 50 0 20
feed 55 0 0 upper 55 0 20
feed 45 0 0 center 50 0 sweep -180 upper 45 0 20 center 50 0 sweep -180
feed 55 0 0 center 50 0 sweep -180 upper 55 0 20 center 50 0 sweep -180
feed 50 0 0 upper 50 0 20
feed 52 0 0 center 51 0 sweep 180 upper 52 0 20 center 51 0 sweep 180
feed 54 0 0 center 53 0 sweep 180 upper 54 0 20 center 53 0 sweep 180
length 89.11504
=== expect
file 0 main.nc
1: event coolant code="T84" on=true
1: event coolant code="T86" on=true
13 depth 1: event function code="C004"
14 depth 1: cut wire lower to 5 0 0 upper to 5 0 20 F3 t100
15 depth 1: cut wire lower arc to -5 0 0 center 0 0 sweep -180 upper arc to -5 0 20 center 0 0 sweep -180 F3 t314.1593
16 depth 1: cut wire lower arc to 5 0 0 center 0 0 sweep -180 upper arc to 5 0 20 center 0 0 sweep -180 F3 t314.1593
17 depth 1: cut wire lower to 0 0 0 upper to 0 0 20 F3 t100
4: event wire code="M50" threaded=false
5: rapid wire lower to 50 0 0 upper to 50 0 20 F0 t0.2
6: event wire code="M60" threaded=true
14 depth 1: cut wire lower to 55 0 0 upper to 55 0 20 F3 t100
15 depth 1: cut wire lower arc to 45 0 0 center 50 0 sweep -180 upper arc to 45 0 20 center 50 0 sweep -180 F3 t314.1593
16 depth 1: cut wire lower arc to 55 0 0 center 50 0 sweep -180 upper arc to 55 0 20 center 50 0 sweep -180 F3 t314.1593
17 depth 1: cut wire lower to 50 0 0 upper to 50 0 20 F3 t100
20 depth 1: cut wire lower arc to 52 0 0 center 51 0 sweep 180 upper arc to 52 0 20 center 51 0 sweep 180 F3 t62.8319
20 depth 1: cut wire lower arc to 54 0 0 center 53 0 sweep 180 upper arc to 54 0 20 center 53 0 sweep 180 F3 t62.8319
9: event coolant code="T85" on=false
9: event coolant code="T87" on=false
10: event end code="M02"
end of program: 30 blocks, 11 motions, 0 errors, 0 warnings
