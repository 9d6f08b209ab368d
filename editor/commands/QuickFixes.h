#pragma once

#include "core/asset/checks/Problems.h"
#include "core/base/TaskContext.h"
#include "editor/document/Edit.h"

#include <span>
#include <vector>

namespace rubble {

/// Edits that resolve problems in one undo step. To add one: its name here, its condition and effect in the .cpp.
enum class QuickFix {
    DeleteSeed,            // the neighbouring cells fill its place
    RemoveOverride,        // of a seed that does not exist
    DeletePoint,           // of an outline, that repeats the previous one
    Relax,                 // move scattered seeds to the centroids of their cells
    MergeTinyFragments,    // each into the neighbour with the longest shared edge
    ReduceCount,           // of a scatter, to the seeds that fit
    SplitFragment,         // with many hulls, until each part needs few
    KeepEnteredThreshold,  // when it cannot be derived
};
inline constexpr QuickFix kQuickFixes[] = {
    QuickFix::DeleteSeed,         QuickFix::RemoveOverride, QuickFix::DeletePoint,   QuickFix::Relax,
    QuickFix::MergeTinyFragments, QuickFix::ReduceCount,    QuickFix::SplitFragment, QuickFix::KeepEnteredThreshold};

/// Whether a fix applies to a problem.
bool canFix(const Project& project, const Diagnostic& problem, QuickFix fix);

/// A button's text, "Delete Seed", and its tooltip.
QString textOf(QuickFix fix);
QString descriptionOf(QuickFix fix);

/// Whether a fix has to bake the asset, and so takes as long.
bool isSlow(QuickFix fix);

/// Applies a fix to all problems that it applies to. The edit is empty if there are none or the task was cancelled.
Edit applyFix(const Project& project, std::span<const Diagnostic> problems, QuickFix fix, const TaskContext& task = {});

}  // namespace rubble
