=== about
The manual's names of files: a leading separator counts from the caller's folder too, .. leads above it, blanks may stand behind <.
proves: nct-14.4.2-M98file
=== main
M98 <\подпрограммы\подпрограмма.prg>
M98 < ..\..\..\папка1\папка2\папка3\файл.txt> L2
M30
=== sub подпрограмма.prg
G0 X1
M99
=== sub файл.txt
G91 Y1
M99
=== truth
1 0 0
1 1 0
1 2 0
=== expect
file 0 main.nc
file 1 подпрограмма.prg
1/1 depth 1: rapid from 0 0 0 to 1 0 0 t0.004
file 2 файл.txt
2/1 depth 1: rapid to 1 1 0 t0.004
2/1 depth 1: rapid to 1 2 0 t0.004
3: event end code="M30"
end of program: 9 blocks, 3 motions, 0 errors, 0 warnings
