=== about
proves: nct-17.1-2082
=== main
G1 X30 ,R5 ,C5 F100
Y20
M30
=== says
error[nct-2082]
=== expect
file 0 main.nc
main.nc:1:8: error[nct-2082]: either chamfer or rounding: ,C and ,R in one block
    G1 X30 ,R5 ,C5 F100
           ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
