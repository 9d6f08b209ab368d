#pragma once

#include "core/base/Random.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::attack {

/// What importers of meshes did, which run in processes of their own.
struct ImporterFigures {
    std::uint64_t crashed = 0;
    std::uint64_t timedOut = 0;
    std::uint64_t outOfMemory = 0;
    std::uint64_t opened = 0;   // files in the folder of a mesh and below
    std::uint64_t refused = 0;  // files outside

    ImporterFigures& operator+=(const ImporterFigures& other);
    std::uint64_t failed() const { return crashed + timedOut + outOfMemory; }
};

/// What became of one input.
struct Verdict {
    bool isAccepted = false;           // by the reader
    bool isPlayed = false;             // also baked and simulated
    std::optional<std::string> fault;  // the first promise that was broken
    ImporterFigures importer;
};

/// A kind of input, with what damages it and what holds for it.
struct Format {
    std::string name;    // of its folder in tests/corpus; a part of a family after a slash: "Mesh/obj"
    std::string ending;  // of its files: ".json"
    std::function<std::string(Random&)> mutated;
    /// Reads the bytes and, if they are accepted, does with them what the programs do.
    std::function<Verdict(std::string_view bytes, Random&)> check;
    int checks = 64;  // of each file of the corpus: what is checked of it may depend on the random numbers
};

/// The formats of a program: those of core/io, and meshes if there is an importer; or pictures. `folder`: for files
/// while they are read. Must be called before threads are started.
std::vector<Format> formatsOf(const std::filesystem::path& importer, const std::filesystem::path& folder);

/// The JSON formats, and the inputs of replays.
std::vector<Format> jsonFormats();
/// Replays with seals, and manifests of packs with hashes, that are made anew after a change.
std::vector<Format> sealedFormats(const std::filesystem::path& folder);
/// Damages of instances, whose checksum is made anew after a change, which are then applied.
Format damageFormat();
/// What rubble_pack.hpp reads beside packs: scenes with their packs, pack.bin and events, which are then used as
/// engines do.
std::vector<Format> engineFormats(const std::filesystem::path& folder);
/// PNG files, and what the importer's process returns.
std::vector<Format> binaryFormats();
/// Meshes of each format, which are read by `importer` in a child process.
std::vector<Format> meshFormats(const std::filesystem::path& importer, const std::filesystem::path& folder);

}  // namespace rubble::attack
