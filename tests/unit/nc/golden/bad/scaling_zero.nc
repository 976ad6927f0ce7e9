=== about
proves: nct-16.2-G51-IJK
=== main
G51 X0 Y0 I0
M30
=== says
main.nc:1:11: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:11: error[nct-2002]: I data out of range: a factor from 0.000001 to 1000000, or its opposite
    G51 X0 Y0 I0
              ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
