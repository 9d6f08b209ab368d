#include "core/io/exchange/CompactGlb.h"
#include "core/io/exchange/GlbWriter.h"
#include "core/io/formats/ExportFormat.h"

namespace rubble {
namespace {

constexpr const ExportOption* kGlbOptions[] = {&kGlbKindOption, &kSplitOption, &kPlaceOption, &kTexturesOption,
                                               &kTextureSizeOption};

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
    const GlbPhysics* bodies = physics ? &*physics : nullptr;
    if (input.textures == nullptr) return glbFile(parts, input.materials, place, bodies);
    std::vector<MeshPart> textured(parts.begin(), parts.end());
    for (std::size_t k = 0; k < textured.size(); ++k) {
        Mesh& mesh = textured[k].mesh;
        mesh = file.bodies == PackMeshBodies::Whole ? input.textures->wholeMesh(mesh)
                                                    : input.textures->fragmentMesh(file.fragments[k], mesh);
    }
    return glbFile(textured, input.textures->materials, place, bodies);
}

/// Those of compact files have the colours of materials.
bool hasImages(const MeshOptions& options) { return options.glbKind != GlbKind::Compact; }

}  // namespace

extern const ExportFormat kGlbFormat;
constinit const ExportFormat kGlbFormat{.word = "glb",
                                        .caption = "&GLB",
                                        .hint = "Write binary glTF files",
                                        .options = kGlbOptions,
                                        .hasBakedImages = hasImages,
                                        .bytesPerFragment = glbBytes,
                                        .suffix = ".glb",
                                        .partFile = glbParts};

}  // namespace rubble
