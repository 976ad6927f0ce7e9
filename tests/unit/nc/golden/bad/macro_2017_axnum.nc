=== about
proves: nct-23.2.12-AXNUM
=== main
#1=AXNUM[Q]
M30
=== says
error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2017]: illegal address Q: the channel has no such axis
    #1=AXNUM[Q]
       ^~~~~~~~
    note: #1 is vacant
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
