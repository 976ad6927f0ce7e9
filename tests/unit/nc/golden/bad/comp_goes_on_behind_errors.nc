=== about
Found by fuzzing: the tool moved without a feed.
=== settings
D1 = 5
max_errors = 20
=== main
G0 X-100 Y0 F100
G41 X-50 D1
G1 X
G91 G28 Y0
G90 G1 X0 Y0
G10 L2 P1 I0 J30
G0 X100 Y50 Z20
G1000 Y50
X0Q Y0
G42 G0 G49
N20 20 K10 Y0
X50
G40 X80
M30
=== says
main.nc:3:4: error[nct-2064]
main.nc:8:1: error[nct-2123]
main.nc:9:3: error[nct-2064]
main.nc:11:5: error[nct-2064]
=== expect
file 0 main.nc
1: rapid from 0 0 0 to -100 0 0 t0.4
main.nc:3:4: error[nct-2064]: syntax error: X has no value
    G1 X
       ^
main.nc:4:1: warning[nct-reference]: the job does not give reference point 1: the start position is taken; a job file tells it by reference_points under [machine]
    G91 G28 Y0
    ^~~~~~~~~~
2: rapid to -50 0 0 t0.2
5: feed to 0 0 0 F100 t30
main.nc:8:1: error[nct-2123]: function not implemented: G1000 is not a code of this control
    G1000 Y50
    ^~~~~
main.nc:9:3: error[nct-2064]: syntax error: QY is no word: a word is a letter with a number, text stands in ( )
    X0Q Y0
      ^~~
7: rapid to 96.6025 50 -32.6795 t0.3864
main.nc:11:5: error[nct-2064]: syntax error: '2' does not start a word
    N20 20 K10 Y0
        ^
12: rapid to 48.9711 55 -5.1795 t0.1905
12: rapid to 48.9711 45 -5.1795 t0.04
13: rapid to 79.282 50 -22.6795 t0.1212
14: event end code="M30"
end of program: 14 blocks, 7 motions, 4 errors, 1 warnings
