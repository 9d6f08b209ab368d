#include "core/io/formats/ExportOption.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace rubble {
namespace {

using Value = ExportOption::Value;

constexpr Value kGlbKinds[] = {{"plain", "Plain"},
                               {"physics", "With rigid bodies"},
                               {"compact", "Compact"},
                               {"ucx", "With hulls for Unreal Engine"}};
constexpr Value kSplits[] = {{"single", "One file for all"}, {"files", "One file each"}};
constexpr Value kPlaces[] = {{"assembled", "Assembled"}, {"centred", "Centred on the centre of mass"}};
constexpr Value kFaces[] = {{"polygons", "Polygons"}, {"triangles", "Triangles"}};
constexpr Value kUpAxes[] = {{"y", "Y up"}, {"z", "Z up"}};
constexpr Value kUnits[] = {{"m", "Metres"}, {"cm", "Centimetres"}, {"mm", "Millimetres"}};
constexpr Value kTextures[] = {{"none", "None"}, {"baked", "Of finishes"}};
constexpr Value kTextureSizes[] = {
    {"512", "512 × 512"}, {"1024", "1024 × 1024"}, {"2048", "2048 × 2048"}, {"4096", "4096 × 4096"}};
constexpr Value kPackFiles[] = {{"json", "pack.json"}, {"bin", "pack.bin"}, {"both", "Both"}};
constexpr Value kTopologies[] = {{"full", "Edges and planes"}, {"loops", "Loops only"}};

/// An option whose value is that of the member that `Member` returns a reference to.
template <class Member>
constexpr ExportOption row(std::string_view word, std::string_view help, std::string_view caption,
                           std::string_view hint, std::span<const Value> values, Member) {
    return {word,
            help,
            caption,
            hint,
            values,
            [](const PackOptions& options) { return static_cast<std::size_t>(Member{}(options)); },
            [](PackOptions& options, std::size_t value) {
                auto& member = Member{}(options);
                member = static_cast<std::remove_reference_t<decltype(member)>>(value);
            }};
}

/// An option that has a new word, with the one before.
constexpr ExportOption formerly(std::string_view word, ExportOption option) {
    option.formerWord = word;
    return option;
}

/// An option of the baked textures.
constexpr ExportOption ofTextures(ExportOption option) {
    option.isUsed = [](const PackOptions& options) { return options.meshes.textures != SurfaceTextures::None; };
    return option;
}

}  // namespace

constinit const ExportOption kGlbKindOption = row(
    "glb", "What GLB files hold (default: plain, or what --for needs)", "GLB &kind:",
    "Select the content of GLB files: a node per fragment; the same with rigid bodies and colliders; one skinned "
    "mesh, small and drawn at once; or with hulls called UCX_",
    kGlbKinds, [](auto& options) -> auto& { return options.meshes.glbKind; });
constinit const ExportOption kSplitOption =
    formerly("pieces", row(
                           "fragments", "All fragments in a single file (default) or one file each",
                           "Frag&ments:", "Select one file for all fragments or one file per fragment", kSplits,
                           [](auto& options) -> auto& { return options.meshes.split; }));
constinit const ExportOption kPlaceOption = row(
    "place", "Fragments in place (default) or with their centres of mass at the origin",
    "Posi&tion:", "Select the position of the fragments in the mesh files", kPlaces,
    [](auto& options) -> auto& { return options.meshes.place; });
constinit const ExportOption kFacesOption = row(
    "faces", "The faces in OBJ files (default: polygons)", "OBJ fac&es:", "Select the faces of OBJ files", kFaces,
    [](auto& options) -> auto& { return options.meshes.faces; });
constinit const ExportOption kUpAxisOption = row(
    "up", "The up axis of OBJ files (default: y)",
    "OBJ a&xes:", "Select the up axis of OBJ files; GLB files always have y up", kUpAxes,
    [](auto& options) -> auto& { return options.meshes.objFrame.up; });
constinit const ExportOption kUnitOption = row(
    "unit", "The unit of OBJ files (default: m)",
    "OBJ &unit:", "Select the unit of OBJ files; GLB files are always in metres", kUnits,
    [](auto& options) -> auto& { return options.meshes.objFrame.unit; });
constinit const ExportOption kTexturesOption = row(
    "textures", "Images of the finishes of materials in GLB and USD files (default: none)",
    "&Baked textures:", "Select whether the finishes of materials are baked into textures of GLB and USD files",
    kTextures, [](auto& options) -> auto& { return options.meshes.textures; });
constinit const ExportOption kTextureSizeOption = ofTextures(row(
    "texture-size", "The side of these images in texels (default: 2048)",
    "Texture si&ze:", "Select the size of the images that finishes are baked into", kTextureSizes,
    [](auto& options) -> auto& { return options.meshes.textureSize; }));
constinit const ExportOption kPackFilesOption = row(
    "pack", "The files that describe the bodies (default: both)", {}, {}, kPackFiles,
    [](auto& options) -> auto& { return options.files; });
constinit const ExportOption kTopologyOption = row(
    "topology", "Edges and planes of hulls in pack.json (default), or loops only", {}, {}, kTopologies,
    [](auto& options) -> auto& { return options.topology; });

std::span<const ExportOption* const> exportOptions() {
    static constexpr const ExportOption* kOptions[] = {
        &kGlbKindOption, &kSplitOption,    &kPlaceOption,       &kFacesOption,     &kUpAxisOption,
        &kUnitOption,    &kTexturesOption, &kTextureSizeOption, &kPackFilesOption, &kTopologyOption};
    return kOptions;
}

std::optional<std::size_t> valueNamed(const ExportOption& option, std::string_view word) {
    const auto found = std::ranges::find(option.values, word, &Value::word);
    if (found == option.values.end()) return std::nullopt;
    return static_cast<std::size_t>(std::distance(option.values.begin(), found));
}

}  // namespace rubble
