=== about
An assigned code inside a system program calls only with ENC.
proves: nct-23.3.4-ENC
=== settings
N1704 = 101
N1733 = 55
N1746.TM = 1
N1755.ENC = 0
=== main
G0
G101 A1
M30
=== sub SystemMacros/Channel1/O9010.nct
X#1
M55
T5
M99
=== sub SystemMacros/Channel1/O9020.nct
Y2
M99
=== sub SystemMacros/Channel1/O9034.nct
Z#199
M99
=== truth
rapid 1 0 0
=== expect
file 0 main.nc
file 1 SystemMacros/Channel1/O9010.nct
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
SystemMacros/Channel1/O9010.nct:2:1: warning[nct-m-function]: M55 is a function of the machine builder: it has no effect in the simulation
    M55
    ^~~
    note: called from main.nc:2 by G101 (system call) #1=1 #10=101
1/2 depth 1: event function code="M55"
3: event end code="M30"
end of program: 7 blocks, 1 motions, 0 errors, 1 warnings
