=== about
The manual's first example of 21.1: the signal comes at X86.7, the next incremental block counts from there.
proves: nct-21.1-G31 nct-3-G31
=== settings
probe = plane 1 0 0 86.7
=== main
N1 G31 G91 X100 F200
N2 X30 Y50
#100=#5061
#101=#5001
G90 G0 X[#100+#101] Y0
M30
=== truth
probe 86.7 0 0 F 200 t 26.01
rapid 116.7 50 0
203.4 0 0
=== expect
file 0 main.nc
1 N1: probe from 0 0 0 to 86.7 0 0 F200 t26.01
1 N1: event probe contact=true
2 N2: rapid to 116.7 50 0 t0.2
5: rapid to 203.4 0 0 t0.3468
6: event end code="M30"
end of program: 6 blocks, 3 motions, 0 errors, 0 warnings
