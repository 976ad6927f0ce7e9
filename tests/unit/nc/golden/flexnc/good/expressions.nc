=== about
Variables, operators in their order, functions of degrees.
proves: fnc-4.2-arith fnc-4.2-trig fnc-4.2-pvar
=== settings
control = flexnc
start = 100 0 50
=== main
S300M03
P1100=50
P1101=SIN(30)*20+COS(60)*10+TAN(45)
G98F100
G00X(P1100/2)Z(2+3*4-10)
G01X(P1101)Z(-P1101/(2+2))
M02
=== truth
25 0 4
16 0 -4
=== expect
file 0 main.nc
1: event spindle rpm=300 direction="cw"
main.nc:5:1: note[fnc-rapid]: the job gives no rapid rates ([machine] rapid): rapids of two axes go straight, where the machine turns a corner
    G00X(P1100/2)Z(2+3*4-10)
    ^~~~~~~~~~~~~~~~~~~~~~~~
5: rapid from 100 0 50 to 25 0 4 t0.3
6: feed to 16 0 -4 F100 t7.225
7: event spindle rpm=0 direction="stop"
7: event end code="M02"
end of program: 7 blocks, 2 motions, 0 errors, 0 warnings
