=== about
G1 calls O9010 (N1704 = 1); in it G1 is the ordinary code, so that one line moves. G0 is entered as 1000.
proves: nct-23.3.4-Gmacro nct-23.3.4-Gself
=== settings
N1704 = 1
N1705 = 1000
=== main
G1 X5
G0 Y7
M30
=== sub SystemMacros/Channel1/O9010.nct
G1 X#24 F100
M99
=== sub SystemMacros/Channel1/O9011.nct
G0 Y[#25+1]
M99
=== truth
feed 5 0 0
rapid 5 8 0
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O9010.nct
1/1 depth 1: feed from 0 0 0 to 5 0 0 F100 t3
file 2 SystemMacros/Channel1/O9011.nct
2/1 depth 1: rapid to 5 8 0 t0.032
3: event end code="M30"
end of program: 7 blocks, 2 motions, 0 errors, 0 warnings
