#pragma once

#include "core/asset/bake/AssetBakes.h"
#include "core/play/scene/PlayBody.h"
#include "core/play/scene/PlayMortar.h"
#include "core/play/scene/PlayStructure.h"

namespace rubble {

/// A project with everything needed to play it: immutable, shared by any number of sessions.
struct PlayScene {
    Project project;
    std::map<AssetVariant, std::shared_ptr<const PlayAsset>> assets;
    std::map<Id, std::shared_ptr<const PlayStructure>> structures;  // of the wholes of bonded instances that break
    /// Of all solids that are fractured, of bonded assets: by the fragment that is; kNone: the whole. Without anchors.
    std::map<AssetVariant, std::map<std::uint32_t, std::shared_ptr<const PlayStructure>>> assetStructures;
    bool hasUnjoined = false;             // bonds do not join all nodes of some of these structures
    std::vector<JoinedMortar> mortars;    // one for each of the project's
    std::vector<Diagnostic> diagnostics;  // of all assets, each message with the asset's name
};

/// Prepares the structures of bonded assets and instances, anew where an asset of the scene was replaced.
///
/// Errors: those of addMortar().
Status addStructures(PlayScene& scene);

/// The structure of the whole (kNone) or a fragment of an origin; null if it has no bonds.
std::shared_ptr<const PlayStructure> structureIn(const PlayScene& scene, const PlayOrigin& origin,
                                                 std::uint32_t fragment);

/// Prepares a project with its bakes. Assets without a bake must not be used by instances and shots. `when`: see
/// playAsset().
///
/// Errors: BadInput if verifyProject() finds a fault, or an instance or shot uses an asset without a bake of its
/// variant; Limit if it is too large to be played; those of playAsset() and addStructures(); Cancelled.
Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const AssetBakes& bakes,
                                                   const TaskContext& task = {},
                                                   FindContacts when = FindContacts::InAdvance);
/// Bakes everything first.
///
/// Errors: as above; those of bake().
Result<std::shared_ptr<const PlayScene>> playScene(const Project& project, const TaskContext& task = {});

}  // namespace rubble
