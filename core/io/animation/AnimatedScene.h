#pragma once

#include "core/base/TaskContext.h"
#include "core/io/exchange/GlbElements.h"
#include "core/play/session/SessionTracks.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// How far what is written may be from what was simulated, m.
inline constexpr double kAnimationTolerance = 1e-4;

struct AnimatedMaterial {
    MeshMaterial material;
    std::uint32_t image = 0;  // if it is textured
    bool operator==(const AnimatedMaterial&) const = default;
};

struct AnimatedMesh {
    Mesh mesh;
    std::vector<std::uint32_t> materials;  // by MeshFace::material; the last is that of the inside
};

/// A solid that moves.
struct AnimatedNode {
    std::string name;  // unique, an identifierOf()
    std::uint32_t mesh = 0;
    std::vector<PoseKey> poses;
    std::vector<SizeKey> sizes;
};

/// A recorded session as meshes that move, whatever the format. Equal meshes, materials and images are there once.
struct AnimatedScene {
    std::string name;          // an identifierOf()
    double frameLength = 0.0;  // s
    std::uint32_t lastFrame = 0;
    std::vector<GlbImage> images;
    std::vector<AnimatedMaterial> materials;
    std::vector<AnimatedMesh> meshes;
    std::vector<AnimatedNode> nodes;  // in order of their appearance
};

/// The tracks of a session of `project`, without poses that lie within kAnimationTolerance of the motion between
/// others.
///
/// Errors: Cancelled.
Result<AnimatedScene> animatedScene(const std::string& name, const Project& project, const SessionTracks& tracks,
                                    const TaskContext& task = {});

}  // namespace rubble
