=== about
proves: nct-12.4.1-G10L75P1 nct-12.3.1-select nct-12.5.1-H99 nct-12.5.2-M62
=== settings
max_errors = 99
N2923 = 99
N2924 = 62
N2902 = 50
=== main
G10 L75
G10 L75 P4
G10 L75 P1
T5
N51
N1 T100000000
N1 Q2
N1 Q100000
N1 B5
N1 R3
N1 P21 R3
N1 P0 R2
N1 P1
N1 X5
N2 T5 Q1 B3 C9 L9
G0 X5
G11
G10 L76 P1
N5 P1 R1
N12 R1
N1 R1
N1 P1
G11
G10 L77 P6
N21
N1 P1.5
N1 T2
G11
T5
T7
G43 H99 Z0
M62 T10001
#8400=12
#8401=1
M30
=== says
main.nc:1:1: error[nct-2004]
main.nc:2:9: error[nct-2002]
main.nc:4:1: error[nct-2004]
main.nc:5:1: error[nct-2002]
main.nc:6:4: error[nct-2002]
main.nc:7:4: error[nct-2002]
main.nc:8:4: error[nct-2002]
main.nc:9:4: error[nct-2002]
main.nc:10:1: error[nct-2004]
main.nc:11:4: error[nct-2002]
main.nc:12:7: error[nct-2002]
main.nc:13:1: error[nct-2004]
main.nc:14:4: error[nct-2017]
main.nc:16:1: error[nct-2017]
main.nc:19:1: error[nct-2002]
main.nc:20:1: error[nct-2002]
main.nc:21:1: error[nct-2004]
main.nc:22:1: error[nct-2004]
main.nc:25:1: error[nct-2002]
main.nc:26:4: error[nct-2002]
main.nc:27:4: error[nct-2002]
main.nc:29:1: error[nct-no-tool]
main.nc:30:1: error[nct-no-tool]
main.nc:31:5: error[nct-2002]
main.nc:32:5: error[nct-2002]
main.nc:33:1: error[nct-2092]
main.nc:34:1: error[nct-2161]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-2004]: missing data P: which table G10 L75, L76, L77 fill
    G10 L75
    ^~~~~~~
main.nc:2:9: error[nct-2002]: P data out of range: L75 has P1, P2 and P3, L76 has P1, L77 has P6
    G10 L75 P4
            ^~
main.nc:4:1: error[nct-2004]: missing data N: the row of the tool table
    T5
    ^~
main.nc:5:1: error[nct-2002]: N data out of range: an integer from 1 to 50 is expected
    N51
    ^~~
main.nc:6:4: error[nct-2002]: T data out of range: an integer from 0 to 99999999 is expected
    N1 T100000000
       ^~~~~~~~~~
main.nc:7:4: error[nct-2002]: Q data out of range: digits 0 and 1
    N1 Q2
       ^~
main.nc:8:4: error[nct-2002]: Q data out of range: up to 5 digits 0 and 1
    N1 Q100000
       ^~~~~~~
main.nc:9:4: error[nct-2002]: B data out of range: an integer from 0 to 4 is expected
    N1 B5
       ^~
main.nc:10:1: error[nct-2004]: missing data P: the number of the column
    N1 R3
    ^~~~~
main.nc:11:4: error[nct-2002]: P data out of range: an integer from 0 to 20 is expected
    N1 P21 R3
       ^~~
main.nc:12:7: error[nct-2002]: R data out of range: digits 0 and 1
    N1 P0 R2
          ^~
main.nc:13:1: error[nct-2004]: missing data R: the value of the column
    N1 P1
    ^~~~~
main.nc:14:4: error[nct-2017]: illegal address X: in tool data
    N1 X5
       ^~
main.nc:16:1: error[nct-2017]: illegal address G: data input is open: G11 ends it
    G0 X5
    ^~
main.nc:19:1: error[nct-2002]: N data out of range: magazines are 1 to 4 and 10, 11, 20, 21, ... 91
    N5 P1 R1
    ^~
main.nc:20:1: error[nct-2002]: N data out of range: magazines are 1 to 4 and 10, 11, 20, 21, ... 91
    N12 R1
    ^~~
main.nc:21:1: error[nct-2004]: missing data P: in tool data
    N1 R1
    ^~~~~
main.nc:22:1: error[nct-2004]: missing data R: in tool data
    N1 P1
    ^~~~~
main.nc:25:1: error[nct-2002]: N data out of range: an integer from 1 to 20 is expected
    N21
    ^~~
main.nc:26:4: error[nct-2002]: P data out of range: half pockets are whole numbers
    N1 P1.5
       ^~~~
main.nc:27:4: error[nct-2002]: T data out of range: an integer from 0 to 1 is expected
    N1 T2
       ^~
main.nc:29:1: error[nct-no-tool]: no tool of type 5 may be used: it is not in the tool management table, or all are expired or broken
    T5
    ^~
main.nc:30:1: error[nct-no-tool]: no tool of type 7 may be used: it is not in the tool management table, or all are expired or broken
    T7
    ^~
main.nc:31:5: error[nct-2002]: H data out of range: it stands for the offset of the tool in the spindle, which tool management does not know
    G43 H99 Z0
        ^~~
main.nc:32:5: error[nct-2002]: T data out of range: magazine 1 has no tool in pocket 1
    M62 T10001
        ^~~~~~
main.nc:33:1: error[nct-2092]: value limit exceeded: #8400
    #8400=12
    ^~~~~~~~
main.nc:34:1: error[nct-2161]: variable #8401 is read-only
    #8401=1
    ^~~~~~~
35: event end code="M30"
end of program: 35 blocks, 0 motions, 27 errors, 0 warnings
