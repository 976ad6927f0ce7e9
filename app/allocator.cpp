// How the program's allocator asks the system for memory.
#include <jemalloc/jemalloc.h>

/// Read by jemalloc when the program starts (its manual, "TUNING"). A part is some hundred megabytes that are
/// written once; without huge pages their faults are a tenth of the run (systems that have none are served as
/// before). Freed pages go back within half a second: that keeps the peak low, and what the next step takes again
/// does not go to the system and back (a quarter of the time of a worm). Their address space is kept, since single
/// pages mapped anew are never huge. Threads cache small blocks only: a few megabytes less.
const char* malloc_conf = "thp:always,metadata_thp:auto,dirty_decay_ms:500,lg_tcache_max:12";
