=== about
DPRNT without spaces (N1757.PNT), rounding, values with more digits than asked for, vacant ones; names in small letters; file
by number; appending to what this run has written.
proves: nct-23.2.13-DPRNT nct-23.2.13-FOPEN
=== settings
N1757.PNT = 1
=== main
#130=35.897421
#500=-150.8
#10=14.8
FOPEN1 P12
DPRNT[X#130[53]Y#500[53]T#10[20]]
dprnt[abc* #130[11]  /]
FCLOS
FOPEN3P12
DPRNT[#500[10]#0[21]#[500][24]#_MAINO[3]]
FCLOS
#1=4
FOPEN#1 P12345
DPRNT[A]
FCLOS
FOPEN5 <O0012.nc>
DPRNT[#20[3]+-]
M30
=== says
O00012345.nc: A\0D\0A
O0012.nc: 0+-\0D\0A
=== expect
file 0 main.nc
7: event output file="O0012.nc" bytes=32
10: event output file="O0012.nc" bytes=19
14: event output file="O00012345.nc" bytes=3
main.nc:17:1: warning[nct-output]: the program ends while it has a file open: what it wrote so far is kept
    M30
    ^~~
17: event output file="O0012.nc" bytes=5
17: event end code="M30"
file O00012345.nc: A\0D\0A
file O0012.nc: 0+-\0D\0A
end of program: 17 blocks, 0 motions, 0 errors, 1 warnings
