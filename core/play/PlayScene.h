#pragma once

#include "core/asset/AssetBakes.h"
#include "core/play/PlayAsset.h"

namespace rubble {

/// A project with all that playing it needs: made once, shared by any number of sessions, never changed.
struct PlayScene {
    Project project;
    std::map<AssetVariant, std::shared_ptr<const PlayAsset>> assets;
    std::vector<std::string> notices;  // of all assets, each with the asset's name
};

/// A project with its bakes, made ready. Assets without a bake take no part: whoever names one is refused.
///
/// Errors: BadInput where verifyProject() finds a fault, or an instance or shot names an asset that has no bake in
/// its variant; those of
/// playAsset(); Cancelled.
Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const AssetBakes& bakes,
                                                   const TaskContext& task = {});
/// The same with everything baked here.
///
/// Errors: as above; those of bake().
Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const TaskContext& task = {});

}  // namespace rubble
