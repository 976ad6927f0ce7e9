=== about
Calls with repetitions; locals are copied down and lost, globals stay; five levels; M99.
proves: wl4-4.2-L wl4-10.1-L wl4-7.4-M99 wl4-9.1-loc wl4-9.1-glob wl4-4-names wl4-4-pct wl4-10.1-nest
=== settings
control = wl4-mill
=== main
%CALLS
G54 G0
#1=5 #30=0
L0103
X#1 Y#30
#40=101 L#40
Y#30
L02
M2
%
%01
#1=(#1+1) #30=(#30+1)
G1 X#1 F100
M99
%
%02
L03
M99
%
%03
L04
M99
%
%04
L05
M99
%
%05
L06
M99
%
%06
G0 X99
M99
%
=== truth
feed 6 0 0
feed 5 3 0
feed 6 3 0
feed 6 4 0
rapid 99 4 0
=== expect
file 0 main.nc
13 depth 1: feed from 0 0 0 to 6 0 0 F100 t3.6
5: feed to 5 3 0 F100 t1.8974
13 depth 1: feed to 6 3 0 F100 t0.6
7: feed to 6 4 0 F100 t0.6
33 depth 5: rapid to 99 4 0 t0.372
9: event end code="M2"
end of program: 30 blocks, 5 motions, 0 errors, 0 warnings
