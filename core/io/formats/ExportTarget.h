#pragma once

#include "core/io/formats/PackOptions.h"

#include <span>
#include <string>
#include <string_view>

namespace rubble {

/// The file in an output folder that says how to use the export.
inline constexpr const char* kReadmeName = "README.md";

/// A program that an export is for: a row that says what is written for it. Its README.md is in resources/readmes.
struct ExportTarget {
    std::string_view word;         // on the command line and in settings: "unity"
    std::string_view title;        // in the dialog, in English
    std::string_view description;  // of what is written for it, in the dialog
    std::span<const std::string_view> formats;
    GlbKind glbKind = GlbKind::Plain;
    PackFiles files = PackFiles::Json;
    PackTopology topology = PackTopology::Loops;
    std::string_view script;  // a file of resources/unreal that is written into output folders; empty: none

    PackOptions options() const;
};

/// All programs, those of no particular one first.
std::span<const ExportTarget> exportTargets();

/// A row of exportTargets(); null if there is no program of that name.
const ExportTarget* targetNamed(std::string_view word);

/// Returns README.md of an export for a program: what its files are, and how to use them there.
std::string readmeOf(const ExportTarget& target, const MeshOptions& options);

/// The bytes of the script of a program.
std::string scriptOf(const ExportTarget& target);

}  // namespace rubble
