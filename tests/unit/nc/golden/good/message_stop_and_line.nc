=== about
Messages of programs: the stop goes on by itself, the line stands until the next one; text without a number, number without
a text.
proves: nct-23.1.8-3006 nct-23.1.8-3106
=== main
#3106=1(roughing with cutter D30)
G0 X1
#_MSG=2(finishing with cutter "D20")
#3006=12(turn the part over)
#_MSGSTP=(no number)
#3006=7
IF[1EQ1] THEN #3106=3(behind a condition)
M30
=== says
code="MSG001" text="roughing with cutter D30"
code="MSG002"
code="01501200"
=== expect
file 0 main.nc
1: event message kind="message" number=1 code="MSG001" text="roughing with cutter D30"
2: rapid from 0 0 0 to 1 0 0 t0.004
3: event message kind="message" number=2 code="MSG002" text="finishing with cutter \"D20\""
4: event message kind="stop" number=12 code="01501200" text="turn the part over"
5: event message kind="stop" number=0 code="01500000" text="no number"
6: event message kind="stop" number=7 code="01500700" text=""
7: event message kind="message" number=3 code="MSG003" text="behind a condition"
8: event end code="M30"
end of program: 8 blocks, 1 motions, 0 errors, 0 warnings
