=== about
Two P in one block.
proves: nct-10.2.2-G54.1
=== main
G0 G54.1 P16 X100 Y20 M98 P1
M30
=== sub O0001
M99
=== says
error[
=== expect
file 0 main.nc
main.nc:1:27: error[nct-duplicate-word]: two P in one block
    G0 G54.1 P16 X100 Y20 M98 P1
                              ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
