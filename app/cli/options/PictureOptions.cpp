#include "app/cli/options/PictureOptions.h"

#include "app/cli/options/Command.h"
#include "app/cli/options/PictureValues.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/io/media/RadianceFile.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/render/light/SkyLight.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace rubble {
namespace {

constexpr const char* kSkyExtension = ".hdr";
constexpr double kDebrisSpace = 0.3;  // of the height: holds most of a collapsed wall

/// The values of --overlay.
struct OverlayWord {
    const char* word;
    bool PlayOverlays::*flag;
};
constexpr OverlayWord kOverlays[] = {{"contacts", &PlayOverlays::hasContacts}, {"normals", &PlayOverlays::hasNormals},
                                     {"impulses", &PlayOverlays::hasImpulses}, {"boxes", &PlayOverlays::hasBoxes},
                                     {"islands", &PlayOverlays::hasIslands},   {"sleep", &PlayOverlays::hasSleep},
                                     {"heat", &PlayOverlays::hasHeat},         {"bodies", &PlayOverlays::hasBodies},
                                     {"bonds", &PlayOverlays::hasBonds}};

/// The values of --colour.
constexpr std::pair<const char*, SceneColouring> kColourings[] = {
    {"material", SceneColouring::Material},   {"fragment", SceneColouring::Fragment},
    {"level", SceneColouring::Level},         {"volume", SceneColouring::Volume},
    {"mass", SceneColouring::Mass},           {"aspect", SceneColouring::Aspect},
    {"threshold", SceneColouring::Threshold}, {"bond-strength", SceneColouring::BondStrength},
    {"cluster", SceneColouring::Cluster}};

/// The values of --sky.
constexpr std::pair<const char*, SkyPreset> kSkies[] = {{"studio", SkyPreset::Studio},
                                                        {"overcast", SkyPreset::Overcast},
                                                        {"morning", SkyPreset::Morning},
                                                        {"evening", SkyPreset::Evening},
                                                        {"night", SkyPreset::Night}};

/// The values of --quality.
constexpr std::pair<const char*, RenderQuality> kQualities[] = {
    {"draft", RenderQuality::Draft}, {"good", RenderQuality::Good}, {"best", RenderQuality::Best}};

/// Adds an option whose value must be accepted by `parse`.
template <class Parse>
void addParsed(Command& command, const char* name, std::string& text, const char* help, const char* label, Parse parse,
               const std::string& error) {
    const auto check = [parse, error](const std::string& given) {
        return parse(given) ? std::string() : quotedName(given) + " is " + error;
    };
    command.option(name, text, help).check(check).valueName(label);
}

int samplesBy(const PictureOptions& options, int (*samplesOfQuality)(RenderQuality)) {
    for (const auto& [word, quality] : kQualities) {
        if (options.quality == word) return samplesOfQuality(quality);
    }
    return options.samples;
}

}  // namespace

void addViewOptions(Command& command, PictureOptions& options) {
    addParsed(command, "--size", options.size, "The size in pixels (default: 1280x720)", "WxH", parsePictureSize,
              "not a size from 1x1 to " + std::to_string(kMaxImageSide) + "x" + std::to_string(kMaxImageSide));
    addParsed(command, "--view", options.view, "front, top, iso (default), ..., or AZIMUTH,ELEVATION in degrees",
              "VIEW", parseCamera, "not one of " + viewWords() + " and not AZIMUTH,ELEVATION in degrees");
}

void addStyleOptions(Command& command, PictureOptions& options) {
    std::vector<std::string> colourings;
    for (const auto& [word, colouring] : kColourings) colourings.emplace_back(word);
    command
        .option("--colour", options.colour,
                "Colour by material (default), fragment, level, volume, mass, aspect, threshold, bond-strength or "
                "cluster")
        .oneOf(colourings)
        .formerWords({{"piece", "fragment"}})
        .valueName("BY");
    command.option("--theme", options.theme, "light (default) or dark").oneOf({"light", "dark"}).valueName("THEME");
    std::vector<std::string> skies;
    for (const auto& [word, sky] : kSkies) skies.emplace_back(word);
    command
        .option("--sky", options.sky,
                "Light by a studio (default), by an overcast, morning, evening or night sky, or by an .hdr file")
        .oneOfOrFile(skies, kSkyExtension)
        .valueName("NAME|FILE");
    command.option("--exposure", options.exposure, "Brighten the picture by this many stops (default: 0)")
        .inRange(ProjectNumber::Exposure)
        .valueName("STOPS");
    command.flag("--wireframe", options.isWireframe, "Draw edges only");
    const CommandOption hulls = command.flag("--hulls", options.hasHulls, "Draw the convex hulls of the fragments");
    const CommandOption bonds = command.flag(
        "--bonds", options.hasBonds, "Draw lines between neighbouring fragments, as wide as their contact areas");
    const CommandOption alone =
        command.flag("--no-overlays", options.hasNoOverlays, "Draw the scene alone: no axes, scale bar or lines");
    for (const CommandOption& shown : {hulls, bonds}) {
        alone.excludes(shown);
        shown.valueName(" ");  // hides CLI11's note on --no-overlays
    }
    alone.valueName(" ");
}

void addOverlayOption(Command& command, PictureOptions& options) {
    std::vector<std::string> words;
    for (const OverlayWord& overlay : kOverlays) words.emplace_back(overlay.word);
    command
        .option("--overlay", options.overlays,
                "Draw contacts, normals, impulses, boxes, islands, sleep, heat, bodies or bonds; repeatable")
        .repeatable()
        .oneOf(words)
        .excludes(command["--no-overlays"])
        .valueName("NAME");
}

void addSamplesOption(Command& command, PictureOptions& options) {
    command
        .option("--samples", options.samples,
                "The number of samples per picture (default: " + std::to_string(options.samples) + ")")
        .wholeInRange(ProjectNumber::ImageSamples)
        .valueName("N");
    std::vector<std::string> words;
    for (const auto& [word, quality] : kQualities) words.emplace_back(word);
    command
        .option("--quality", options.quality,
                "draft, good or best: 0, 32 or 128 samples per picture; of a video 0, 4 or 16")
        .oneOf(words)
        .excludes(command["--samples"])
        .valueName("WORD");
}

int samplesOf(const PictureOptions& options) { return samplesBy(options, &samplesOf); }
int videoSamplesOf(const PictureOptions& options) { return samplesBy(options, &videoSamplesOf); }

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

Status loadSkyFile(PictureOptions& options, const TaskContext& task) {
    if (!hasExtension(options.sky, kSkyExtension)) return success();
    Result<RadianceImage> image = loadRadiance(options.sky, task);
    if (!image) return image.error();
    options.skyFile = std::make_shared<const SkyLight>(skyLightOf(std::move(*image)));
    return success();
}

RenderView pictureView(const PictureOptions& options, const Box3& framed) {
    RenderView view{.camera = *parseCamera(options.view), .size = *parsePictureSize(options.size)};
    view.settings.theme = options.theme == "dark" ? Theme::Dark : Theme::Light;
    for (const auto& [word, sky] : kSkies) {
        if (options.sky == word) view.settings.sky = sky;
    }
    view.settings.skyFile = options.skyFile;
    view.settings.exposure = options.exposure;
    view.settings.shading = options.isWireframe ? Shading::Wireframe : Shading::Faces;
    view.settings.hasOverlays = !options.hasNoOverlays;
    view.camera = framing(view.camera, framed, view.size);
    return view;
}

}  // namespace rubble
