(stockMin:0.00mm, 0.00mm, -10.00mm)
(stockMax:50.00mm, 50.00mm, 0.00mm)
(Shapeoko, carbide motion)
G90
G21
M05
M03S18000
G0 Z5.
X30. Y25.
Z0.5
G1 Z-0.8 F254.
G3 X20. I-5. F1016.
X30. I5.
G0 Z5.
X35.
Z0.5
G1 Z-0.8 F254.
G3 X15. I-10. F1016.
X35. I10.
G0 Z5.
M05
M02
