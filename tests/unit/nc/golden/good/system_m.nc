=== about
Digest nct-5, section 16. M11 in its own macro and M520 behind the row are ordinary functions.
proves: nct-23.3.5-Mmacro
=== settings
N1733 = 11
N1743 = 500
N1744 = 3500
N1745 = 20
=== main
G0
N5 M500 A1
M519 A2 M3
M11 A10
M520
M30
=== sub SystemMacros/Channel1/O3500.nct
X#1
M99
=== sub SystemMacros/Channel1/O3519.nct
X#1 Y#13
M99
=== sub SystemMacros/Channel1/O9020.nct
X#1 M11
M99
=== truth
rapid 1 0 0
rapid 2 3 0
rapid 10 3 0
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O3500.nct
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
file 2 SystemMacros/Channel1/O3519.nct
2/1 depth 1: rapid to 2 3 0 t0.012
file 3 SystemMacros/Channel1/O9020.nct
3/1 depth 1: event function code="M11"
3/1 depth 1: rapid to 10 3 0 t0.032
main.nc:5:1: warning[nct-m-function]: M520 is a function of the machine builder: it has no effect in the simulation
    M520
    ^~~~
5: event function code="M520"
6: event end code="M30"
end of program: 12 blocks, 3 motions, 0 errors, 1 warnings
