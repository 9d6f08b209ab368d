#pragma once

#include "tests/attack/FbxMutator.h"
#include "tests/attack/Mutator.h"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rubble::attack {

/// The endings of the meshes that can be imported.
inline constexpr std::array kMeshEndings = {".obj", ".gltf", ".glb", ".fbx", ".stl", ".ply"};

/// The folders of valid meshes: tests/data/meshes, tests/corpus/MeshCases and, where they are installed, the models of
/// assimp's own tests.
std::vector<std::filesystem::path> meshFolders();

/// Makes damaged copies of small meshes of one format: those of meshFolders(), and some that refer to files outside of
/// their folder.
class MeshMutator {
public:
    /// `ending`: one of kMeshEndings.
    explicit MeshMutator(const std::string& ending);

    /// A mesh with one to four changes; one in four is changed as bytes, the others by the structure of the format.
    std::string mutated(Random& random) const;

private:
    struct Sample {
        std::string bytes;
        std::shared_ptr<const JsonMutator> json;  // of glTF and GLB
        std::optional<FbxDocument> fbx;           // of binary FBX
    };

    void add(const std::string& bytes);
    std::string structured(const Sample& sample, Random& random) const;

    std::string m_ending;
    std::vector<Sample> m_samples;
};

}  // namespace rubble::attack
