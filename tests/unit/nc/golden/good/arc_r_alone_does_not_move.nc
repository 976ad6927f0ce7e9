=== about
proves: nct-4.3-full
=== main
G0 X200 Y0 F500
G17 G03 R100
M30
=== truth
200 0 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 200 0 0 t0.8
main.nc:2:9: warning[nct-unused-word]: R100 does nothing in this block of G3: the arc ends where it starts; a full circle needs I, J or K
    G17 G03 R100
            ^~~~
3: event end code="M30"
end of program: 3 blocks, 1 motions, 0 errors, 1 warnings
