// What a job may name, and what counts where it says nothing.
#pragma once

#include "io/job/job.h"

namespace proveout {

/// Controls and their parameters, which job files are checked against. Names of pictures are not checked.
JobNames jobNames();

/// Grid spacing where nobody gives one: the longest side / 400, rounded up to 1, 2 or 5 times a power of ten,
/// mm.
double defaultResolution(const Box3& blank);

/// Where the tool starts if the job does not say: above X0 Y0 where that lies over the blank, else above its
/// centre; clear of its top.
Vec3 defaultStart(const Box3& blank);

}  // namespace proveout
