#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PictureOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/media/PictureSequence.h"
#include "core/io/media/VideoFile.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/play/SessionSceneBuilder.h"
#include "viewport/video/Turntable.h"

#include <memory>
#include <optional>

namespace rubble {
namespace {

constexpr const char* kRenderFooter =
    R"(Renders the fragments of a project's instances in 3D, with OpenGL but without a display; with --asset, a single
asset. With --at, simulates the project to that step, with the given shots, and renders it then, framed as at
the start. Each sample adds directions of light; 0 renders a single pass, as for videos.

Examples:
  rubble-cli render house.rubble --out house.png
  rubble-cli render house.rubble --out apart.png --explode 0.4 --colour fragment --size 1920x1080
  rubble-cli render house.rubble --out wall.png --asset wall --view 30,15 --hulls --theme dark
  rubble-cli render house.rubble --out cut-out.png --asset wall --transparent-background
  rubble-cli render house.rubble --out hit.png --at 60 --shot "box at the door"
  rubble-cli render house.rubble --out around.mp4 --turntable 90 --sky morning
  rubble-cli render house.rubble --out dusk.png --sky dusk.hdr --exposure -0.5)";

struct RenderOptions {
    std::string file;
    std::string out;
    std::vector<std::string> assets;
    double explodeFactor = 0.0;
    bool isWhole = false;
    bool isCutOut = false;
    std::optional<int> turntableFrames;
    PictureOptions picture;
    std::optional<int> step;  // of the simulation; none: before it
    PlayOptions play;
    int threads = 1;
};

Error nothingToRender() {
    return {ErrorCode::NotFound, "The project has no instances to render; use --asset to render an asset."};
}

/// Returns the asset to render; 0 for the scene.
///
/// Errors: those of selectedAssets(); NotFound if the scene is empty.
Result<Id> assetToRender(const Project& project, const RenderOptions& options) {
    const Result<std::vector<Id>> selected = selectedAssets(project, options.assets);
    if (!selected) return selected.error();
    if (!options.assets.empty()) return selected->front();
    if (project.instances.empty()) return nothingToRender();
    return Id{0};
}

/// The scene to render, and the box that the camera frames.
struct Subject {
    std::shared_ptr<const RenderScene> scene;
    Box3 framed;
};

/// Returns the fragments, exploded or not.
Result<Subject> fragmentsOf(const RenderOptions& options, const CliContext& context, const TaskContext& task) {
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    const Result<Id> asset = assetToRender(*project, options);
    if (!asset) return asset.error();
    const std::vector<Id> only = *asset == 0 ? std::vector<Id>() : std::vector<Id>{*asset};
    const Result<AssetBakes> bakes = options.isWhole ? AssetBakes() : bakesOf(*project, only, task);
    if (!bakes) return bakes.error();
    SceneOptions content = sceneOptions(options.picture);
    content.asset = *asset;
    content.explodeFactor = options.explodeFactor;
    content.isWhole = options.isWhole;
    const auto scene = std::make_shared<const RenderScene>(sceneOf(*project, *bakes, content));
    return Subject{scene, boundsOf(*scene)};
}

/// Returns the scene at a step of the simulation, framed as at its start.
Result<Subject> simulatedScene(const RenderOptions& options, const CliContext& context, TaskContext task) {
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    const Result<PreparedProject> play = prepareProject(*project, options.play, context, task);
    if (!play) return play.error();
    if (play->scene->project.instances.empty()) return nothingToRender();
    Result<Session> session = createSession(*play, options.play, options.threads);
    if (!session) return session.error();
    SessionPlayback playback(play->scene, std::move(*session), {}, sceneOptions(options.picture),
                             playOverlays(options.picture));
    const Box3 framed = withSpaceForDebris(boundsOf(*playback.scene()));
    ProgressLine line(context, "Simulating");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const auto scene = playback.sceneAtStep(static_cast<std::uint64_t>(*options.step), task);
    line.clear();
    printWarnings(playback, context);
    if (!scene) return scene.error();
    return Subject{*scene, framed};
}

Result<Image> imageOf(const Subject& subject, const RenderOptions& options, const TaskContext& task) {
    RenderView view = pictureView(options.picture, subject.framed);
    if (!options.isCutOut) return renderImage(subject.scene, view, samplesOf(options.picture), task);
    view.settings.hasOverlays = false;
    Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return renderer.error();
    return renderer->renderCutOut(subject.scene, view, samplesOf(options.picture), task);
}

constexpr double kTurntableRate = 30.0;  // pictures per second

/// Writes the pictures of a turntable, or a video of them.
Status renderTurntable(const Subject& subject, const RenderOptions& options, const CliContext& context,
                       const TaskContext& task) {
    const bool isVideo = isVideoPath(options.out);
    if (isVideo && !findFfmpeg()) {
        return Error{ErrorCode::NotFound,
                     "A video needs ffmpeg, which is not installed; give a folder instead to write its pictures."};
    }
    const FrameSource frames =
        turntable(subject.scene, pictureView(options.picture, subject.framed), *options.turntableFrames,
                  isVideo ? videoSamplesOf(options.picture) : samplesOf(options.picture));
    const Status made = isVideo ? renderVideo(frames, kTurntableRate, options.out, {}, task)
                                : renderFrames(frames, options.out, Unfinished::Kept, task);
    if (made)
        context.err << countText(static_cast<std::size_t>(frames.frames), "picture", "pictures") << " written to "
                    << options.out << "\n";
    return made;
}

/// Whether --out is what the other options write.
Status checkOutput(const RenderOptions& options) {
    const bool isTurntable = options.turntableFrames.has_value();
    if (isTurntable && *options.turntableFrames == 0)
        return Error{ErrorCode::BadInput, "--turntable 0 has no pictures; give it at least 1."};
    if (isTurntable && (options.out == "-" || options.out.ends_with(".png"))) {
        return Error{ErrorCode::BadInput,
                     "--turntable writes several pictures: give --out a folder for them, or a video "
                     "such as around.mp4."};
    }
    if (isTurntable || !isVideoPath(options.out)) return success();
    return Error{ErrorCode::BadInput, quotedPath(options.out) +
                                          " would be a video: add --turntable N, or give --out a "
                                          "picture such as house.png."};
}

Status render(RenderOptions& options, const CliContext& context) {
    if (const Status checked = checkOutput(options); !checked) return checked;
    TaskContext task{.cancel = context.cancel, .threads = options.threads};
    if (const Status loaded = loadSkyFile(options.picture, task); !loaded) return loaded;
    const Result<Subject> subject =
        options.step ? simulatedScene(options, context, task) : fragmentsOf(options, context, task);
    if (!subject) return subject.error();
    ProgressLine line(context, "Rendering");
    task.progress = [&line](double fraction) { line.show(fraction); };
    if (options.turntableFrames) {
        const Status made = renderTurntable(*subject, options, context, task);
        line.clear();
        return made;
    }
    const Result<Image> image = imageOf(*subject, options, task);
    line.clear();
    if (!image) return image.error();
    const Result<std::string> png = pngOf(*image);
    if (!png) return png.error();
    return writeOutput(options.out, *png, context);
}

/// Adds --at, the options that need it, and its conflicts with options for fragments at rest.
void addSimulationOptions(Command& command, RenderOptions& options) {
    const CommandOption at = command.option("--at", options.step, "Simulate this many steps first")
                                 .wholeInRange(ProjectNumber::Step)
                                 .valueName("STEP");
    addPlayOptions(command, options.play);
    addOverlayOption(command, options.picture);
    for (const char* name : {"--dt", "--shot", "--shots", "--no-destruction", "--overlay"}) command[name].needs(at);
    command["--no-destruction"].valueName(" ");  // hides CLI11's note on --at
    command["--whole"].valueName(" ");
    for (const char* name : {"--asset", "--explode", "--whole"}) at.excludes(command[name]);
}

}  // namespace

Verb addRender(CLI::App& program) {
    Command command(program, "render", "Render fragments in 3D as a PNG picture", kRenderFooter);
    const auto options = std::make_shared<RenderOptions>();
    addProjectArgument(command, options->file);
    command.option("-o,--out", options->out, "The picture to write; - for standard output")
        .writes({".png", ".mp4", ".webm", ".mkv", ".mov"})
        .required()
        .valueName("FILE");
    command.option("-a,--asset", options->assets, "Render this asset instead of the scene").single().valueName("NAME");
    addViewOptions(command, options->picture);
    command.option("--explode", options->explodeFactor, "Explode the fragments: 1 doubles their distances")
        .inRange(ProjectNumber::ExplodeFactor)
        .valueName("F");
    addStyleOptions(command, options->picture);
    const CommandOption cutOut =
        command.flag("--transparent-background", options->isCutOut, "Draw the bodies alone, without sky and ground");
    command
        .option("--turntable", options->turntableFrames,
                "Render this many pictures from all around to the folder --out, or a video: --out VIDEO.mp4")
        .wholeUpTo(kMaxPictures)
        .excludes(cutOut)
        .valueName("N");
    command.flag("--whole", options->isWhole, "Show whole assets instead of their fragments");
    addSimulationOptions(command, *options);
    for (const char* name : {"--hulls", "--bonds", "--overlay"}) cutOut.excludes(command[name]);
    cutOut.valueName(" ");
    addSamplesOption(command, options->picture);
    addThreadsOption(command, options->threads);
    return {command, [options](VerbReport&, const CliContext& context) { return render(*options, context); }};
}

}  // namespace rubble
