#include "core/io/animation/AnimationFile.h"

#include "core/base/MessageText.h"
#include "core/io/animation/GlbAnimation.h"
#include "core/io/animation/UsdAnimation.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/text/LetterCase.h"

#include <algorithm>

namespace rubble {
namespace {

std::string suffixOf(const std::filesystem::path& path) { return lowerCase(path.extension().string()); }

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

Status checkAnimationPath(const std::filesystem::path& path) {
    const std::string suffix = suffixOf(path);
    if (suffix == ".glb" || suffix == ".usda") return success();
    return Error{ErrorCode::BadInput,
                 "The name of an animation ends in .glb or .usda, unlike " + quotedPath(path) + "."};
}

Status saveAnimation(const std::filesystem::path& path, const Project& project, const SessionTracks& tracks,
                     const TaskContext& task) {
    if (const Status valid = checkAnimationPath(path); !valid) return valid;
    const Result<AnimatedScene> scene = animatedScene(path.stem().string(), project, tracks, task);
    if (!scene) return scene.error();
    if (suffixOf(path) == ".usda") return saveUsd(path, *scene);
    const Result<std::string> file = glbAnimation(*scene);
    if (!file) return file.error();
    return writeFileAtomically(path, *file);
}

}  // namespace rubble
