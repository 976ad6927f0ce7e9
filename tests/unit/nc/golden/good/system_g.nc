=== about
Digest nct-5, section 15: single codes, a row of codes and a row with one decimal; a code of the control in its own macro is ordinary.
proves: nct-23.3.4-Gmacro nct-23.3.4-Gblock nct-23.3.4-Gdec nct-23.3.4-Gself
=== settings
N1704 = 12
N1705 = 101
N1706 = 1
N1714 = 2000
N1715 = 3400
N1716 = 50
N1717 = 310.5
N1718 = 4000
N1719 = 10
=== main
G0 X1
G12 X5 L2
G101 X6
G2000 A1
G2049 A2
G310.5 A3
G311.4 A4
G#30
M30
=== sub SystemMacros/Channel1/O9010.nct
G1 X#24 Y#12 F1000
G0
M99
=== sub SystemMacros/Channel1/O9011.nct
G0 X#24 Y#10
M99
=== sub SystemMacros/Channel1/O9012.nct
G1 X#24 Y#25 Z#26 F#9
M99
=== sub SystemMacros/Channel1/O3400.nct
G0 X#10 Y#1
M99
=== sub SystemMacros/Channel1/O3449.nct
G0 X#10 Y#1
M99
=== sub SystemMacros/Channel1/O4000.nct
G0 X#10 Y#1
M99
=== sub SystemMacros/Channel1/O4009.nct
G0 X#10 Y#1
M99
=== truth
rapid 1 0 0
feed 5 2 0
rapid 6 101 0
rapid 2000 1 0
rapid 2049 2 0
rapid 310.5 3 0
rapid 311.4 4 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 1 0 0 t0.004
file 1 SystemMacros/Channel1/O9010.nct
1/1 depth 1: feed to 5 2 0 F1000 t0.2683
file 2 SystemMacros/Channel1/O9011.nct
2/1 depth 1: rapid to 6 101 0 t0.396
file 3 SystemMacros/Channel1/O3400.nct
3/1 depth 1: rapid to 2000 1 0 t7.976
file 4 SystemMacros/Channel1/O3449.nct
4/1 depth 1: rapid to 2049 2 0 t0.196
file 5 SystemMacros/Channel1/O4000.nct
5/1 depth 1: rapid to 310.5 3 0 t6.954
file 6 SystemMacros/Channel1/O4009.nct
6/1 depth 1: rapid to 311.4 4 0 t0.004
9: event end code="M30"
end of program: 21 blocks, 7 motions, 0 errors, 0 warnings
