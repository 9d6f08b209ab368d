#pragma once

#include "core/io/formats/PackOptions.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace rubble {

/// A choice that an export has: one of a few words. The command line, the dialog, settings and hashes are loops over
/// these rows.
struct ExportOption {
    struct Value {
        std::string_view word;  // on the command line, in settings and hashes
        std::string_view text;  // in the dialog, in English
    };
    std::string_view word;     // "faces": an option of the command line, and a key of settings
    std::string_view help;     // on the command line
    std::string_view caption;  // in the dialog, with its mnemonic; empty: not there
    std::string_view hint;     // in the dialog
    std::span<const Value> values;
    std::size_t (*get)(const PackOptions&);  // an index of `values`
    void (*set)(PackOptions&, std::size_t);
    std::string_view formerWord = {};  // that the command line reads, too; empty: none
    bool (*isUsed)(const PackOptions&) = [](const PackOptions&) { return true; };  // by the formats that have it
};

extern const ExportOption kGlbKindOption, kSplitOption, kPlaceOption, kFacesOption, kUpAxisOption, kUnitOption,
    kTexturesOption, kTextureSizeOption, kPackFilesOption, kTopologyOption;

/// All options, in the order of the dialog.
std::span<const ExportOption* const> exportOptions();

/// The index of a word among the values of an option; none if it has none of that name.
std::optional<std::size_t> valueNamed(const ExportOption& option, std::string_view word);

}  // namespace rubble
