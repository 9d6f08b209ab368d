#include "tests/attack/Format.h"

namespace rubble::attack {

std::vector<Format> formatsOf(const std::filesystem::path& importer, const std::filesystem::path& folder) {
    std::vector<Format> formats = jsonFormats();
    for (Format& format : sealedFormats(folder)) formats.push_back(std::move(format));
    formats.push_back(damageFormat());
    for (Format& format : engineFormats(folder)) formats.push_back(std::move(format));
    for (Format& format : binaryFormats()) formats.push_back(std::move(format));
    if (!importer.empty()) {
        for (Format& format : meshFormats(std::filesystem::absolute(importer), folder))
            formats.push_back(std::move(format));
    }
    return formats;
}

}  // namespace rubble::attack
