=== about
CBM: the way through zones 2 and 3 with its end outside; the limits of the job count for the end.
Truth: 22.4; nothing moves.
proves: nct-22.4-CBM
=== settings
N1001.CBM = 1
limit_Y = -10 10
max_errors = 20
N1000.RE3.1 = 1
N1008.1 = 50
N1009.1 = 20
=== main
G0 X60
G22 X-10 Y10 Z10 I-20 J-10 K-10 P0
G0 X-60
G0 Y-11
G23
M30
=== says
main.nc:1:1: error[nct-2063]
main.nc:3:1: error[nct-2062]
main.nc:4:1: error[nct-2057]
0 motions, 3 errors
=== expect
file 0 main.nc
1: event forbidden_zone zone=3 alarm=2063 message="entry into inner forbidden zone 3"
main.nc:1:1: error[nct-2063]: entry into inner forbidden zone 3
    G0 X60
    ^~~~~~
3: event forbidden_zone zone=2 alarm=2062 message="entry into inner forbidden zone 2"
main.nc:3:1: error[nct-2062]: entry into inner forbidden zone 2
    G0 X-60
    ^~~~~~~
4: event overtravel axis="Y" value=-11 limit=-10 alarm=2057
main.nc:4:1: error[nct-2057]: end point in negative end position on axis Y
    G0 Y-11
    ^~~~~~~
6: event end code="M30"
end of program: 6 blocks, 0 motions, 3 errors, 0 warnings
