#pragma once

#include "core/asset/Problems.h"
#include "core/base/TaskContext.h"
#include "editor/document/Edit.h"

#include <span>
#include <vector>

namespace rubble {

/// What can be done about problems by one step. To add one: its name here, where it applies and what it does in the .cpp.
enum class ProblemFix {
    DeleteSeed,    // those around take the place of its cell
    ForgetChange,  // the change by hand that names a seed which is not there
    DeletePoint,   // of an outline, that repeats the one before it
    Relax,         // move scattered seeds to the middles of their cells
    MergePieces,   // tiny ones, each into the neighbour with the longest shared edge
    AskForFewer,   // seeds of a scatter: as many as find room
    CutApart,      // pieces of many hulls, until each part needs few
    KeepTyped,     // the threshold, where it cannot be derived
};
inline constexpr ProblemFix kProblemFixes[] = {
    ProblemFix::DeleteSeed,  ProblemFix::ForgetChange, ProblemFix::DeletePoint, ProblemFix::Relax,
    ProblemFix::MergePieces, ProblemFix::AskForFewer,  ProblemFix::CutApart,    ProblemFix::KeepTyped};

/// Whether a fix can be tried on a problem.
bool canFix(const Project& project, const Problem& problem, ProblemFix fix);

/// "Delete Seed", for a button, and one sentence on what it does.
QString textOf(ProblemFix fix);
QString hintOf(ProblemFix fix);

/// Whether a fix takes as long as baking does, since it bakes.
bool isLong(ProblemFix fix);

/// Tries a fix on all of the problems that it can be tried on, as one step; empty where there are none, and where it was cancelled.
Edit fixed(const Project& project, std::span<const Problem> problems, ProblemFix fix, const TaskContext& task = {});

}  // namespace rubble
