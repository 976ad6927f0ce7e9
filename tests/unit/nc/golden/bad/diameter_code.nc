=== about
G10.9 stands alone, with 0 or 1 at linear axes that N0106.MGD allows.
proves: nct-5.3.1-N0106-5
=== settings
N0106.MGD.2 = 0
axis = C 4 rotary
max_errors = 9
=== main
G10.9 Y1
G10.9 X2
G10.9 X1 F100
G10.9 G91 X1
G10.9 C1
G10.9 U1
G10.9
M30
=== says
main.nc:1:7: error[nct-diameter]
main.nc:2:7: error[nct-2002]
main.nc:3:10: error[nct-own-block]
main.nc:4:7: error[nct-own-block]
main.nc:5:7: error[nct-2035]
main.nc:6:7: error[nct-own-block]
main.nc:7:1: error[nct-2004]
=== expect
file 0 main.nc
main.nc:1:7: error[nct-diameter]: N0106.MGD = 0: G10.9 may not switch axis Y
    G10.9 Y1
          ^~
main.nc:2:7: error[nct-2002]: X data out of range: 0 is radius, 1 is diameter
    G10.9 X2
          ^~
main.nc:3:10: error[nct-own-block]: G10.9 stands in a block of its own
    G10.9 X1 F100
             ^~~~
main.nc:4:7: error[nct-own-block]: G10.9 stands in a block of its own
    G10.9 G91 X1
          ^~~
main.nc:5:7: error[nct-2035]: wrong axis data C: a rotary axis has no diameter
    G10.9 C1
          ^~
main.nc:6:7: error[nct-own-block]: G10.9 stands in a block of its own
    G10.9 U1
          ^~
main.nc:7:1: error[nct-2004]: missing data: G10.9 needs axis words: 0 radius, 1 diameter
    G10.9
    ^~~~~
8: event end code="M30"
end of program: 8 blocks, 0 motions, 7 errors, 0 warnings
