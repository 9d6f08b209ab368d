#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/PictureOptions.h"
#include "app/cli/PlayOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/ProjectFile.h"
#include "viewport/render/Picture.h"
#include "viewport/scene/MomentBuilder.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Draws the pieces that assets break into, where the project's instances stand, by OpenGL and without a display. With
--asset one asset is drawn by itself. With --at the project is played so far, with the shots that are asked for, and
drawn as it is then, from where it was framed at the start. Each sample adds a direction of light; 0 draws what the
editor shows while one turns the view.

Examples:
  rubble-cli render house.rubble --out house.png
  rubble-cli render house.rubble --out apart.png --explode 0.4 --colour piece --size 1920x1080
  rubble-cli render house.rubble --out wall.png --asset wall --view 30,15 --hulls --theme dark
  rubble-cli render house.rubble --out hit.png --at 60 --shot "box at the door")";

struct RenderOptions {
    std::string file;
    std::string out;
    std::vector<std::string> assets;
    double exploded = 0.0;
    bool isWhole = false;
    PictureOptions picture;
    std::optional<int> step;  // a moment of play, not pieces
    PlayOptions play;
    int threads = 1;
};

Error nothingToDraw() {
    return {ErrorCode::NotFound, "The project has no instance to draw; --asset draws an asset by itself."};
}

/// The asset to draw by itself; 0 where the whole scene is meant.
///
/// Errors: those of chosenAssets(); NotFound where the scene has nothing in it.
Result<Id> assetToDraw(const Project& project, const RenderOptions& options) {
    const Result<std::vector<Id>> chosen = chosenAssets(project, options.assets);
    if (!chosen) return chosen.error();
    if (!options.assets.empty()) return chosen->front();
    if (project.instances.empty()) return nothingToDraw();
    return Id{0};
}

/// What is drawn, and the box that the camera shows.
struct Subject {
    std::shared_ptr<const RenderScene> scene;
    Box3 framed;
};

/// The pieces, together or apart.
Result<Subject> piecesOf(const RenderOptions& options, const TaskContext& task) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<Id> asset = assetToDraw(*project, options);
    if (!asset) return asset.error();
    const std::vector<Id> only = *asset == 0 ? std::vector<Id>() : std::vector<Id>{*asset};
    const Result<AssetBakes> bakes = options.isWhole ? AssetBakes() : bakesOf(*project, only, task);
    if (!bakes) return bakes.error();
    SceneOptions looks = sceneOptions(options.picture);
    looks.asset = *asset;
    looks.exploded = options.exploded;
    looks.isWhole = options.isWhole;
    const auto scene = std::make_shared<const RenderScene>(sceneOf(*project, *bakes, looks));
    return Subject{scene, boundsOf(*scene)};
}

/// A moment of play, seen from where the scene was framed before anything moved.
Result<Subject> momentAt(const RenderOptions& options, const CliContext& context, TaskContext task) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<ProjectInPlay> play = projectInPlay(*project, options.play, context, task);
    if (!play) return play.error();
    if (play->scene->project.instances.empty()) return nothingToDraw();
    Result<Session> session = startedSession(*play, options.play, options.threads);
    if (!session) return session.error();
    Take take(play->scene, std::move(*session), {}, sceneOptions(options.picture), playOverlays(options.picture));
    const Box3 framed = withRoomToFall(boundsOf(*take.moment()));
    ProgressLine line(context, "Simulating");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const auto moment = take.momentAfter(static_cast<std::uint64_t>(*options.step), task);
    line.clear();
    tellNotices(take, context);
    if (!moment) return moment.error();
    return Subject{*moment, framed};
}

Status render(const RenderOptions& options, const CliContext& context) {
    TaskContext task{.cancel = context.cancel, .threads = options.threads};
    const Result<Subject> subject = options.step ? momentAt(options, context, task) : piecesOf(options, task);
    if (!subject) return subject.error();
    ProgressLine line(context, "Drawing");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const PictureView view = pictureView(options.picture, subject->framed);
    const Result<Image> image = pictureOf(subject->scene, view, options.picture.samples, task);
    line.clear();
    if (!image) return image.error();
    const Result<std::string> png = pngOf(*image);
    if (!png) return png.error();
    return writeOutput(options.out, *png, context);
}

/// The options that draw a moment of play; none of them without --at, and no others that are about pieces at rest.
void addMoment(CLI::App& command, RenderOptions& options) {
    CLI::Option* at = command.add_option("--at", options.step, "Play so many steps first, and draw that moment")
                          ->check(numberBetween(0, kMostSteps))
                          ->option_text("STEP");
    addPlayOptions(command, options.play);
    addOverlayOption(command, options.picture);
    for (const char* name : {"--dt", "--shot", "--shots", "--no-destruction", "--overlay"})
        command.get_option(name)->needs(at);
    command.get_option("--no-destruction")->option_text(" ");  // or CLI11 tells of --at there
    command.get_option("--whole")->option_text(" ");
    for (const char* name : {"--asset", "--explode", "--whole"}) at->excludes(command.get_option(name));
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
    addViewOptions(*command, options->picture);
    command->add_option("--explode", options->exploded, "How far pieces stand apart: 1 doubles their distances")
        ->check(numberBetween(0.0, 100.0))
        ->option_text("F");
    addLookOptions(*command, options->picture);
    command->add_flag("--whole", options->isWhole, "Assets before they break");
    addMoment(*command, *options);
    addSamplesOption(*command, options->picture);
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return render(*options, context); }};
}

}  // namespace rubble
