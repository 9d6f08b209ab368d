#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "core/play/scene/PlayAsset.h"

namespace rubble {

/// A project with everything needed to play it: immutable, shared by any number of sessions.
struct PlayScene {
    Project project;
    std::map<AssetVariant, std::shared_ptr<const PlayAsset>> assets;
    std::vector<Diagnostic> diagnostics;  // of all assets, each message with the asset's name
};

/// Prepares a project with its bakes. Assets without a bake must not be used by instances and shots.
///
/// Errors: BadInput if verifyProject() finds a fault, or an instance or shot uses an asset without a bake of its
/// variant; those of playAsset(); Cancelled.
Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const AssetBakes& bakes,
                                                   const TaskContext& task = {});
/// Bakes everything first.
///
/// Errors: as above; those of bake().
Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const TaskContext& task = {});

}  // namespace rubble
