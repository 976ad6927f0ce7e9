# What turns an overrun into an end of the process, for every proveout target, tests included: one set of flags, since
# precompiled headers are shared. A test reads the built program for it (Program.IsHardened).
#   compiled  canaries on stacks (-fstack-protector-strong), checked calls of the C library (_FORTIFY_SOURCE, which needs
#             optimisation), checked indices of the C++ library (_GLIBCXX_ASSERTIONS), position independence
#   linked    all relocations resolved at the start and read-only from then on, no executable stack
# Sources of SIMD kernels and of search trees do without canaries (proveout_unhardened_kernel), these trees and targets
# with PROVEOUT_UNCHECKED_INDICES without checked indices: what they index is made by the program, and the check costs.
# Sanitizers check more, and replace the checked calls.
# Not exported: users of the libraries choose for themselves.
option(PROVEOUT_HARDENED "Compile and link with hardening" ON)
set(proveout_unhardened_kernel "")
if(PROVEOUT_HARDENED)
  include(CheckPIESupported)
  check_pie_supported(LANGUAGES CXX)
endif()
if(PROVEOUT_HARDENED AND NOT PROVEOUT_SANITIZE)
  set(proveout_unhardened_kernel -fno-stack-protector)
  target_compile_definitions(proveout_options INTERFACE
    $<BUILD_INTERFACE:$<$<NOT:$<BOOL:$<TARGET_PROPERTY:PROVEOUT_UNCHECKED_INDICES>>>:_GLIBCXX_ASSERTIONS>>)
  target_compile_options(proveout_options INTERFACE $<BUILD_INTERFACE:-fstack-protector-strong>
    "$<BUILD_INTERFACE:$<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=2>>")
  target_link_options(proveout_options INTERFACE
    $<BUILD_INTERFACE:-Wl,-z,relro> $<BUILD_INTERFACE:-Wl,-z,now> $<BUILD_INTERFACE:-Wl,-z,noexecstack>)
endif()
