=== about
Names of axes and spindles of two and three characters: behind a letter the value follows, behind a digit =; the operator I
stands behind =. Numbers with and without a point, in millimetres and degrees.
proves: nct-2.2-extname nct-5.1-I nct-5.5-decimals nct-1.1-ABC
=== settings
axis = XDE 4 linear parallel X
axis = X2 5 linear parallel X
axis = Z1 6 linear parallel Z
axis = B 7 rotary carries nothing
spindle = 1 name S1
spindle = 2 name SSB
=== main
G0 XDE127.81
Z1=87.257
X2=100
X2=I100
X2.134 B24.236
X325
S1=8700 M3
SSB12500 M3
M30
=== truth
127.81 0 0
127.81 0 87.257
227.81 0 87.257
327.81 0 87.257
329.944 0 87.257 rotary 24.236
652.81 0 87.257
=== says
spindle rpm=8700 direction="cw" spindle=1
spindle rpm=12500 direction="cw" spindle=2
=== expect
file 0 main.nc
1: rapid from 0 0 0 to 127.81 0 0 B 0 to 0 t0.5112
2: rapid to 127.81 0 87.257 B 0 to 0 t0.349
3: rapid to 227.81 0 87.257 B 0 to 0 t0.4
4: rapid to 327.81 0 87.257 B 0 to 0 t0.4
main.nc:5:8: note[nct-rotary-told]: axis B turns nothing that the job describes: its position is told, the path does not follow it
    X2.134 B24.236
           ^~~~~~~
5: rapid to 329.944 0 87.257 B 0 to 24.236 t0.0969
6: rapid to 652.81 0 87.257 B 24.236 to 24.236 t1.2915
7: event spindle rpm=8700 direction="cw" spindle=1
8: event spindle rpm=12500 direction="cw" spindle=2
9: event end code="M30"
end of program: 9 blocks, 6 motions, 0 errors, 0 warnings
