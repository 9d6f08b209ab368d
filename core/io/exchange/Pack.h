#pragma once

#include "core/asset/project/Project.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/exchange/PackBody.h"
#include "core/io/exchange/PackBonding.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The bodies in a mesh file of a pack.
enum class PackMeshBodies {
    Whole,      // the whole alone
    Fragments,  // some or all fragments, none nested in another, each an object with its name
    Fragment,   // one fragment
};

/// A mesh file of a pack.
struct PackMeshFile {
    std::string name;  // "wall-fragments.obj", a file beside pack.json
    PackMeshBodies bodies = PackMeshBodies::Fragments;
    std::uint32_t fragment = kNone;  // index of the one fragment
    PartPlacement place = PartPlacement::Assembled;
    /// Of Fragments: the level of the fragments in it, which break; none: those that do not break, of all levels.
    std::optional<std::uint32_t> level;
    bool operator==(const PackMeshFile&) const = default;
};

/// What an asset is called in files.
struct PackNames {
    std::string name;           // of the asset, as it was given: "wall~2"
    std::string base;           // of the asset without its variant: "wall"
    std::uint32_t variant = 0;  // 0: the asset itself
    std::string folder;         // of its pack, with which files and bodies start: "wall_2"
    bool operator==(const PackNames&) const = default;
};

/// When and how the bodies of a pack break.
struct PackBreak {
    BreakAs as = BreakAs::Whole;
    DamageRule rule = DamageRule::Impact;
    std::optional<CutAtImpact> cutAtImpact;
    double leastSpeed = 0.0;        // m/s: a contact that approaches slower does not count
    double restitutionSpeed = 0.0;  // m/s: restitution counts above it
    bool operator==(const PackBreak&) const = default;
};

/// A material of a surface in the meshes.
struct PackSurface {
    std::string name;  // in the meshes
    bool isInside = false;
    Colour colour;
    double opacity = 1.0;
    double roughness = 0.9;
    std::string texture;  // a file beside pack.json, also within GLB files; empty: none
    bool operator==(const PackSurface&) const = default;
};

/// What engines need of an asset: the intermediate value from which all formats are written.
struct Pack {
    std::uint32_t version = 2;  // of the file
    std::string generator;      // the program that wrote it, and its version
    Id asset = 0;
    PackNames names;
    double gap = 0.0;         // m between fragments, the widest of all bodies
    std::string hash;         // of everything, in hexadecimal
    std::string physicsHash;  // of all but meshes, surfaces and names; empty in version 1
    std::string checksum;     // of the text, see verifyPackText(); empty: written by an earlier version
    double threshold = 0.0;   // N·s, of the whole
    PackBreak breaking;
    double inset = 0.0;               // m: of the collision hulls; 0 in version 1
    std::vector<Material> materials;  // at least one; their ids are not in the file
    std::uint32_t material = 0;       // index: of all bodies
    std::uint32_t insideMaterial = 0;
    std::vector<PackSurface> surfaces;  // none in version 1
    std::optional<Debris> debris;       // none in version 1
    std::vector<PackMeshFile> meshes;
    PackBody whole;
    std::vector<PackBody> fragments;
    std::optional<PackBonding> bonding;  // none: it breaks whole

    const Material& own() const { return materials[material]; }
};

}  // namespace rubble
