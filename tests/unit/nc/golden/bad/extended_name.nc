G0 Z1=87.257
M30
=== says
main.nc:1:4: error[nct-2064]
=== expect
file 0 main.nc
main.nc:1:4: error[nct-2064]: syntax error: '=': no axis or spindle of that name is configured
    G0 Z1=87.257
       ^~~
alarm: 1 blocks, 0 motions, 1 errors, 0 warnings
