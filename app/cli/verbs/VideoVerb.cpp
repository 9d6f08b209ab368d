#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PictureOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/QuantityText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/media/PictureSequence.h"
#include "core/io/media/VideoFile.h"
#include "viewport/video/Video.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace rubble {
namespace {

constexpr int kVideoMsaa = 4;  // samples per pixel

constexpr const char* kVideoFooter =
    R"(Plays a project and draws it every few steps, from a fixed view. The pictures are FOLDER/frame-0000.png and so
on; a sequence that is stopped keeps those that are complete. A folder that already holds such pictures is
rejected. With ffmpeg installed, VIDEO.mp4 (or .mkv, .mov, .webm) encodes them as a video. With --compare each
picture shows the same step twice, side by side, without destruction on the left and with it on the right, each
of the given --size. With --sound a video has the sound of impacts and breaks as heard from the camera, faster
or slower as the pictures are; that with destruction with --compare.

Examples:
  rubble-cli video house.rubble hit.mp4 --steps 300 --shot "block under the roof"
  rubble-cli video house.rubble slow.mp4 --from 40 --steps 120 --rate 12 --shot "block under the roof"
  rubble-cli video house.rubble both --steps 120 --every 2 --compare --size 640x480 --shot "box at the door")";

struct VideoOptions {
    std::string file;
    std::string output;
    PictureOptions picture{.samples = 0};
    PlayOptions play;
    int first = 0;
    int steps = 0;
    int every = 1;
    std::optional<double> rate;  // pictures per second; none: real time
    bool isCompared = false;
    bool hasSound = false;
    int threads = 1;
};

/// Returns two playbacks, without and with destruction, if they are compared; else one.
Result<std::vector<SessionPlayback>> playbacksOf(const PreparedProject& play, const VideoOptions& options) {
    std::vector<SessionPlayback> playbacks;
    std::vector<PlayOptions> plays{options.play};
    if (options.isCompared) {
        plays.insert(plays.begin(), options.play);
        plays.front().isWithoutDestruction = true;
    }
    for (const PlayOptions& playOptions : plays) {
        Result<Session> session = createSession(play, playOptions, options.threads);
        if (!session) return session.error();
        playbacks.emplace_back(play.scene, std::move(*session), std::vector<TimedInput>(),
                               sceneOptions(options.picture), playOverlays(options.picture));
    }
    return playbacks;
}

Result<VideoPlan> planOf(const VideoOptions& options) {
    if (options.first > options.steps) {
        return Error{ErrorCode::BadInput, "The video would start at step " + std::to_string(options.first) +
                                              " and end at step " + std::to_string(options.steps) + "."};
    }
    const int pictures = frameCount(options.first, options.steps, options.every);
    if (pictures > kMaxPictures) {
        return Error{ErrorCode::BadInput, "The video would have " + std::to_string(pictures) +
                                              " pictures; the maximum is " + std::to_string(kMaxPictures) +
                                              ". Use --every to render fewer."};
    }
    const double asPlayed = 1.0 / (options.play.stepLength * options.every);
    return VideoPlan{.samples = videoSamplesOf(options.picture),
                     .first = static_cast<double>(options.first),
                     .stepsPerFrame = static_cast<double>(options.every),
                     .frames = pictures,
                     .frameRate = options.rate.value_or(std::min(asPlayed, rangeOf(ProjectNumber::FrameRate).max)),
                     .hasSound = options.hasSound};
}

Status video(VideoOptions& options, VerbReport& report, const CliContext& context) {
    Result<VideoPlan> plan = planOf(options);
    if (!plan) return plan.error();
    const bool isVideo = isVideoPath(options.output);
    if (isVideo && !findFfmpeg()) {
        return Error{ErrorCode::NotFound,
                     "A video needs ffmpeg, which is not installed; give a folder instead to write its pictures."};
    }
    if (options.hasSound && !isVideo) {
        return Error{ErrorCode::BadInput,
                     "--sound needs a video such as hit.mp4; rubble-cli simulate --wav writes the sound alone."};
    }
    TaskContext task{.cancel = context.cancel, .threads = options.threads};
    if (const Status loaded = loadSkyFile(options.picture, task); !loaded) return loaded;
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    const Result<PreparedProject> play = prepareProject(*project, options.play, context, task);
    if (!play) return play.error();
    if (play->scene->project.instances.empty()) {
        return Error{ErrorCode::NotFound, "The project has no instances to render."};
    }
    Result<std::vector<SessionPlayback>> playbacks = playbacksOf(*play, options);
    if (!playbacks) return playbacks.error();
    plan->view = pictureView(options.picture, withSpaceForDebris(boundsOf(*playbacks->front().scene())));
    plan->view.settings.msaa = kVideoMsaa;
    ProgressLine line(context, "Rendering");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const Status shot = isVideo ? renderVideo(*playbacks, *plan, options.output, task)
                                : renderFrames(*playbacks, *plan, options.output, Unfinished::Kept, task);
    line.clear();
    for (SessionPlayback& playback : *playbacks) printWarnings(playback, context);
    if (!shot) return shot;
    const auto pictures = static_cast<std::size_t>(plan->frames);
    report.writeResults = [output = options.output, pictures](JsonWriter& json) {
        json.text("output", printableText(output));
        json.wholeNumber("pictures", std::uint64_t{pictures});
    };
    return printSummary(countText(pictures, "picture", "pictures") + " written to " + options.output + "\n", report,
                        context);
}

}  // namespace

Verb addVideo(CLI::App& program) {
    Command command(program, "video", "Render a simulation as a sequence of PNG pictures or as a video", kVideoFooter);
    const auto options = std::make_shared<VideoOptions>();
    addProjectArgument(command, options->file);
    command.argument("FOLDER", options->output, "The folder for the pictures, or the video to write: VIDEO.mp4")
        .writes({".mp4", ".webm", ".mkv", ".mov"})
        .required();
    command.option("--from", options->first, "The step of the first picture (default: 0)")
        .wholeInRange(ProjectNumber::Step)
        .valueName("STEP");
    command.option("-n,--steps", options->steps, "The number of steps to simulate")
        .required()
        .wholeInRange(ProjectNumber::Step)
        .valueName("N");
    command.option("--every", options->every, "Steps between pictures (default: 1)")
        .wholeInRange(ProjectNumber::Steps)
        .valueName("K");
    command.option("--rate", options->rate, "Pictures per second of a video (default: real time)")
        .inRange(ProjectNumber::FrameRate)
        .valueName("N");
    addPlayOptions(command, options->play);
    command.flag("--compare", options->isCompared, "Show it without and with destruction, side by side")
        .valueName(" ");  // hides CLI11's note on --no-destruction
    command["--compare"].excludes(command["--no-destruction"].valueName(" "));
    command.flag("--sound", options->hasSound,
                 "Add the sound of impacts and breaks, heard from the camera, to a video");
    addViewOptions(command, options->picture);
    addStyleOptions(command, options->picture);
    addOverlayOption(command, options->picture);
    addSamplesOption(command, options->picture);
    command.addReportFlag();
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return video(*options, report, context); }};
}

}  // namespace rubble
