#pragma once

#include "core/io/pack/PackExport.h"

#include <array>
#include <string>
#include <string_view>

namespace rubble {

/// The program that an export is for.
enum class ExportTarget { Neutral, Unity, Unreal, Godot, Blender, Web, Usd };
inline constexpr std::array<std::string_view, 7> kExportTargets{"neutral", "unity", "unreal", "godot",
                                                                "blender", "web",   "usd"};

/// The file in an output folder that says how to use the export.
inline constexpr const char* kReadmeName = "README.md";

/// The script in an output folder for Unreal Engine that imports it there.
inline constexpr const char* kUnrealScriptName = "import_into_unreal.py";

/// What is exported for a program.
PackOptions optionsFor(ExportTarget target);

/// Returns README.md of an export with GLB files of a kind: what its files are, and how to use them in the program.
std::string readmeFor(ExportTarget target, GlbKind glbKind);

}  // namespace rubble
