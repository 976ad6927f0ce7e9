=== about
P is needed, its digits are channels, and the code stands alone with it.
=== settings
N2201 = 500
N2202 = 599
max_errors = 10
=== main
M501
M501 P9
M501 P11
M501 P12 X5
M501 M502 P12
M501 P1.5
M30
=== says
main.nc:1:1: error[nct-2004]
main.nc:2:6: error[nct-2002]
main.nc:3:6: error[nct-2002]
main.nc:4:1: error[nct-wait]
main.nc:5:1: error[nct-wait]
main.nc:6:6: error[nct-2002]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: M501 needs the channels that meet
    M501
    ^~~~
main.nc:2:6: error[nct-2002]: P data out of range: each digit is a channel, 1 to 8, and stands there once
    M501 P9
         ^~
main.nc:3:6: error[nct-2002]: P data out of range: each digit is a channel, 1 to 8, and stands there once
    M501 P11
         ^~~
main.nc:4:1: error[nct-wait]: the waiting code M501 and its P stand alone in a block
    M501 P12 X5
    ^~~~
main.nc:5:1: error[nct-wait]: the waiting code M501 and its P stand alone in a block
    M501 M502 P12
    ^~~~
main.nc:6:6: error[nct-2002]: P data out of range: an integer from 1 to 99999999 is expected
    M501 P1.5
         ^~~~
7: event end code="M30"
end of program: 7 blocks, 0 motions, 6 errors, 0 warnings
