=== about
Digest nct-5, section 17: the motion first, then the subprogram, which shares the locals. M50 in its own subprogram and M630 are
ordinary functions.
proves: nct-23.3.6-Msub
=== settings
N1720 = 50
N1730 = 600
N1731 = 3600
N1732 = 30
=== main
#1=4
G0 X10 M600
X20 M629 M8
M8 M50 Y1
M630
M30
=== sub SystemMacros/Channel1/O3600.nct
Y#1
M99
=== sub SystemMacros/Channel1/O3629.nct
Z9
M99
=== sub SystemMacros/Channel1/O9000.nct
G91 X1 M50
G90
M99
=== truth
rapid 10 0 0
rapid 10 4 0
rapid 20 4 0
rapid 20 4 9
rapid 20 1 9
rapid 21 1 9
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O3600.nct
2: rapid from 0 0 0 to 10 0 0 t0.04
1/1 depth 1: rapid to 10 4 0 t0.016
file 2 SystemMacros/Channel1/O3629.nct
3: event coolant code="M8" on=true
3: rapid to 20 4 0 t0.04
2/1 depth 1: rapid to 20 4 9 t0.036
file 3 SystemMacros/Channel1/O9000.nct
4: event coolant code="M8" on=true
4: rapid to 20 1 9 t0.012
SystemMacros/Channel1/O9000.nct:1:8: warning[nct-m-function]: M50 is a function of the machine builder: it has no effect in the simulation
    G91 X1 M50
           ^~~
    note: called from main.nc:4 by M50 (system call)
3/1 depth 1: rapid to 21 1 9 t0.004
3/1 depth 1: event function code="M50"
main.nc:5:1: warning[nct-m-function]: M630 is a function of the machine builder: it has no effect in the simulation
    M630
    ^~~~
5: event function code="M630"
6: event end code="M30"
end of program: 13 blocks, 6 motions, 0 errors, 2 warnings
