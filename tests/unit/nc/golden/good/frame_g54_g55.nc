=== about
Workpiece frame: machine minus (300,800). N2 is where the tool already is: no motion.
proves: nct-10.2.1-G54 nct-10.2.1-G55 nct-10.2.1-G56 nct-3-G56
=== settings
G54 = 300 800 0
G55 = 1300 400 0
G56 = 1300 0 0
=== main
N1 G54 G0 X700 Y500
N2 G55 G0 X-300 Y900
N3 G55 X0 Y0
N4 G56 G90 G00 X60 Y40
M30
=== truth
700 500 0
1000 -400 0
1060 -760 0
=== expect
file 0 main.nc
1 N1: rapid from 0 0 0 to 700 500 0 t2.8
3 N3: rapid to 1000 -400 0 t3.6
4 N4: rapid to 1060 -760 0 t1.44
5: event end code="M30"
end of program: 5 blocks, 3 motions, 0 errors, 0 warnings
