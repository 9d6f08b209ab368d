#include "core/io/formats/ExportTarget.h"

#include "export_readme.h"
#include "unreal_script.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::string_view kAll[] = {"obj", "glb"};
constexpr std::string_view kGlb[] = {"glb"};
constexpr std::string_view kUsd[] = {"usd"};

}  // namespace

std::span<const ExportTarget> exportTargets() {
    static constexpr ExportTarget kTargets[] = {
        {.word = "neutral",
         .title = "Any engine",
         .description = "OBJ and GLB meshes, and the bodies in pack.json and pack.bin.",
         .formats = kAll,
         .files = PackFiles::Both,
         .topology = PackTopology::Full},
        {.word = "unity",
         .title = "Unity",
         .description = "GLB meshes for glTFast or UnityGLTF; a script reads pack.json or pack.bin.",
         .formats = kGlb,
         .files = PackFiles::Both},
        {.word = "unreal",
         .title = "Unreal Engine",
         .description = "GLB with collision hulls, a script that imports them, and pack.json and pack.bin.",
         .formats = kGlb,
         .glbKind = GlbKind::Named,
         .files = PackFiles::Both,
         .script = "import_into_unreal.py"},
        {.word = "godot",
         .title = "Godot",
         .description = "GLB with rigid bodies, which Godot 4.3 and later read on import; and pack.json.",
         .formats = kGlb,
         .glbKind = GlbKind::Physics},
        {.word = "blender",
         .title = "Blender",
         .description = "GLB meshes, which Blender imports; and masses in pack.json.",
         .formats = kGlb},
        {.word = "web",
         .title = "Web",
         .description = "GLB with rigid bodies for three.js and Babylon.js; and pack.json.",
         .formats = kGlb,
         .glbKind = GlbKind::Physics},
        {.word = "usd",
         .title = "USD",
         .description = "USD with rigid bodies, colliders and breakable joints; and pack.json.",
         .formats = kUsd}};
    return kTargets;
}

PackOptions ExportTarget::options() const {
    PackOptions options{.files = files, .meshes = {.formats = {}, .glbKind = glbKind}, .topology = topology};
    for (const std::string_view format : formats) options.meshes.formats.insert(format);
    return options;
}

const ExportTarget* targetNamed(std::string_view word) {
    const std::span<const ExportTarget> targets = exportTargets();
    const auto found = std::ranges::find(targets, word, &ExportTarget::word);
    return found == targets.end() ? nullptr : &*found;
}

std::string readmeOf(const ExportTarget& target, const MeshOptions& options) {
    std::string text(exportReadme(std::string(target.word) + ".md"));
    const bool isPhysics = options.glbKind == GlbKind::Physics, isCompact = options.glbKind == GlbKind::Compact;
    if (options.formats.contains("glb") && isPhysics) text += exportReadme("glb-physics.md");
    if (options.formats.contains("glb") && isCompact) text += exportReadme("glb-compact.md");
    text += exportReadme("files.md");
    return text;
}

std::string scriptOf(const ExportTarget& target) { return std::string(unrealScript(target.script)); }

}  // namespace rubble
