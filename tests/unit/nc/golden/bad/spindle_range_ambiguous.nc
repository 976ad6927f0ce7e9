=== about
S900 lies in both ranges: a code must choose (8.3).
proves: nct-11.3-M11-M18 nct-11.1.1-SP nct-11.7.3-pos nct-11.8-convert nct-11.2-Mopt
=== settings
max_errors = 99
spindle = 1 name S1 range 50 1000 range 800 4000 position CS1
spindle = 2 name S2 position CS2 axis C axis_code 20
axis = C 6 rotary
N0689 = 20
N0690 = 24
N0607.INX.1 = 0
=== main
S900 M3
S100 P3
S100 S2=5
S1=100 S2=100
S2=I100
S100 P2 X5
M13 S100
G0 C90
CS1=30
S2=0 M19
CS2=30 CS2=40
S2=100 M3
CS2=30
M21 M5
S2=0 M20
G0 C10
M30
=== says
main.nc:1:1: error[nct-spindle-range]
main.nc:2:6: error[nct-2002]
main.nc:3:6: error[nct-2017]
main.nc:4:8: error[nct-2017]
main.nc:5:1: error[nct-2017]
main.nc:6:6: error[nct-2017]
main.nc:7:1: error[nct-2002]
main.nc:8:4: error[nct-spindle-axis]
main.nc:9:1: error[nct-2138]
main.nc:11:8: error[nct-duplicate-word]
main.nc:13:1: error[nct-spindle-loop]
main.nc:14:5: error[nct-contradictory-m]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-spindle-range]: S900 lies in the ranges 1 and 2: M11 or M12 must choose
    S900 M3
    ^~~~~~~
main.nc:2:6: error[nct-2002]: P data out of range: there is no such spindle
    S100 P3
         ^~
main.nc:3:6: error[nct-2017]: illegal address S2: one spindle in a block
    S100 S2=5
         ^~~~
main.nc:4:8: error[nct-2017]: illegal address S2: one spindle in a block
    S1=100 S2=100
           ^~~~~~
main.nc:5:1: error[nct-2017]: illegal address S2: a speed has no operator I
    S2=I100
    ^~~~~~~
main.nc:6:6: error[nct-2017]: illegal address P: S with P stands without axis words
    S100 P2 X5
         ^~
main.nc:7:1: error[nct-2002]: M data out of range: the spindle has 2 ranges
    M13 S100
    ^~~~~~~~
main.nc:8:4: error[nct-spindle-axis]: axis C is spindle 2 now: program its change to an axis (M20) before
    G0 C90
       ^~~
main.nc:9:1: error[nct-2138]: spindle cannot be indexed
    CS1=30
    ^~~~~~
10: event spindle rpm=0 direction="oriented" spindle=2
main.nc:11:8: error[nct-duplicate-word]: two CS2 in one block
    CS2=30 CS2=40
           ^~~~~~
12: event spindle rpm=100 direction="cw" spindle=2
main.nc:13:1: error[nct-spindle-loop]: a spindle turns to an angle only behind its orientation: program M19 before
    CS2=30
    ^~~~~~
main.nc:14:5: error[nct-contradictory-m]: contradictory M codes: M21 and M5
    M21 M5
        ^~
15: event spindle rpm=0 direction="cw" spindle=2
15: event spindle rpm=0 direction="axis" spindle=2 axis="C"
16: rapid from 0 0 0 to 0 0 0 C 0 to 10 t0.04
17: event end code="M30"
end of program: 17 blocks, 1 motions, 12 errors, 0 warnings
