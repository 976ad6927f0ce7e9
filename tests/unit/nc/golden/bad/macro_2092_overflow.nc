=== main
#1=EXP700
#2=#1*#1
M30
=== says
error[nct-2092]
=== expect
file 0 main.nc
main.nc:2:4: error[nct-2092]: value limit exceeded: the result is beyond 1.7E308
    #2=#1*#1
       ^~~~~
    note: #2 is vacant
    note: #1 = 1.0142320547350045e+304
alarm: 2 blocks, 0 motions, 1 errors, 0 warnings
