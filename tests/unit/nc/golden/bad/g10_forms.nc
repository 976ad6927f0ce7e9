=== about
What the forms of G10 do not take.
proves: nct-15.2-G10-L110
=== settings
max_errors = 30
N1400 = 20
=== main
G10 L110 R1
G10 L111 P1
G10 L111 P1 R1 X1
G10 L111 P21 R1
G10 L200 P1
G10 L200 P1 Q10
G10 L200 P1 I1
G10 L202 P1 X1
G10 L2 P1 Q1 X1
M30
=== says
main.nc:1:1: error[nct-2004]
main.nc:2:1: error[nct-2004]
main.nc:3:16: error[nct-2017]
main.nc:4:10: error[nct-2002]
main.nc:5:1: error[nct-2004]
main.nc:6:13: error[nct-2002]
main.nc:7:13: error[nct-2017]
main.nc:8:13: error[nct-2017]
main.nc:9:11: error[nct-2017]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: G10 needs P
    G10 L110 R1
    ^~~~~~~~~~~
main.nc:2:1: error[nct-2004]: missing data R: the value of the offset
    G10 L111 P1
    ^~~~~~~~~~~
main.nc:3:16: error[nct-2017]: illegal address X: in this form of G10
    G10 L111 P1 R1 X1
                   ^~
main.nc:4:10: error[nct-2002]: P data out of range: an integer from 1 to 20 is expected
    G10 L111 P21 R1
             ^~~
main.nc:5:1: error[nct-2004]: missing data: G10 L200, L201 need X, Y, Z, R or Q
    G10 L200 P1
    ^~~~~~~~~~~
main.nc:6:13: error[nct-2002]: Q data out of range: an integer from 0 to 9 is expected
    G10 L200 P1 Q10
                ^~~
main.nc:7:13: error[nct-2017]: illegal address I: in this form of G10
    G10 L200 P1 I1
                ^~
main.nc:8:13: error[nct-2017]: illegal address X: in this form of G10
    G10 L202 P1 X1
                ^~
main.nc:9:11: error[nct-2017]: illegal address Q: in G10 L2, L20
    G10 L2 P1 Q1 X1
              ^~
10: event end code="M30"
end of program: 10 blocks, 0 motions, 9 errors, 0 warnings
