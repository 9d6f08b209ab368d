#include "core/io/exchange/CompactGlb.h"
#include "core/io/exchange/GlbWriter.h"
#include "core/io/formats/ExportFormat.h"

namespace rubble {
namespace {

constexpr const ExportOption* kGlbOptions[] = {&kGlbKindOption, &kSplitOption, &kPlaceOption};

double glbBytes(const MeshOptions& options) {
    switch (options.glbKind) {
        case GlbKind::Plain: return 3400.0;
        case GlbKind::Physics: return 8800.0;
        case GlbKind::Compact: return 900.0;
        case GlbKind::Named: return 7100.0;
    }
    return 0.0;
}

/// The bodies in a file, in the order of its parts; nothing if GLB files have none.
std::optional<GlbPhysics> physicsOf(const FormatInput& input, const PartFile& file) {
    const GlbKind kind = input.options.glbKind;
    if (kind != GlbKind::Physics && kind != GlbKind::Named) return std::nullopt;
    const PackInput& pack = input.pack.input();
    GlbPhysics physics{.bodies = {},
                       .material = pack.material.own,
                       .form = kind == GlbKind::Named ? GlbBodyForm::Names : GlbBodyForm::Extensions};
    if (file.bodies == PackMeshBodies::Whole) physics.bodies.push_back({input.pack.whole(), {}});
    for (const std::uint32_t index : file.fragments) {
        PackBody body = input.pack.fragment(index);
        std::string parent = body.parent == kNone ? std::to_string(pack.asset.id) : pack.bake.fragmentId(body.parent);
        physics.bodies.push_back({std::move(body), std::move(parent)});
    }
    return physics;
}

Result<std::string> glbParts(const FormatInput& input, const PartFile& file, std::span<const MeshPart> parts) {
    const PartPlacement place = input.options.place;
    if (input.options.glbKind == GlbKind::Compact) return compactGlbFile(parts, input.materials, place, file.name);
    const std::optional<GlbPhysics> physics = physicsOf(input, file);
    return glbFile(parts, input.materials, place, physics ? &*physics : nullptr);
}

}  // namespace

extern const ExportFormat kGlbFormat;
constinit const ExportFormat kGlbFormat{.word = "glb",
                                        .caption = "&GLB",
                                        .hint = "Write binary glTF files",
                                        .options = kGlbOptions,
                                        .bytesPerFragment = glbBytes,
                                        .suffix = ".glb",
                                        .partFile = glbParts};

}  // namespace rubble
