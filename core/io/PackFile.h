#pragma once

#include "core/asset/Bake.h"
#include "core/base/TaskContext.h"
#include "core/io/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// The version of the packs that are written and read.
inline constexpr std::uint32_t kPackVersion = 1;

/// The name of the description that every pack holds, beside its meshes.
inline constexpr const char* kPackName = "pack.json";

/// Which bodies of a pack a mesh file holds.
enum class PackMeshBodies {
    Whole,      // the whole alone
    Fragments,  // all fragments, each as an object of its name
    Fragment,   // one fragment
};

/// A mesh file of a pack.
struct PackMeshFile {
    std::string name;  // "wall.obj", a file beside pack.json
    PackMeshBodies bodies = PackMeshBodies::Fragments;
    std::uint32_t fragment = kNone;  // index of the one that it holds
    PartPlace place = PartPlace::Assembled;
    bool operator==(const PackMeshFile&) const = default;
};

/// What a body is called in packs and in the meshes beside them, as one word: "wall" for the whole, "wall12" for the
/// fragment with index 12.
std::string bodyName(const Asset& asset, std::uint32_t fragment = kNone);

/// A hash of all that packJson() depends on: known without a bake, equal for equal packs.
ContentHash packHash(const Asset& asset, const Material& material, std::span<const PackMeshFile> meshes);

/// A bake as the description of a pack: one line of JSON a body, with every number the shortest that reads back as the
/// same double. The same bytes at any number of threads. docs/formats/pack.md tells every field.
std::string packJson(const Bake& bake, const Asset& asset, const Material& material,
                     std::span<const PackMeshFile> meshes, const TaskContext& task = {});

}  // namespace rubble
