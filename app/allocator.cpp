// How the program's allocator asks the system for memory.
#include <jemalloc/jemalloc.h>

/// Read by jemalloc when the program starts (its manual, "TUNING"). Freed pages go back within half a second:
/// that keeps the peak low, and what the next step takes again does not go to the system and back (a quarter
/// of the time of a worm). Their address space is kept. Few arenas find each other's freed pages: as many as
/// a machine's cores times four, the default, keep their own each. Huge pages are left to the system: always
/// asked for, a run had a fifth more memory and one to four per cent more processor time, as whole ones are
/// cleared of which parts are used. Threads cache small blocks only: a few megabytes less.
const char* malloc_conf = "narenas:4,dirty_decay_ms:500,lg_tcache_max:12";
