=== about
Numbers that the control does not have, names without turning columns, rows and axes that are not there, writing what can
only be read (2161) and bits above 1 (2092).
proves: nct-15.1-N1416-TOL nct-15.1-N1400 nct-23.1.18-#23001 nct-23.1.7-out nct-23.1.14-#4001 nct-23.1.14-#4501
=== settings
max_errors = 50
N1416.TOL = 0
N1400 = 20
=== main
#100=#34
#100=#5121
#100=#5341
#100=#100701
#100=#4040
#100=#4104
#100=#120004
#100=#10000
#100=#10021
#100=#23001
#100=#135001
#100=#_OFSZG[1]
#100=#5004
#100=#5204
#100=#3000
#100=#_NOSUCH
#100=#_WZG54[51]
#4001=1
#4400=1
#5001=1
#5500=1
#1000=1
#1032=1
#_MAINO=1
#3011=1
#8501=1
#1100=2
#1100=-1
#1132=4294967296
#_M_SBK=2
#3004=8
#8500=12
#10001=1E30
#23001=10
#3901=-1
M30
=== says
main.nc:1:6: error[nct-variable]
main.nc:2:6: error[nct-variable]
main.nc:3:6: error[nct-variable]
main.nc:4:6: error[nct-variable]
main.nc:5:6: error[nct-variable]
main.nc:6:6: error[nct-variable]
main.nc:7:6: error[nct-variable]
main.nc:8:6: error[nct-variable]
main.nc:9:6: error[nct-variable]
main.nc:10:6: error[nct-variable]
main.nc:11:6: error[nct-variable]
main.nc:12:6: error[nct-variable]
main.nc:13:6: error[nct-variable]
main.nc:14:6: error[nct-variable]
main.nc:15:6: error[nct-variable]
main.nc:16:6: error[nct-variable]
main.nc:17:6: error[nct-variable]
main.nc:18:1: error[nct-2161]
main.nc:19:1: error[nct-2161]
main.nc:20:1: error[nct-2161]
main.nc:21:1: error[nct-2161]
main.nc:22:1: error[nct-2161]
main.nc:23:1: error[nct-2161]
main.nc:24:1: error[nct-2161]
main.nc:25:1: error[nct-2161]
main.nc:26:1: error[nct-2161]
main.nc:27:1: error[nct-2092]
main.nc:28:1: error[nct-2092]
main.nc:29:1: error[nct-2092]
main.nc:30:1: error[nct-2092]
main.nc:31:1: error[nct-2092]
main.nc:32:1: error[nct-2092]
main.nc:33:9: error[nct-2064]
main.nc:34:1: error[nct-variable]
main.nc:35:1: error[nct-2092]
=== expect
file 0 main.nc
main.nc:1:6: error[nct-variable]: the control has no variable #34
    #100=#34
         ^~~
    note: #100 is vacant
main.nc:2:6: error[nct-variable]: the control has no variable #5121
    #100=#5121
         ^~~~~
    note: #100 is vacant
main.nc:3:6: error[nct-variable]: the control has no variable #5341
    #100=#5341
         ^~~~~
    note: #100 is vacant
main.nc:4:6: error[nct-variable]: the control has no variable #100701
    #100=#100701
         ^~~~~~~
    note: #100 is vacant
main.nc:5:6: error[nct-variable]: the control has no variable #4040
    #100=#4040
         ^~~~~
    note: #100 is vacant
main.nc:6:6: error[nct-variable]: the control has no variable #4104
    #100=#4104
         ^~~~~
    note: #100 is vacant
main.nc:7:6: error[nct-variable]: the control has no variable #120004
    #100=#120004
         ^~~~~~~
    note: #100 is vacant
main.nc:8:6: error[nct-variable]: the control has no variable #10000
    #100=#10000
         ^~~~~~
    note: #100 is vacant
main.nc:9:6: error[nct-variable]: the control has no variable #10021
    #100=#10021
         ^~~~~~
    note: #100 is vacant
main.nc:10:6: error[nct-variable]: the control has no variable #23001
    #100=#23001
         ^~~~~~
    note: #100 is vacant
main.nc:11:6: error[nct-variable]: the control has no variable #135001
    #100=#135001
         ^~~~~~~
    note: #100 is vacant
main.nc:12:6: error[nct-variable]: the control has no variable #_OFSZG[1]
    #100=#_OFSZG[1]
         ^~~~~~~~~~
    note: #100 is vacant
main.nc:13:6: error[nct-variable]: the control has no variable #5004
    #100=#5004
         ^~~~~
    note: #100 is vacant
main.nc:14:6: error[nct-variable]: the control has no variable #5204
    #100=#5204
         ^~~~~
    note: #100 is vacant
main.nc:15:6: error[nct-variable]: the control has no variable #3000
    #100=#3000
         ^~~~~
    note: #100 is vacant
main.nc:16:6: error[nct-variable]: the control has no variable #_NOSUCH
    #100=#_NOSUCH
         ^~~~~~~~
    note: #100 is vacant
main.nc:17:6: error[nct-variable]: #_WZG54 has no index 51
    #100=#_WZG54[51]
         ^~~~~~~~~~~
    note: #100 is vacant
main.nc:18:1: error[nct-2161]: variable #4001 is read-only
    #4001=1
    ^~~~~~~
main.nc:19:1: error[nct-2161]: variable #4400 is read-only
    #4400=1
    ^~~~~~~
main.nc:20:1: error[nct-2161]: variable #5001 is read-only
    #5001=1
    ^~~~~~~
main.nc:21:1: error[nct-2161]: variable #5500 is read-only
    #5500=1
    ^~~~~~~
main.nc:22:1: error[nct-2161]: variable #1000 is read-only
    #1000=1
    ^~~~~~~
main.nc:23:1: error[nct-2161]: variable #1032 is read-only
    #1032=1
    ^~~~~~~
main.nc:24:1: error[nct-2161]: variable #4000 is read-only
    #_MAINO=1
    ^~~~~~~~~
main.nc:25:1: error[nct-2161]: variable #3011 is read-only
    #3011=1
    ^~~~~~~
main.nc:26:1: error[nct-2161]: variable #8501 is read-only
    #8501=1
    ^~~~~~~
main.nc:27:1: error[nct-2092]: value limit exceeded: #1100
    #1100=2
    ^~~~~~~
main.nc:28:1: error[nct-2092]: value limit exceeded: #1100
    #1100=-1
    ^~~~~~~~
main.nc:29:1: error[nct-2092]: value limit exceeded: #1132
    #1132=4294967296
    ^~~~~~~~~~~~~~~~
main.nc:30:1: error[nct-2092]: value limit exceeded: #_M_SBK
    #_M_SBK=2
    ^~~~~~~~~
main.nc:31:1: error[nct-2092]: value limit exceeded: #3004
    #3004=8
    ^~~~~~~
main.nc:32:1: error[nct-2092]: value limit exceeded: #8500
    #8500=12
    ^~~~~~~~
main.nc:33:9: error[nct-2064]: syntax error: nothing may follow the statement
    #10001=1E30
            ^~~
main.nc:34:1: error[nct-variable]: the control has no variable #23001
    #23001=10
    ^~~~~~~~~
main.nc:35:1: error[nct-2092]: value limit exceeded: #3901
    #3901=-1
    ^~~~~~~~
36: event end code="M30"
end of program: 36 blocks, 0 motions, 35 errors, 0 warnings
