=== about
G22 and G23 stand in blocks of their own; limits are ordered and P is 0 or 1.
Truth: the place of each word that 22.2 forbids; nothing moves.
proves: nct-22.2-G22 nct-22.2-G23
=== settings
max_errors = 20
=== main
G22 X10 I0 M8
G22 G90 X10
G22 X10 S100
G22 X10 F5
G22 U10
G22 X10 P2
G22 X10 I20
G22 XI10
G23 G90
G23 M3
G23 X1
M30
=== says
main.nc:1:12: error
main.nc:2:5: error
main.nc:3:9: error
main.nc:4:9: error
main.nc:5:5: error
main.nc:6:9: error
main.nc:7:5: error
main.nc:8:5: error
main.nc:9:5: error
main.nc:10:5: error
main.nc:11:5: error
0 motions, 11 errors
=== expect
file 0 main.nc
main.nc:1:12: error[nct-own-block]: G22 stands in a block of its own
    G22 X10 I0 M8
               ^~
main.nc:2:5: error[nct-own-block]: G22 stands in a block of its own
    G22 G90 X10
        ^~~
main.nc:3:9: error[nct-own-block]: G22 stands in a block of its own
    G22 X10 S100
            ^~~~
main.nc:4:9: error[nct-own-block]: G22 stands in a block of its own
    G22 X10 F5
            ^~
main.nc:5:5: error[nct-own-block]: G22 stands in a block of its own
    G22 U10
        ^~~
main.nc:6:9: error[nct-2002]: P data out of range: an integer from 0 to 1 is expected
    G22 X10 P2
            ^~
main.nc:7:5: error[nct-2002]: X data out of range: the positive limit of G22 is below the negative one
    G22 X10 I20
        ^~~
main.nc:8:5: error[nct-2097]: illegal incremental movement on axis X: limits of G22 are machine coordinates
    G22 XI10
        ^~~~
main.nc:9:5: error[nct-own-block]: G23 stands in a block of its own
    G23 G90
        ^~~
main.nc:10:5: error[nct-own-block]: G23 stands in a block of its own
    G23 M3
        ^~
main.nc:11:5: error[nct-own-block]: G23 stands in a block of its own
    G23 X1
        ^~
12: event end code="M30"
end of program: 12 blocks, 0 motions, 11 errors, 0 warnings
