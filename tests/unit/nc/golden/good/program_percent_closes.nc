=== about
A % behind the end of the program, or with nothing behind it, closes the program: what stands above is no leader.
proves: nct-14.4.1-O
=== main
G0 X10
M98 P20
M30
%
G0 X999
%
=== sub O0020
G0 Y5
M99
%
=== truth
10 0 0
10 5 0
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 10 0 0 t0.04
file 1 O0020
1/1 depth 1: rapid to 10 5 0 t0.02
3: event end code="M30"
end of program: 5 blocks, 2 motions, 0 errors, 0 warnings
