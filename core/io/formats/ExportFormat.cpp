#include "core/io/formats/ExportFormat.h"

#include <algorithm>

namespace rubble {

extern const ExportFormat kObjFormat, kGlbFormat, kMjcfFormat, kUsdFormat, kCsvFormat;

std::span<const ExportFormat* const> exportFormats() {
    static constexpr const ExportFormat* kFormats[] = {&kObjFormat, &kGlbFormat, &kMjcfFormat, &kUsdFormat,
                                                       &kCsvFormat};
    return kFormats;
}

const ExportFormat* formatNamed(std::string_view word) {
    const std::span<const ExportFormat* const> formats = exportFormats();
    const auto found = std::ranges::find(formats, word, &ExportFormat::word);
    return found == formats.end() ? nullptr : *found;
}

std::vector<const ExportFormat*> formatsOf(const FormatSet& set) {
    std::vector<const ExportFormat*> formats;
    std::ranges::copy_if(exportFormats(), std::back_inserter(formats),
                         [&](const ExportFormat* format) { return set.contains(format->word); });
    return formats;
}

std::vector<std::uint32_t> unbrokenFragments(const Bake& bake) {
    std::vector<std::uint32_t> fragments;
    for (std::uint32_t index = 0; index < bake.fragmentCount(); ++index) {
        if (bake.fragment(index).childCount == 0) fragments.push_back(index);
    }
    return fragments;
}

std::string wholeFileName(const PackNames& names) { return names.folder + "-intact"; }

}  // namespace rubble
