=== about
The codes of each group by #4001 to #4022; codes with a point have the digit behind it in front.
proves: nct-23.1.14-#4001
=== settings
axis = C 4 rotary
N1757.PNT = 1
=== main
FOPEN1 P12
S100 M3
G0
DPRNT[#4001[3]]
G1 F100
DPRNT[#4001[3]]
G2 R10
DPRNT[#4001[3]]
G3 R10
DPRNT[#4001[3]]
G33 Z-1 F1
DPRNT[#4001[3]]
G0 Z0
DPRNT[#4001[3]]
G18
DPRNT[#4002[3]]
G19
DPRNT[#4002[3]]
G17
DPRNT[#4002[3]]
G91
DPRNT[#4003[3]]
G90
DPRNT[#4003[3]]
G95
DPRNT[#4005[3]]
G94
DPRNT[#4005[3]]
G20
DPRNT[#4006[3]]
G21
DPRNT[#4006[3]]
G41 D0
DPRNT[#4007[3]]
G42
DPRNT[#4007[3]]
G40
DPRNT[#4007[3]]
G43 H0
DPRNT[#4008[3]]
G44 H0
DPRNT[#4008[3]]
G43.7 H0
DPRNT[#4008[3]]
G49
DPRNT[#4008[3]]
G73 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G74 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G76 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G81 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G82 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G83 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G84 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G84.2 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G84.3 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G85 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G86 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G87 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G88 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G89 X0 Z-1 R1 Q1 L0 F100
DPRNT[#4009[3]]
G80
DPRNT[#4009[3]]
G81 G99 X0 Z-1 R1 L0
DPRNT[#4010[3]]
G98
DPRNT[#4010[3]]
G80
DPRNT[#4010[3]]
G51 X0 Y0 P1
DPRNT[#4011[3]]
G50
DPRNT[#4011[3]]
G66 P1
DPRNT[#4012[3]]
G67
DPRNT[#4012[3]]
G96 S100
DPRNT[#4013[3]]
G97
DPRNT[#4013[3]]
G55
DPRNT[#4014[3]]
G56
DPRNT[#4014[3]]
G57
DPRNT[#4014[3]]
G58
DPRNT[#4014[3]]
G59
DPRNT[#4014[3]]
G54.1 P1
DPRNT[#4014[3]]
G54
DPRNT[#4014[3]]
G61
DPRNT[#4015[3]]
G62
DPRNT[#4015[3]]
G63
DPRNT[#4015[3]]
G64
DPRNT[#4015[3]]
G68 X0 Y0 R0
DPRNT[#4016[3]]
G69
DPRNT[#4016[3]]
G16
DPRNT[#4017[3]]
G15
DPRNT[#4017[3]]
G17 G0 X10 C0
G12.1
DPRNT[#4021[3]]
G13.1
DPRNT[#4021[3]]
G51.1 Y0
DPRNT[#4022[3]]
G50.1 Y0
DPRNT[#4022[3]]
FCLOS
M30
=== sub O0001
M99
=== says
0\0D\0A1\0D\0A2\0D\0A3\0D\0A33\0D\0A0\0D\0A18\0D\0A19\0D\0A17\0D\0A91\0D\0A90\0D\0A95\0D\0A94\0D\0A20\0D\0A21\0D\0A41\0D\0A42\0D\0A40\0D\0A43\0D\0A44\0D\0A743\0D\0A49\0D\0A73\0D\0A74\0D\0A76\0D\0A81\0D\0A82\0D\0A83\0D\0A84\0D\0A284\0D\0A384\0D\0A85\0D\0A86\0D\0A87\0D\0A88\0D\0A89\0D\0A80\0D\0A99\0D\0A98\0D\0A98\0D\0A51\0D\0A50\0D\0A66\0D\0A67\0D\0A96\0D\0A97\0D\0A55\0D\0A56\0D\0A57\0D\0A58\0D\0A59\0D\0A154\0D\0A54\0D\0A61\0D\0A62\0D\0A63\0D\0A64\0D\0A68\0D\0A69\0D\0A16\0D\0A15\0D\0A112\0D\0A113\0D\0A151\0D\0A150\0D\0A
=== expect
file 0 main.nc
2: event spindle rpm=100 direction="cw"
main.nc:7:4: warning[nct-unused-word]: R10 does nothing in this block of G2: the arc ends where it starts; a full circle needs I, J or K
    G2 R10
       ^~~
main.nc:9:4: warning[nct-unused-word]: R10 does nothing in this block of G3: the arc ends where it starts; a full circle needs I, J or K
    G3 R10
       ^~~
11: event thread lead=1 angle=0
11: thread from 0 0 0 to 0 0 -1 C 0 to 0 F100 t0.6
13: rapid to 0 0 0 C 0 to 0 t0.004
main.nc:29:1: warning[nct-feed-unit]: the unit changes: the modal feed keeps its number and takes the new unit
    G20
    ^~~
main.nc:31:1: warning[nct-feed-unit]: the unit changes: the modal feed keeps its number and takes the new unit
    G21
    ^~~
main.nc:35:1: warning[nct-no-d]: no D is programmed: cutter compensation runs with radius 0
    G42
    ^~~
main.nc:49:15: warning[nct-unused-word]: Q1 does nothing in this block of G74: the cycle does not read it; another one may, until G80
    G74 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:51:15: warning[nct-unused-word]: Q1 does nothing in this block of G76: the cycle does not read it; another one may, until G80
    G76 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:53:15: warning[nct-unused-word]: Q1 does nothing in this block of G81: the cycle does not read it; another one may, until G80
    G81 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:55:15: warning[nct-unused-word]: Q1 does nothing in this block of G82: the cycle does not read it; another one may, until G80
    G82 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:59:15: warning[nct-unused-word]: Q1 does nothing in this block of G84: the cycle does not read it; another one may, until G80
    G84 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:65:15: warning[nct-unused-word]: Q1 does nothing in this block of G85: the cycle does not read it; another one may, until G80
    G85 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:67:15: warning[nct-unused-word]: Q1 does nothing in this block of G86: the cycle does not read it; another one may, until G80
    G86 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:69:15: warning[nct-unused-word]: Q1 does nothing in this block of G87: the cycle does not read it; another one may, until G80
    G87 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:71:15: warning[nct-unused-word]: Q1 does nothing in this block of G88: the cycle does not read it; another one may, until G80
    G88 X0 Z-1 R1 Q1 L0 F100
                  ^~
main.nc:73:15: warning[nct-unused-word]: Q1 does nothing in this block of G89: the cycle does not read it; another one may, until G80
    G89 X0 Z-1 R1 Q1 L0 F100
                  ^~
file 1 O0001
91: event spindle rpm=1000000 direction="cw"
93: event spindle rpm=1000000 direction="cw"
main.nc:95:1: warning[nct-offset-missing]: G55 has no value in the job: 0 is taken (--offset G55=X,Y,Z)
    G55
    ^~~
main.nc:97:1: warning[nct-offset-missing]: G56 has no value in the job: 0 is taken (--offset G56=X,Y,Z)
    G56
    ^~~
main.nc:99:1: warning[nct-offset-missing]: G57 has no value in the job: 0 is taken (--offset G57=X,Y,Z)
    G57
    ^~~
main.nc:101:1: warning[nct-offset-missing]: G58 has no value in the job: 0 is taken (--offset G58=X,Y,Z)
    G58
    ^~~
main.nc:103:1: warning[nct-offset-missing]: G59 has no value in the job: 0 is taken (--offset G59=X,Y,Z)
    G59
    ^~~
main.nc:105:1: warning[nct-offset-missing]: G54.1 P1 has no value in the job: 0 is taken (--offset G54.1P1=X,Y,Z)
    G54.1 P1
    ^~~~~~~~
125: rapid to 10 0 0 C 0 to 0 t0.04
126: event virtual_plane code="G12.1" on=true axes="X C"
128: event virtual_plane code="G12.1" on=false axes="X C"
134: event output file="O0012.nc" bytes=263
135: event end code="M30"
file O0012.nc: 0\0D\0A1\0D\0A2\0D\0A3\0D\0A33\0D\0A0\0D\0A18\0D\0A19\0D\0A17\0D\0A91\0D\0A90\0D\0A95\0D\0A94\0D\0A20\0D\0A21\0D\0A41\0D\0A42\0D\0A40\0D\0A43\0D\0A44\0D\0A743\0D\0A49\0D\0A73\0D\0A74\0D\0A76\0D\0A81\0D\0A82\0D\0A83\0D\0A84\0D\0A284\0D\0A384\0D\0A85\0D\0A86\0D\0A87\0D\0A88\0D\0A89\0D\0A80\0D\0A99\0D\0A98\0D\0A98\0D\0A51\0D\0A50\0D\0A66\0D\0A67\0D\0A96\0D\0A97\0D\0A55\0D\0A56\0D\0A57\0D\0A58\0D\0A59\0D\0A154\0D\0A54\0D\0A61\0D\0A62\0D\0A63\0D\0A64\0D\0A68\0D\0A69\0D\0A16\0D\0A15\0D\0A112\0D\0A113\0D\0A151\0D\0A150\0D\0A
end of program: 135 blocks, 3 motions, 0 errors, 21 warnings
