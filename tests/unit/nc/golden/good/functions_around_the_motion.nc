=== about
M3 and M8 before the motion, M5 behind it; T before M6. M6 without T keeps the tool, G4 without P waits for nothing, with warnings.
proves: nct-12.2-M6 nct-8-G4 nct-11.2-M5
=== main
M6
G0 X1 M3 S100 M8
X2 M5
T5 M6 X3
G4
M30
=== truth
1 0 0
2 0 0
3 0 0
=== says
warning[nct-no-t]
spindle rpm=100 direction="cw"
coolant code="M8"
rapid from 0 0 0 to 1 0 0
rapid to 2 0 0
direction="stop"
tool tool=5
warning[nct-2004]
=== expect
file 0 main.nc
main.nc:1:1: warning[nct-no-t]: M6 without T: the tool stays
    M6
    ^~
1: event tool tool=0
2: event spindle rpm=100 direction="cw"
2: event coolant code="M8" on=true
2: rapid from 0 0 0 to 1 0 0 t0.004
3: rapid to 2 0 0 t0.004
3: event spindle rpm=0 direction="stop"
4: rapid to 3 0 0 t0.004
4: event tool tool=5
main.nc:5:1: warning[nct-2004]: G4 without P: no dwell
    G4
    ^~
5: event dwell seconds=0
6: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 2 warnings
