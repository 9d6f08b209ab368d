#include "app/cli/PictureOptions.h"

#include "app/cli/CommonOptions.h"
#include "app/cli/PictureWords.h"
#include "viewport/render/Picture.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr int kMostSamples = 4096;
constexpr double kRoomToFall = 0.3;  // of the height: most of a wall lies there when it has fallen

/// What --overlay names.
struct OverlayWord {
    const char* word;
    bool PlayOverlays::*flag;
};
constexpr OverlayWord kOverlays[] = {{"contacts", &PlayOverlays::hasContacts}, {"normals", &PlayOverlays::hasNormals},
                                     {"impulses", &PlayOverlays::hasImpulses}, {"boxes", &PlayOverlays::hasBoxes},
                                     {"islands", &PlayOverlays::hasIslands},   {"sleep", &PlayOverlays::hasSleep},
                                     {"heat", &PlayOverlays::hasHeat}};

/// What --colour names.
constexpr std::pair<const char*, SceneColouring> kColourings[] = {
    {"material", SceneColouring::Material},  {"piece", SceneColouring::Piece}, {"level", SceneColouring::Level},
    {"volume", SceneColouring::Volume},      {"mass", SceneColouring::Mass},   {"aspect", SceneColouring::Aspect},
    {"threshold", SceneColouring::Threshold}};

/// An option whose text some function has to take.
template <class Parse>
void addParsed(CLI::App& command, const char* name, std::string& text, const char* help, const char* label, Parse parse,
               const std::string& fault) {
    const auto check = [parse, fault](const std::string& given) {
        return parse(given) ? std::string() : '"' + given + "\" is " + fault;
    };
    command.add_option(name, text, help)->check(CLI::Validator(check, ""))->option_text(label);
}

}  // namespace

void addViewOptions(CLI::App& command, PictureOptions& options) {
    addParsed(command, "--size", options.size, "Pixels: 1280x720 if not given", "WxH", pictureSizeOf,
              "no size from 1x1 to " + std::to_string(kLargestPicture) + "x" + std::to_string(kLargestPicture));
    addParsed(command, "--view", options.view,
              "A word as front, top or iso, or AZIMUTH,ELEVATION in degrees: iso if not given", "VIEW", cameraOf,
              "none of " + viewWords() + ", and no azimuth,elevation in degrees");
}

void addLookOptions(CLI::App& command, PictureOptions& options) {
    std::vector<std::string> colourings;
    for (const auto& [word, colouring] : kColourings) colourings.emplace_back(word);
    command
        .add_option("--colour", options.colour,
                    "By material, piece, level, volume, mass, aspect or threshold: material if not given")
        ->check(oneOf(colourings))
        ->option_text("BY");
    command.add_option("--theme", options.theme, "light or dark: light if not given")
        ->check(oneOf({"light", "dark"}))
        ->option_text("THEME");
    command.add_flag("--wireframe", options.isWireframe, "Edges only, also those behind");
    command.add_flag("--hulls", options.hasHulls, "The convex hulls over the pieces");
    command.add_flag("--bonds", options.hasBonds, "Lines between pieces that touch, as wide as what they share");
}

void addOverlayOption(CLI::App& command, PictureOptions& options) {
    std::vector<std::string> words;
    for (const OverlayWord& overlay : kOverlays) words.emplace_back(overlay.word);
    command
        .add_option("--overlay", options.overlays,
                    "Show contacts, normals, impulses, boxes, islands, sleep or heat; may be given again")
        ->expected(1)
        ->take_all()
        ->check(oneOf(words))
        ->option_text("NAME");
}

void addSamplesOption(CLI::App& command, PictureOptions& options) {
    command
        .add_option("--samples", options.samples,
                    "How many samples are taken: " + std::to_string(options.samples) + " if not given")
        ->check(numberBetween(0, kMostSamples))
        ->option_text("N");
}

SceneOptions sceneOptions(const PictureOptions& options) {
    SceneOptions scene{.hasHulls = options.hasHulls, .hasBonds = options.hasBonds};
    for (const auto& [word, colouring] : kColourings) {
        if (options.colour == word) scene.colouring = colouring;
    }
    return scene;
}

PlayOverlays playOverlays(const PictureOptions& options) {
    PlayOverlays overlays{.hasHulls = options.hasHulls};
    for (const OverlayWord& overlay : kOverlays) {
        if (std::ranges::find(options.overlays, overlay.word) != options.overlays.end()) overlays.*overlay.flag = true;
    }
    return overlays;
}

Box3 withRoomToFall(Box3 box) {
    if (box.isEmpty()) return box;
    const double reach = kRoomToFall * (box.max.y - box.min.y);
    box.min -= Vec3(reach, 0.0, reach);
    box.max += Vec3(reach, 0.0, reach);
    return box;
}

PictureView pictureView(const PictureOptions& options, const Box3& framed) {
    PictureView view{.camera = *cameraOf(options.view), .size = *pictureSizeOf(options.size)};
    view.settings.theme = options.theme == "dark" ? Theme::Dark : Theme::Light;
    view.settings.shading = options.isWireframe ? Shading::Wireframe : Shading::Faces;
    view.camera = framing(view.camera, framed, view.size);
    return view;
}

}  // namespace rubble
