=== about
A pocket may name a row that the tool table lacks, and a row may be deleted while T waits for M6.
proves: nct-12.5.2-M62 nct-12.3.2-location
=== settings
N2924 = 62
max_errors = 5
=== main
G10 L76 P1
N1 P12 R7
G11
M62 T10012
G10 L75 P1
N1 T500 Q1 B2
N2 T600 Q1 B2
G11
T500
G10 L75 P3
N1
G11
M6
M62 T100001
M30
=== says
main.nc:4:5: error[nct-2002]
main.nc:14:5: error[nct-2002]
=== expect
file 0 main.nc
main.nc:4:5: error[nct-2002]: T data out of range: magazine 1 has no tool in pocket 12
    M62 T10012
        ^~~~~~
13: event tool tool=500 row=1
main.nc:14:5: error[nct-2002]: T data out of range: magazine 10 has no tool in pocket 1
    M62 T100001
        ^~~~~~~
15: event end code="M30"
end of program: 15 blocks, 0 motions, 2 errors, 0 warnings
