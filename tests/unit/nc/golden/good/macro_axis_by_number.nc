=== about
Digest nct-5, section 9.
proves: nct-23.2.12-AXNUM nct-23.2.12-AX
=== settings
axis = C 6 rotary
=== main
#101=AXNUM[X]
#102=AXNUM[Y]
#103=AXNUM[Z]
G0 AX[#101]=10 AX[#102]=20 AX[#103]=30
AX[1]=[#101+10] AX[AXNUM[Z]]=-#103
X#103
#104=AXNUM[C]
X#104
M30
=== truth
rapid 10 20 30
rapid 11 20 -3
rapid 3 20 -3
rapid 6 20 -3
=== expect
file 0 main.nc
4: rapid from 0 0 0 to 10 20 30 C 0 to 0 t0.12
5: rapid to 11 20 -3 C 0 to 0 t0.132
6: rapid to 3 20 -3 C 0 to 0 t0.032
8: rapid to 6 20 -3 C 0 to 0 t0.012
9: event end code="M30"
end of program: 9 blocks, 4 motions, 0 errors, 0 warnings
