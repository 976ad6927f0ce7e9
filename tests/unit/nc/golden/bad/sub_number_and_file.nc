M98 P5 <x.nc>
M30
=== says
main.nc:1:5: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:5: error[nct-2017]: illegal address P: M98 takes P or a file name
    M98 P5 <x.nc>
        ^~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
