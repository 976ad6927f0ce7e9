=== about
Cutter compensation finds out late, when the macro has returned: the alarm still tells who called the block and with what values.
Truth: walls at Y0 and Y3 on both sides of a step of 3, the tool is 20 wide; the motion stops before N30 (15.5.7).
proves: nct-15.5.7-2049
=== settings
D1 = 10
=== main
G0 X-100
G41 G1 X-50 D1 F1000
G65 P11 A40 B3
X-50
G40 X-90
M30
=== sub O0011
N30 X#1
N40 Y#2
M99
=== truth
rapid -100 0 0
feed -50 10 0 F 1000 t 3.0594
=== says
O0011:2:1: error[nct-2049]
main.nc:3 by G65 #1=40 #2=3
Y#2 = 3
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
file 1 O0011
2: feed to -50 10 0 F1000 t3.0594
O0011:2:1: error[nct-2049]: interference error: the compensated path runs against the programmed one
    N40 Y#2
    ^~~~~~~
    note: called from main.nc:3 by G65 #1=40 #2=3 #10=65 #16=11
    note: Y#2 = 3
alarm: 8 blocks, 2 motions, 1 errors, 0 warnings
