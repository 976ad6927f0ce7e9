G0 X12345678901234567890
M30
=== says
main.nc:1:4: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2002]: X data out of range: more than 15 digits
    G0 X12345678901234567890
       ^~~~~~~~~~~~~~~~~~~~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
