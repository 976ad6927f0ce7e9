=== about
Data of parameters that cannot be. A block that is refused changes nothing.
proves: nct-24.1-G10L52 nct-24.1-G11
=== settings
max_errors = 30
=== main
G10 L52 P1
G10 L52
N9999 R1
N1339 R-1
N1339
R1
N1337 R1
N607 Q1 R1
N607 P17 Q1 R1
N1339 P2 R1
N1337 Q8 R1
N1339 R1 X1
N1339 R2 M3
N1401 R10
G0 X10
G11 X1
G11
#100=PRM[1339]
G0 X#100
M30
=== truth
2 0 0
=== says
main.nc:1:9: error[nct-2017]
main.nc:3:1: error[nct-2002]
main.nc:4:7: error[nct-2002]
main.nc:5:1: error[nct-2004]
main.nc:6:1: error[nct-2004]
main.nc:7:1: error[nct-2004]
main.nc:8:1: error[nct-2004]
main.nc:9:6: error[nct-2002]
main.nc:10:7: error[nct-2002]
main.nc:11:7: error[nct-2002]
main.nc:12:10: error[nct-2017]
main.nc:13:10: error[nct-2017]
main.nc:14:1: error[nct-2193]
main.nc:15:1: error[nct-2017]
main.nc:16:5: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:9: error[nct-2017]: illegal address P: G10 L52 stands alone
    G10 L52 P1
            ^~
main.nc:3:1: error[nct-2002]: N data out of range: the simulation knows no such parameter
    N9999 R1
    ^~~~~
main.nc:4:7: error[nct-2002]: R data out of range: beyond the limits of the parameter
    N1339 R-1
          ^~~
main.nc:5:1: error[nct-2004]: missing data R: the value of the parameter
    N1339
    ^~~~~
main.nc:6:1: error[nct-2004]: missing data N: the number of the parameter
    R1
    ^~
main.nc:7:1: error[nct-2004]: missing data Q: the parameter consists of bits
    N1337 R1
    ^~~~~~~~
main.nc:8:1: error[nct-2004]: missing data P: the parameter belongs to an axis or a spindle
    N607 Q1 R1
    ^~~~~~~~~~
main.nc:9:6: error[nct-2002]: P data out of range: there is no such channel, axis or spindle
    N607 P17 Q1 R1
         ^~~
main.nc:10:7: error[nct-2002]: P data out of range: there is no such channel, axis or spindle
    N1339 P2 R1
          ^~
main.nc:11:7: error[nct-2002]: Q data out of range: an integer from 0 to 7 is expected
    N1337 Q8 R1
          ^~
main.nc:12:10: error[nct-2017]: illegal address X: in parameter input (G10 L52)
    N1339 R1 X1
             ^~
main.nc:13:10: error[nct-2017]: illegal address M: in parameter input (G10 L52)
    N1339 R2 M3
             ^~
main.nc:14:1: error[nct-2193]: parameter N1401 cannot be changed by G10
    N1401 R10
    ^~~~~~~~~
main.nc:15:1: error[nct-2017]: illegal address G: data input is open: G11 ends it
    G0 X10
    ^~
main.nc:16:5: error[nct-2017]: illegal address X: G11 stands alone
    G11 X1
        ^~
19: rapid from 0 0 0 to 2 0 0 t0.008
20: event end code="M30"
end of program: 20 blocks, 1 motions, 15 errors, 0 warnings
