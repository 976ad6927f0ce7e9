=== about
Start block, rapids that end apart on each axis, absolute and incremental words, a corrector that is not the tool's:
its shift counts from the next absolute word on.
proves: fnc-0-coord fnc-1.1-G00 fnc-1.2-G01 fnc-1.7-G90 fnc-1.7-G91 fnc-2-T fnc-2-D fnc-2-M06 fnc-3.6-start
=== settings
control = flexnc
start = 40 0 20
rapid = 6000 6000 12000
param.DXW.3 = 1
param.DZW.3 = -2
=== main
T4M06D3
S300M03
G98F100
G90
G00X25Z5
G01Z-10
G91G01X2Z-3
G90X30
D4
G00X40
M02
=== truth
31.5 0 3
26 0 3
26 0 -12
28 0 -15
31 0 -15
40 0 -15
=== expect
file 0 main.nc
1: event tool tool=4
2: event spindle rpm=300 direction="cw"
5: rapid from 40 0 20 to 31.5 0 3 t0.085
5: rapid to 26 0 3 t0.055
6: feed to 26 0 -12 F100 t9
7: feed to 28 0 -15 F100 t2.1633
8: feed to 31 0 -15 F100 t1.8
10: rapid to 40 0 -15 t0.09
11: event spindle rpm=0 direction="stop"
11: event end code="M02"
end of program: 11 blocks, 6 motions, 0 errors, 0 warnings
