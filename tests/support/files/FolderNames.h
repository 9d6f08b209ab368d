#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace rubble {

/// The names of all entries of a folder, including hidden ones, sorted.
inline std::vector<std::string> namesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
}

}  // namespace rubble
