#pragma once

#include "editor/commands/ProjectEdits.h"

#include <array>

namespace rubble {

// Edits of instances. The ids passed must exist.

/// A grid array along the world axes.
struct GridArray {
    std::array<int, 3> counts{2, 1, 1};  // along x, y and z, including the original; >= 1
    Vec3 steps{1.0, 1.0, 1.0};           // m, between two copies
};
/// An array around a vertical axis; the copies are rotated with it.
struct RingArray {
    int count = 6;          // including the original; >= 1
    Vec2 centre{0.0, 0.0};  // x and z of the axis, m
    double angle = 1.0;     // rad, between two copies
};

/// Adds an array of copies of each instance. Overlaps are not avoided.
Edit arrayInGrid(const Project& project, std::span<const Id> instances, const GridArray& array);
Edit arrayInRing(const Project& project, std::span<const Id> instances, const RingArray& array);

/// Adds an instance of an asset at a pose.
Addition placeInstance(const Project& project, Id asset, const Pose& pose);

/// Moves each instance straight down, the lowest first, until it rests on the scene below it; an instance that
/// penetrates the ground is lifted. See dropDistance().
Edit dropToGround(const Project& project, std::span<const Id> instances);

/// Gives each instance the lowest variant of its asset that no other instance uses, so that no two of them fracture
/// alike.
Edit assignDistinctVariants(const Project& project, std::span<const Id> instances);

Edit hideInstances(const Project& project, std::span<const Id> instances);
/// Hides all other instances.
Edit isolateInstances(const Project& project, std::span<const Id> instances);
Edit showAllInstances(const Project& project);
Edit lockInstances(const Project& project, std::span<const Id> instances);
Edit unlockAllInstances(const Project& project);

/// Those of the instances whose asset breaks as bonded.
std::vector<Id> bondedInstances(const Project& project, std::span<const Id> instances);
/// True if there are bonded ones among the instances, and all of these are anchored.
bool areAnchored(const Project& project, std::span<const Id> instances);
/// Anchors the bonded ones of the instances where they touch; releases them if all are anchored.
Edit toggleAnchored(const Project& project, std::span<const Id> instances);

/// Sets the pose of each instance. `mergeKey`: see Edit::mergeKey.
Edit moveInstances(const QString& text, const Project& project, std::span<const Id> instances,
                   std::span<const Pose> poses, quint64 mergeKey);

}  // namespace rubble
