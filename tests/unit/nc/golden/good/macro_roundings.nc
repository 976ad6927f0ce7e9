=== about
FUP of a whole number leaves it; MOD keeps the sign of the dividend. More digits than asked for are all printed; the last digit of three is
that of the decimals.
proves: nct-23.2.5-FUP nct-23.2.2-MOD nct-23.2.13-DPRNT nct-23.2.12-AX
=== settings
axis = C 4 rotary carries nothing
N1757.PNT = 1
=== main
G0 X[FUP12] Y[7MOD-4] Z[-7.5MOD2]
AX[4]=10
AX[4]=I10
#1=12345
FOPEN1 P1
DPRNT[#1[20]]
DPRNT[#1[123]]
FCLOS
M30
=== truth
12 3 -1.5 rotary 0
12 3 -1.5 rotary 10
12 3 -1.5 rotary 20
=== says
12345\0D\0A12345.000\0D\0A
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 12 3 -1.5 C 0 to 0 t0.048
main.nc:2:1: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    AX[4]=10
    ^~~~~~~~
2: rapid to 12 3 -1.5 C 0 to 10 t0.04
3: rapid to 12 3 -1.5 C 10 to 20 t0.04
8: event output file="O0001.nc" bytes=18
9: event end code="M30"
file O0001.nc: 12345\0D\0A12345.000\0D\0A
end of program: 9 blocks, 3 motions, 0 errors, 0 warnings
