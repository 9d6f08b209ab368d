#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/PictureWords.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/ProjectFile.h"
#include "viewport/render/Picture.h"
#include "viewport/scene/SceneBuilder.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Draws the pieces that assets break into, where the project's instances stand, by OpenGL and without a display. With
--asset one asset is drawn by itself. Each sample adds a direction of light; 0 draws what the editor shows while one
turns the view.

Examples:
  rubble-cli render house.rubble --out house.png
  rubble-cli render house.rubble --out apart.png --explode 0.4 --colour piece --size 1920x1080
  rubble-cli render house.rubble --out wall.png --asset wall --view 30,15 --hulls --theme dark)";

struct RenderOptions {
    std::string file;
    std::string out;
    std::vector<std::string> assets;
    std::string size = "1280x720";
    std::string view = "iso";
    std::string colour = "material";
    std::string theme = "light";
    double exploded = 0.0;
    bool isWireframe = false;
    bool hasHulls = false;
    bool isWhole = false;
    int samples = 32;
    int threads = 1;
};

SceneOptions sceneOptions(const RenderOptions& options, Id asset) {
    SceneOptions scene{.asset = asset, .exploded = options.exploded, .hasHulls = options.hasHulls};
    scene.isWhole = options.isWhole;
    if (options.colour == "piece") scene.colouring = SceneColouring::Piece;
    if (options.colour == "volume") scene.colouring = SceneColouring::Volume;
    return scene;
}

/// The asset to draw by itself; 0 where the whole scene is meant.
///
/// Errors: those of chosenAssets(); NotFound where the scene has nothing in it.
Result<Id> assetToDraw(const Project& project, const RenderOptions& options) {
    const Result<std::vector<Id>> chosen = chosenAssets(project, options.assets);
    if (!chosen) return chosen.error();
    if (!options.assets.empty()) return chosen->front();
    if (project.instances.empty()) {
        return Error{ErrorCode::NotFound, "The project has no instance to draw; --asset draws an asset by itself."};
    }
    return Id{0};
}

PictureView pictureView(const RenderScene& scene, const RenderOptions& options) {
    PictureView view{.camera = *cameraOf(options.view), .size = *pictureSizeOf(options.size)};
    view.settings.theme = options.theme == "dark" ? Theme::Dark : Theme::Light;
    view.settings.shading = options.isWireframe ? Shading::Wireframe : Shading::Faces;
    view.camera = framing(view.camera, boundsOf(scene), view.size);
    return view;
}

Status render(const RenderOptions& options, const CliContext& context) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<Id> asset = assetToDraw(*project, options);
    if (!asset) return asset.error();
    TaskContext task{.cancel = context.cancel, .threads = options.threads};
    const std::vector<Id> only = *asset == 0 ? std::vector<Id>() : std::vector<Id>{*asset};
    const Result<AssetBakes> bakes = options.isWhole ? AssetBakes() : bakesOf(*project, only, task);
    if (!bakes) return bakes.error();
    const auto scene = std::make_shared<const RenderScene>(sceneOf(*project, *bakes, sceneOptions(options, *asset)));

    ProgressLine line(context, "Drawing");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const Result<Image> image = pictureOf(scene, pictureView(*scene, options), options.samples, task);
    line.clear();
    if (!image) return image.error();
    const Result<std::string> png = pngOf(*image);
    if (!png) return png.error();
    return writeOutput(options.out, *png, context);
}

/// An option whose text some function has to take.
template <class Parse>
void addParsed(CLI::App& command, const char* name, std::string& text, const char* help, const char* label, Parse parse,
               const std::string& fault) {
    const auto check = [parse, fault](const std::string& given) {
        return parse(given) ? std::string() : '"' + given + "\" is " + fault;
    };
    command.add_option(name, text, help)->check(CLI::Validator(check, ""))->option_text(label);
}

template <class Number>
void addNumber(CLI::App& command, const char* name, Number& number, const char* help, const char* label, Number most) {
    command.add_option(name, number, help)->check(numberBetween(Number{0}, most))->option_text(label);
}

void addLooks(CLI::App& command, RenderOptions& options) {
    command.add_option("--colour", options.colour, "By material, piece or volume: material if not given")
        ->check(oneOf({"material", "piece", "volume"}))
        ->option_text("BY");
    command.add_option("--theme", options.theme, "light or dark: light if not given")
        ->check(oneOf({"light", "dark"}))
        ->option_text("THEME");
    command.add_flag("--wireframe", options.isWireframe, "Edges only, also those behind");
    command.add_flag("--hulls", options.hasHulls, "The convex hulls over the pieces");
    command.add_flag("--whole", options.isWhole, "Assets before they break");
    addNumber(command, "--samples", options.samples, "How many samples are taken: 32 if not given", "N", 4096);
}

}  // namespace

Verb addRender(CLI::App& program) {
    CLI::App* command = program.add_subcommand("render", "Draw the pieces in 3D as a PNG picture");
    const auto options = std::make_shared<RenderOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    command->add_option("--out", options->out, "Where to write the picture; - for standard output")
        ->required()
        ->option_text("FILE");
    command->add_option("--asset", options->assets, "One asset by itself, not the scene")
        ->expected(1)
        ->option_text("NAME");
    addParsed(*command, "--size", options->size, "Pixels: 1280x720 if not given", "WxH", pictureSizeOf,
              "no size from 1x1 to " + std::to_string(kLargestPicture) + "x" + std::to_string(kLargestPicture));
    addParsed(*command, "--view", options->view,
              "A word as front, top or iso, or AZIMUTH,ELEVATION in degrees: iso if not given", "VIEW", cameraOf,
              "none of " + viewWords() + ", and no azimuth,elevation in degrees");
    addNumber(*command, "--explode", options->exploded, "How far pieces stand apart: 1 doubles their distances", "F",
              100.0);
    addLooks(*command, *options);
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return render(*options, context); }};
}

}  // namespace rubble
