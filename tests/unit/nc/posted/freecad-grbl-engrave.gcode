(Exported by FreeCAD)
(Post Processor: grbl_post)
(Output Time:2024-03-12 10:15:00.000000)
(Begin preamble)
G17 G90
G21
(Begin operation: Engrave)
M3 S10000
G0 Z3.
G0 X0. Y0.
G1 Z-0.3 F200.
G1 X4. Y10. F500.
G1 X8. Y0.
G1 X6. Y5.
G1 X2.
G0 Z3.
(Finish operation: Engrave)
(Begin postamble)
M5
G17 G90
M2
