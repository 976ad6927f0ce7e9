=== about
Auxiliary functions at B, U and A: told behind the motion of the block, kept as #4101 to #4103; U is no step of X then. C is an
axis as before.
proves: nct-13.2-aux nct-23.1.14-#4101 nct-23.1.14-#4102 nct-23.1.14-#4103 nct-23.1.14-#4301
nct-23.1.14-#4302 nct-23.1.14-#4303
=== settings
N1333 = 66
N1334 = 85
N1335 = 65
axis = C 6 rotary carries nothing
=== main
#1=7.4
G0 X10 B12345678 U-3 C90
A#1 Y5
M8 B-1
X#4101 Y#4102 Z#4103
X#_BUFA Y#_BUFB Z#_BUFC
G91 X1
G90 X#4301 Y#4302 Z#_ACTC
M30
=== truth
10 0 0
10 5 0
-1 -3 7
0 -3 7
-1 -3 7
=== expect
file 0 main.nc
main.nc:2:22: note[nct-rotary-told]: axis C turns nothing that the job describes: its position is told, the path does not follow it
    G0 X10 B12345678 U-3 C90
                         ^~~
2: rapid from 0 0 0 to 10 0 0 C 0 to 90 t0.36
2: event function code="B12345678"
2: event function code="U-3"
3: rapid to 10 5 0 C 90 to 90 t0.02
3: event function code="A7"
4: event coolant code="M8" on=true
4: event function code="B-1"
5: rapid to -1 -3 7 C 90 to 90 t0.044
7: rapid to 0 -3 7 C 90 to 90 t0.004
8: rapid to -1 -3 7 C 90 to 90 t0.004
9: event end code="M30"
end of program: 9 blocks, 5 motions, 0 errors, 0 warnings
