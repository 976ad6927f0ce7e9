=== about
#3000 ends the run with the alarm of the program behind what went before, whatever the number of errors that may pass.
proves: nct-23.1.8-3000
=== settings
max_errors = 10
D1 = 1
=== main
G1 G41 D1 X10 F100
X20
#3000=12(TEXT)
X30
M30
=== says
error[nct-4012]: TEXT (01401200)
=== expect
file 0 main.nc
1: feed from 0 0 0 to 10 1 0 F100 t6.0299
2: feed to 20 0 0 F100 t6.0299
main.nc:3:1: error[nct-4012]: TEXT (01401200)
    #3000=12(TEXT)
    ^~~~~~~~~~~~~~
alarm: 3 blocks, 2 motions, 1 errors, 0 warnings
