=== about
proves: nct-23.2.6-brackets
=== main
#1=2+3]
M30
=== says
error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-2064]: syntax error: nothing may follow the statement
    #1=2+3]
          ^
    note: #1 = 5
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
