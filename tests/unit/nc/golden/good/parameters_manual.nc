=== about
The manual's example: three parameters written, four read. B then calls O9031, and the rotary axis rolls over.
proves: nct-24.1-G10L52 nct-24.2-PRM nct-24-kinds
=== settings
axis = C 4 rotary carries nothing
=== main
#105=PRM[1746,1]
G10 L52
N107 P4 Q0 R1
N1339 (P1) R0.5
N1746 (P1) Q1 R1
G11
#101=PRM[107,0]/[4]
#102=PRM[1339](/[1])
#103=PRM[1746,1](/[1])
#104=PRM[1339]/[1]
G0 X#101 Y#102 Z#103
X#104 Z#105
B12
C390
M30
=== sub SystemMacros/Channel1/O9031.nct
Y#196
M99
=== truth
1 0.5 1
0.5 0.5 0
0.5 12 0
0.5 12 0 rotary 30
=== expect
file 0 main.nc
11: rapid from 0 0 0 to 1 0.5 1 C 0 to 0 t0.004
12: rapid to 0.5 0.5 0 C 0 to 0 t0.004
file 1 SystemMacros/Channel1/O9031.nct
1/1 depth 1: rapid to 0.5 12 0 C 0 to 0 t0.046
main.nc:14:1: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    C390
    ^~~~
14: rapid to 0.5 12 0 C 0 to 30 t0.12
15: event end code="M30"
end of program: 17 blocks, 4 motions, 0 errors, 0 warnings
