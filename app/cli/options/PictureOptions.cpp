#include "app/cli/options/PictureOptions.h"

#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PictureValues.h"
#include "viewport/render/OffscreenRenderer.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr int kMaxSamples = 4096;
constexpr double kDebrisSpace = 0.3;  // of the height: holds most of a collapsed wall

/// The values of --overlay.
struct OverlayWord {
    const char* word;
    bool PlayOverlays::*flag;
};
constexpr OverlayWord kOverlays[] = {{"contacts", &PlayOverlays::hasContacts}, {"normals", &PlayOverlays::hasNormals},
                                     {"impulses", &PlayOverlays::hasImpulses}, {"boxes", &PlayOverlays::hasBoxes},
                                     {"islands", &PlayOverlays::hasIslands},   {"sleep", &PlayOverlays::hasSleep},
                                     {"heat", &PlayOverlays::hasHeat}};

/// The values of --colour.
constexpr std::pair<const char*, SceneColouring> kColourings[] = {
    {"material", SceneColouring::Material},  {"piece", SceneColouring::Piece}, {"level", SceneColouring::Level},
    {"volume", SceneColouring::Volume},      {"mass", SceneColouring::Mass},   {"aspect", SceneColouring::Aspect},
    {"threshold", SceneColouring::Threshold}};

/// Adds an option whose value must be accepted by `parse`.
template <class Parse>
void addParsed(CLI::App& command, const char* name, std::string& text, const char* help, const char* label, Parse parse,
               const std::string& error) {
    const auto check = [parse, error](const std::string& given) {
        return parse(given) ? std::string() : '"' + given + "\" is " + error;
    };
    command.add_option(name, text, help)->check(CLI::Validator(check, ""))->option_text(label);
}

}  // namespace

void addViewOptions(CLI::App& command, PictureOptions& options) {
    addParsed(command, "--size", options.size, "The size in pixels (default: 1280x720)", "WxH", parsePictureSize,
              "not a size from 1x1 to " + std::to_string(kMaxImageSide) + "x" + std::to_string(kMaxImageSide));
    addParsed(command, "--view", options.view, "front, top, iso (default), ..., or AZIMUTH,ELEVATION in degrees",
              "VIEW", parseCamera, "not one of " + viewWords() + " and not AZIMUTH,ELEVATION in degrees");
}

void addStyleOptions(CLI::App& command, PictureOptions& options) {
    std::vector<std::string> colourings;
    for (const auto& [word, colouring] : kColourings) colourings.emplace_back(word);
    command
        .add_option("--colour", options.colour,
                    "Colour by material (default), piece, level, volume, mass, aspect or threshold")
        ->check(oneOf(colourings))
        ->option_text("BY");
    command.add_option("--theme", options.theme, "light (default) or dark")
        ->check(oneOf({"light", "dark"}))
        ->option_text("THEME");
    command.add_flag("--wireframe", options.isWireframe, "Draw edges only");
    command.add_flag("--hulls", options.hasHulls, "Draw the convex hulls of the fragments");
    command.add_flag("--bonds", options.hasBonds,
                     "Draw lines between neighbouring fragments, as wide as their contact areas");
}

void addOverlayOption(CLI::App& command, PictureOptions& options) {
    std::vector<std::string> words;
    for (const OverlayWord& overlay : kOverlays) words.emplace_back(overlay.word);
    command
        .add_option("--overlay", options.overlays,
                    "Draw contacts, normals, impulses, boxes, islands, sleep or heat; repeatable")
        ->expected(1)
        ->take_all()
        ->check(oneOf(words))
        ->option_text("NAME");
}

void addSamplesOption(CLI::App& command, PictureOptions& options) {
    command
        .add_option("--samples", options.samples,
                    "The number of samples per picture (default: " + std::to_string(options.samples) + ")")
        ->check(numberBetween(0, kMaxSamples))
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

Box3 withSpaceForDebris(Box3 box) {
    if (box.isEmpty()) return box;
    const double space = kDebrisSpace * (box.max.y - box.min.y);
    box.min -= Vec3(space, 0.0, space);
    box.max += Vec3(space, 0.0, space);
    return box;
}

RenderView pictureView(const PictureOptions& options, const Box3& framed) {
    RenderView view{.camera = *parseCamera(options.view), .size = *parsePictureSize(options.size)};
    view.settings.theme = options.theme == "dark" ? Theme::Dark : Theme::Light;
    view.settings.shading = options.isWireframe ? Shading::Wireframe : Shading::Faces;
    view.camera = framing(view.camera, framed, view.size);
    return view;
}

}  // namespace rubble
