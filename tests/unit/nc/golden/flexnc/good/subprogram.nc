=== about
A subprogram called twice.
proves: fnc-3.6-GOSUB fnc-3.6-RET
=== settings
control = flexnc
start = 100 0 50
=== main
S300M03
G90G98F100
G00X10Z5
GOSUB20
G00X12
GOSUB20
M02
//НАЧАЛО ПОДПРОГРАММ
N20
G01Z-5
G00Z5
RET
=== truth
10 0 5
10 0 -5
10 0 5
12 0 5
12 0 -5
12 0 5
=== expect
file 0 main.nc
1: event spindle rpm=300 direction="cw"
main.nc:3:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X10Z5
    ^~~~~~~~
3: rapid from 100 0 50 to 10 0 5 t0.36
10 depth 1: feed to 10 0 -5 F100 t6
11 depth 1: rapid to 10 0 5 t0.04
5: rapid to 12 0 5 t0.008
10 depth 1: feed to 12 0 -5 F100 t6
11 depth 1: rapid to 12 0 5 t0.04
7: event spindle rpm=0 direction="stop"
7: event end code="M02"
end of program: 13 blocks, 6 motions, 0 errors, 0 warnings
