=== about
The manual's examples of DPRNT and BPRNT: the 20 bytes, the line with spaces.
proves: nct-23.2.13-POPEN nct-23.2.13-PCLOS nct-23.2.13-BPRNT nct-23.2.13-DPRNT nct-23.2.13-FOPEN
nct-23.2.13-FCLOS
=== settings
main_name = O0001.txt
=== main
#110=318.49362
#120=0.723415
#112=23.9
FOPEN2 <out/bytes.bin>
BPRNT[C*/X#110[3]Y#120[3]M#112[0]]
#120=258.647673
BPRNT[#120[3]#0[3]]
#120=-1
BPRNT[#120[0]]
FCLOS
#130=35.897421
#500=-150.8
#10=14.8
#100=4567
POPEN31
DPRNT[O#100[4]]
DPRNT[X#130[53]Y#500[53]T#10[20]]
PCLOS31
M30
=== says
file O4567.txt: %\0D\0AX    35.897Y-  150.800T 15\0D\0A%\0D\0A
C /X\00\04\DC\1EY\00\00\02\D3M\00\00\00\18\0D\0A\00\03\F2X\00\00\00\00\0D\0A
=== expect
file 0 O0001.txt
10: event output file="out/bytes.bin" bytes=36
18: event output file="O4567.txt" bytes=34
19: event end code="M30"
file O4567.txt: %\0D\0AX    35.897Y-  150.800T 15\0D\0A%\0D\0A
file out/bytes.bin: C /X\00\04\DC\1EY\00\00\02\D3M\00\00\00\18\0D\0A\00\03\F2X\00\00\00\00\0D\0A\FF\FF\FF\FF\0D\0A
end of program: 19 blocks, 0 motions, 0 errors, 0 warnings
