#include "core/io/animation/AnimationFile.h"

#include "core/io/animation/GlbAnimation.h"
#include "core/io/animation/UsdAnimation.h"
#include "core/io/system/AtomicFile.h"

#include <algorithm>

namespace rubble {
namespace {

std::string lowerSuffix(const std::filesystem::path& path) {
    std::string suffix = path.extension().string();
    for (char& letter : suffix) {
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    }
    return suffix;
}

Status saveUsd(const std::filesystem::path& path, const AnimatedScene& scene) {
    std::vector<std::string> imageFiles;
    for (const GlbImage& image : scene.images) {
        const std::string name = scene.name + "-" + image.name;
        const bool isTaken = std::ranges::find(imageFiles, name) != imageFiles.end();
        imageFiles.push_back(isTaken ? std::to_string(imageFiles.size() + 1) + "-" + name : name);
    }
    for (std::size_t k = 0; k < imageFiles.size(); ++k) {
        const Status written = writeFileAtomically(path.parent_path() / imageFiles[k], scene.images[k].image->bytes());
        if (!written) return written;
    }
    return writeFileAtomically(path, usdAnimation(scene, imageFiles));
}

}  // namespace

bool isAnimationPath(const std::filesystem::path& path) {
    const std::string suffix = lowerSuffix(path);
    return suffix == ".glb" || suffix == ".usda";
}

Status saveAnimation(const std::filesystem::path& path, const Project& project, const SessionTracks& tracks,
                     const TaskContext& task) {
    if (!isAnimationPath(path)) {
        return Error{ErrorCode::BadInput,
                     "The name of an animation ends in .glb or .usda, unlike " + path.string() + "."};
    }
    const Result<AnimatedScene> scene = animatedScene(path.stem().string(), project, tracks, task);
    if (!scene) return scene.error();
    if (lowerSuffix(path) == ".usda") return saveUsd(path, *scene);
    const Result<std::string> file = glbAnimation(*scene);
    if (!file) return file.error();
    return writeFileAtomically(path, *file);
}

}  // namespace rubble
