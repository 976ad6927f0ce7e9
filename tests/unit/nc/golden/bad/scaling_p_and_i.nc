=== about
proves: nct-16.2-G51-P
=== main
G51 X0 Y0 P2 I2
M30
=== says
main.nc:1:11: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:11: error[nct-2017]: illegal address P: G51 takes P or I, J, K
    G51 X0 Y0 P2 I2
              ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
