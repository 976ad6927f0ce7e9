=== about
The first DPRNT behind POPEN names the file; an older one of that name goes.
proves: nct-23.2.13-POPEN nct-23.2.13-PCLOS nct-23.2.13-DPRNT
=== settings
main_name = O0001.txt
N1757.PNT = 1
=== main
#100=4567
#130=35.897421
#500=-150.8
#10=14.8
POPEN31
DPRNT[ABC]
DPRNT[X]
PCLOS31
POPEN31
DPRNT[ABC]
DPRNT[X#130[53]Y#500[53]T#10[20]]
PCLOS31
POPEN31
DPRNT[O#100[4]]
PCLOS31
M30
=== says
file ABC.txt: %\0D\0AX35.897Y-150.800T15\0D\0A%\0D\0A
file O4567.txt: %\0D\0A%\0D\0A
=== expect
file 0 O0001.txt
8: event output file="ABC.txt" bytes=9
12: event output file="ABC.txt" bytes=27
15: event output file="O4567.txt" bytes=6
16: event end code="M30"
file ABC.txt: %\0D\0AX35.897Y-150.800T15\0D\0A%\0D\0A
file O4567.txt: %\0D\0A%\0D\0A
end of program: 16 blocks, 0 motions, 0 errors, 0 warnings
