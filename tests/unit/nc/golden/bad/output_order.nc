=== about
Statements of output in the wrong order or place.
proves: nct-23.2.13-POPEN nct-23.2.13-PCLOS nct-23.2.13-FCLOS nct-23.2.13-FOPEN
=== settings
max_errors = 50
=== main
DPRNT[A]
FCLOS
PCLOS31
POPEN30
FOPEN6 P1
FOPEN3 P1
FOPEN5 P1
FOPEN3 <a.txt>
FOPEN5 <a.txt>
FOPEN2 P1
FOPEN2 P2
PCLOS31
FCLOS
FOPEN1 P1
FOPEN1 <O0001.nc>
POPEN31
BPRNT[A]
DPRNT[*]
PCLOS31
POPEN31 X
FOPEN1
FOPEN1 <../a>
FOPEN1 <c:/a>
FOPEN1 <a//b>
FOPEN1 </>
DPRNT[A
DPRNT[a?]
DPRNT[#100]
DPRNT[#100[]]
DPRNT[#100[99]]
DPRNT[#100[1234]]
BPRNT[#100[9]]
BPRNT[#[10000000000][0]]
DPRNT A
DPRNT[A] X
M30
=== says
main.nc:1:1: error[nct-output]
main.nc:2:1: error[nct-output]
main.nc:3:1: error[nct-output]
main.nc:4:1: error[nct-2002]
main.nc:5:1: error[nct-2002]
main.nc:6:1: error[nct-2147]
main.nc:7:1: error[nct-2147]
main.nc:8:1: error[nct-2132]
main.nc:9:1: error[nct-2132]
main.nc:11:1: error[nct-output]
main.nc:12:1: error[nct-output]
main.nc:14:1: error[nct-2144]
main.nc:15:1: error[nct-2146]
main.nc:17:1: error[nct-output]
main.nc:18:1: error[nct-2002]
main.nc:19:1: error[nct-output]
main.nc:20:9: error[nct-2064]
main.nc:21:7: error[nct-2064]
main.nc:22:8: error[nct-2002]
main.nc:23:8: error[nct-2002]
main.nc:24:8: error[nct-2002]
main.nc:25:8: error[nct-2002]
main.nc:26:8: error[nct-2121]
main.nc:27:8: error[nct-2064]
main.nc:28:1: error[nct-2064]
main.nc:29:1: error[nct-2064]
main.nc:30:1: error[nct-2002]
main.nc:31:1: error[nct-2064]
main.nc:32:1: error[nct-2002]
main.nc:33:1: error[nct-2002]
main.nc:34:7: error[nct-2064]
main.nc:35:10: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:1: error[nct-output]: no file is open: POPEN or FOPEN comes first
    DPRNT[A]
    ^~~~~~~~
main.nc:2:1: error[nct-output]: FCLOS without FOPEN
    FCLOS
    ^~~~~
main.nc:3:1: error[nct-output]: PCLOS without POPEN
    PCLOS31
    ^~~~~~~
main.nc:4:1: error[nct-2002]: POPEN data out of range: 31, the memory of the control, is the only place to write to
    POPEN30
    ^~~~~~~
main.nc:5:1: error[nct-2002]: FOPEN data out of range: 1 to 5 is expected
    FOPEN6 P1
    ^~~~~~~~~
main.nc:6:1: error[nct-2147]: file (O0001) not found: this run has not written it
    FOPEN3 P1
    ^~~~~~~~~
main.nc:7:1: error[nct-2147]: file (O0001) not found: this run has not written it
    FOPEN5 P1
    ^~~~~~~~~
main.nc:8:1: error[nct-2132]: file not found: this run has not written it
    FOPEN3 <a.txt>
    ^~~~~~~~~~~~~~
main.nc:9:1: error[nct-2132]: file not found: this run has not written it
    FOPEN5 <a.txt>
    ^~~~~~~~~~~~~~
main.nc:11:1: error[nct-output]: a file is open already: close it first
    FOPEN2 P2
    ^~~~~~~~~
main.nc:12:1: error[nct-output]: PCLOS without POPEN
    PCLOS31
    ^~~~~~~
13: event output file="O0001.nc" bytes=0
main.nc:14:1: error[nct-2144]: file (O0001) already exists
    FOPEN1 P1
    ^~~~~~~~~
main.nc:15:1: error[nct-2146]: the given file already exists
    FOPEN1 <O0001.nc>
    ^~~~~~~~~~~~~~~~~
main.nc:17:1: error[nct-output]: the first DPRNT behind POPEN names the file
    BPRNT[A]
    ^~~~~~~~
main.nc:18:1: error[nct-2002]: file name data out of range: ""
    DPRNT[*]
    ^~~~~~~~
main.nc:19:1: error[nct-output]: no DPRNT has named the file that POPEN opened
    PCLOS31
    ^~~~~~~
main.nc:20:9: error[nct-2064]: syntax error: nothing may follow the statement
    POPEN31 X
            ^
main.nc:21:7: error[nct-2064]: syntax error: FOPEN needs P or a file name in < >
    FOPEN1
          ^
main.nc:22:8: error[nct-2002]: file name data out of range: 1 to 60 characters, inside the folder of the results
    FOPEN1 <../a>
           ^~~~~~
main.nc:23:8: error[nct-2002]: file name data out of range: 1 to 60 characters, inside the folder of the results
    FOPEN1 <c:/a>
           ^~~~~~
main.nc:24:8: error[nct-2002]: file name data out of range: 1 to 60 characters, inside the folder of the results
    FOPEN1 <a//b>
           ^~~~~~
main.nc:25:8: error[nct-2002]: file name data out of range: 1 to 60 characters, inside the folder of the results
    FOPEN1 </>
           ^~~
main.nc:26:8: error[nct-2121]: right bracket not found
    DPRNT[A
           ^
main.nc:27:8: error[nct-2064]: syntax error: letters, digits, * / + - and variables can be written
    DPRNT[a?]
           ^
main.nc:28:1: error[nct-2064]: syntax error: a variable to be written is followed by its digits in brackets
    DPRNT[#100]
    ^~~~~~~~~~~
    note: #100 is vacant
main.nc:29:1: error[nct-2064]: syntax error: a variable to be written is followed by its digits in brackets
    DPRNT[#100[]]
    ^~~~~~~~~~~~~
    note: #100 is vacant
main.nc:30:1: error[nct-2002]: 99 data out of range: 1 to 15 digits can be written
    DPRNT[#100[99]]
    ^~~~~~~~~~~~~~~
    note: #100 is vacant
main.nc:31:1: error[nct-2064]: syntax error: a variable to be written is followed by its digits in brackets
    DPRNT[#100[1234]]
    ^~~~~~~~~~~~~~~~~
    note: #100 is vacant
main.nc:32:1: error[nct-2002]: BPRNT data out of range: 0 to 8 decimals
    BPRNT[#100[9]]
    ^~~~~~~~~~~~~~
    note: #100 is vacant
main.nc:33:1: error[nct-2002]: # data out of range: 10000000000 is no whole number in range
    BPRNT[#[10000000000][0]]
    ^~~~~~~~~~~~~~~~~~~~~~~~
main.nc:34:7: error[nct-2064]: syntax error: '[' is expected
    DPRNT A
          ^
main.nc:35:10: error[nct-2064]: syntax error: nothing may follow the statement
    DPRNT[A] X
             ^
36: event end code="M30"
file O0001.nc: 
end of program: 36 blocks, 0 motions, 32 errors, 0 warnings
