=== about
The manual's repeat: three more times.
proves: fnc-3.6-REPEAT
=== settings
control = flexnc
start = 100 0 50
=== main
S300M03
G90G98
G00X20Z0
N600
G01Z20F400
Z-20
REPEAT3(p293)FROM600
G00X(P293+30)
M02
=== truth
20 0 0
20 0 20
20 0 -20
20 0 20
20 0 -20
20 0 20
20 0 -20
20 0 20
20 0 -20
30 0 -20
=== expect
file 0 main.nc
1: event spindle rpm=300 direction="cw"
main.nc:3:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X20Z0
    ^~~~~~~~
3: rapid from 100 0 50 to 20 0 0 t0.32
5: feed to 20 0 20 F400 t3
6: feed to 20 0 -20 F400 t6
5: feed to 20 0 20 F400 t6
6: feed to 20 0 -20 F400 t6
5: feed to 20 0 20 F400 t6
6: feed to 20 0 -20 F400 t6
5: feed to 20 0 20 F400 t6
6: feed to 20 0 -20 F400 t6
main.nc:8:4: warning[fnc-variable]: programs have the variables P1100 to P8100: others are the control's own
    G00X(P293+30)
       ^~~~~~~~~~
8: rapid to 30 0 -20 t0.04
9: event spindle rpm=0 direction="stop"
9: event end code="M02"
end of program: 17 blocks, 10 motions, 0 errors, 1 warnings
