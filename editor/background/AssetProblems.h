#pragma once

#include "core/asset/checks/Problems.h"
#include "editor/document/Bakes.h"

namespace rubble {

/// The problems of an asset.
struct AssetProblems {
    std::shared_ptr<const BakedAsset> baked;  // in which they were found
    std::vector<Diagnostic> ofBake;           // or of the outline if it could not be baked
    std::vector<Diagnostic> all;              // ofBake, of its strength and of its instances in the scene
};

/// The problems of the assets of a project that have been baked, by asset. `sceneBakes` are those of all assets in the
/// scene; without any, the scene has no problems. Those of bakes that `earlier` has are not looked for again.
///
/// Errors: Cancelled.
Result<std::map<Id, AssetProblems>> problemsByAsset(const Project& project,
                                                    const std::map<Id, std::shared_ptr<const BakedAsset>>& baked,
                                                    const AssetBakes& sceneBakes,
                                                    const std::map<Id, AssetProblems>& earlier,
                                                    const TaskContext& task);

}  // namespace rubble
