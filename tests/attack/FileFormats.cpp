#include "tests/attack/Format.h"

namespace rubble::attack {

std::vector<Format> formatsOf(const std::filesystem::path& importer, const std::filesystem::path& folder) {
    std::vector<Format> formats = jsonFormats();
    if (!importer.empty()) formats.push_back(meshFormat(std::filesystem::absolute(importer), folder));
    return formats;
}

}  // namespace rubble::attack
