=== main
M98 P11 L0
M30
=== sub O0011.nc
M99
=== says
main.nc:1:9: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:9: error[nct-2002]: L data out of range: an integer from 1 to 99999999 is expected
    M98 P11 L0
            ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
