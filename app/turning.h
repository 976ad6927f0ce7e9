// The branch of the pipeline for controls that turn the part: the stock is a half section until a thread or a
// saved grid needs more.
#pragma once

#include <vector>

#include "app/pipeline.h"
#include "removal/turning/section.h"

namespace proveout {

/// Whether the job's control turns the part about Z.
bool turnsPart(const Job& job);

/// Refuses what turning cannot start from: a blank that is not round about Z, several clampings, fixtures.
Status checkTurning(const Job& job, const Blank& blank);

/// Where a turning tool starts if the job does not say: outside of the blank and in front of it.
Vec3 turningStart(const Box3& blank);

/// Cuts the clamping and fills everything of it but topology and findings. `run.stock` is made where threads
/// were cut or a grid is to be saved. `nominal`: null, or what tells which of several bodies is the part.
Status machineTurned(const Job& job, const Blank& blank, const TriMesh* nominal, SetupRun& setup,
                     RunResult& run, Progress& progress);

/// Bodies that were cut off, or stayed on the bar, beside the part.
void addPartedBodies(const SetupRun& setup, const RecordingSource& texts, std::vector<Finding>& findings);

/// Work of a turned job: the grid counts only where threads are cut.
Workload turningWork(const SetupRun& setup, const Blank& blank);

/// How far a turned surface may be off, mm: of the part's mesh.
double turnedUncertainty(const SetupRun& setup, double resolution_mm);

}  // namespace proveout
