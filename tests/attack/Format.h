#pragma once

#include "core/base/Random.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubble::attack {

/// What became of one input.
struct Verdict {
    bool isAccepted = false;           // by the reader
    bool isPlayed = false;             // also baked and simulated
    std::optional<std::string> fault;  // the first promise that was broken
};

/// A kind of input, with what damages it and what holds for it.
struct Format {
    std::string name;    // of its folder in tests/corpus
    std::string ending;  // of its files: ".json"
    std::function<std::string(Random&)> mutated;
    /// Reads the bytes and, if they are accepted, does with them what the programs do.
    std::function<Verdict(std::string_view bytes, Random&)> check;
};

/// The formats of a program: those of JSON, and meshes if there is an importer; or pictures. `folder`: for files while
/// they are read. Must be called before threads are started.
std::vector<Format> formatsOf(const std::filesystem::path& importer, const std::filesystem::path& folder);

/// The JSON formats, and replays' inputs and bytes.
std::vector<Format> jsonFormats();
/// Meshes that are read by `importer` in a child process.
Format meshFormat(const std::filesystem::path& importer, const std::filesystem::path& folder);

}  // namespace rubble::attack
