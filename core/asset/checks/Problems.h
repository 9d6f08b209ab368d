#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "core/base/TaskContext.h"
#include "core/fracture/partition/CappedDiagnostics.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// The limits from which on something is a problem.
struct ProblemLimits {
    double aspect = 6.0;      // of slivers; scattered fragments seldom exceed it
    double meanShare = 0.02;  // of tiny fragments: their volume relative to the mean of their siblings
    std::uint32_t hulls = 8;  // per fragment; each costs a collision as much as another body
    std::size_t most = kMaxDiagnosticsPerCode;  // that are kept of each code; the others are counted
    bool operator==(const ProblemLimits&) const = default;
};

/// The factor by which a value exceeds its limit, at least 1; infinite if the asset cannot be fractured.
double badness(const Diagnostic& problem);

/// Every fault that keeps an outline from being fractured.
std::vector<Diagnostic> outlineProblems(const Asset& asset);

/// The diagnostics of a bake that an artist should look at, by code, then by seed and fragment: its warnings, slivers,
/// tiny fragments and many hulls, and Bonding::neverBreaks and clusters of missing fragments. DiagnosticPlace::index is
/// set only for seeds of the asset's own pattern: the seed concerned, or the one that a fragment of any level comes
/// from. Of each code there are ProblemLimits::most, and one that says how many more there would be. O(corners · log
/// corners of a piece) on task.threads; adds the number of visited diagnostics and fragments to `visited`.
std::vector<Diagnostic> problemsOf(const Asset& asset, const Bake& bake, const ProblemLimits& limits = {},
                                   const TaskContext& task = {}, std::size_t* visited = nullptr);

/// The problems of an asset that do not depend on its fracture: a threshold that cannot be derived.
std::vector<Diagnostic> strengthProblems(const Asset& asset, const Material& material);

/// The problems of all assets, in the project's order: of their bakes, or of their outlines without one, and of their
/// strength.
std::vector<Diagnostic> problemsOf(const Project& project, const AssetBakes& bakes, const ProblemLimits& limits = {},
                                   const TaskContext& task = {});

/// One flag per fragment of a bake: true if a problem is about it.
std::vector<bool> fragmentsWithProblems(const Bake& bake, std::span<const Diagnostic> problems);

}  // namespace rubble
