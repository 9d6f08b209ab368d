#include "core/io/exchange/ObjFile.h"

#include "core/io/formats/ExportFormat.h"

namespace rubble {
namespace {

constexpr const ExportOption* kObjOptions[] = {&kSplitOption, &kPlaceOption, &kFacesOption, &kUpAxisOption,
                                               &kUnitOption};

std::string materialFile(const PackNames& names) { return names.folder + ".mtl"; }

Result<std::string> objParts(const FormatInput& input, const PartFile& /*file*/, std::span<const MeshPart> parts) {
    const auto written = [&](std::span<const MeshPart> each) {
        return objFile(each, input.materials, input.options.place, materialFile(input.pack.input().names),
                       input.options.objFrame);
    };
    if (input.options.faces == FaceShape::Polygons) return written(parts);
    std::vector<MeshPart> triangles(parts.begin(), parts.end());
    for (MeshPart& part : triangles) part.mesh = triangulated(part.mesh);
    return written(triangles);
}

}  // namespace

extern const ExportFormat kObjFormat;
constinit const ExportFormat kObjFormat{
    .word = "obj",
    .caption = "&OBJ with materials",
    .hint = "Write Wavefront OBJ files, which all 3D programs read",
    .options = kObjOptions,
    .hasImageFile = true,
    .bytesPerFragment = [](const MeshOptions&) { return 2200.0; },
    .suffix = ".obj",
    .partFile = objParts,
    .assetFileNames = [](const PackNames& names) { return std::vector{materialFile(names)}; },
    .assetFiles = [](const FormatInput& input) -> Result<std::vector<std::string>> {
        return std::vector{mtlFile(input.materials)};
    }};

}  // namespace rubble
