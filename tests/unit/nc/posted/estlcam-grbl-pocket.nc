(Project pocket)
(Created by Estlcam version 11 build 11.245)
(Machining time about 00:01:10 hours)
(Required tools:)
(End mill 3mm)
G90
M03 S24000
G0 Z5.
G0 X10. Y10.
G0 Z0.5
G1 Z-1. F300.
G1 X30. F1200.
G1 Y12.
G1 X10.
G1 Y14.
G1 X30.
G1 Y16.
G1 X10.
G1 Y18.
G1 X30.
G0 Z5.
M05
M30
