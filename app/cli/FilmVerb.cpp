#include "app/cli/CommonOptions.h"
#include "app/cli/PictureOptions.h"
#include "app/cli/PlayOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/AtomicFile.h"
#include "core/io/MadeFolders.h"
#include "core/io/ProjectFile.h"
#include "viewport/render/Picture.h"
#include "viewport/scene/MomentBuilder.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Plays a project and draws it at step 0 and every so many steps after it, seen from one place. Pictures are named
FOLDER/frame-0000.png and so on; each is written whole or not at all, and a film that is stopped keeps those it has. A
folder that holds such pictures is refused. With --compare each picture shows the same moment twice, side by side:
without destruction on the left, with it on the right, each in --size.

Examples:
  rubble-cli film house.rubble film --steps 300 --every 2 --shot "block under the roof"
  rubble-cli film house.rubble both --steps 120 --compare --size 640x480 --shot "box at the door"
  ffmpeg -framerate 30 -i film/frame-%04d.png -pix_fmt yuv420p film.mp4)";

constexpr int kMostFrames = 10'000;  // four digits
constexpr int kGap = 8;              // pixels between two pictures that are compared

struct FilmOptions {
    std::string file;
    std::string folder;
    PictureOptions picture{.samples = 8};
    PlayOptions play;
    int steps = 0;
    int every = 1;
    bool isCompared = false;
    int threads = 1;
};

/// A session, and what draws it.
struct Take {
    Session session;
    std::unique_ptr<MomentBuilder> builder;
};

std::filesystem::path frameFile(const FilmOptions& options, int frame) {
    char name[32];
    std::snprintf(name, sizeof name, "frame-%04d.png", frame);
    return std::filesystem::path(options.folder) / name;
}

/// Without destruction and with it, where the two are compared; else one.
Result<std::vector<Take>> takesOf(const ProjectInPlay& play, const FilmOptions& options) {
    std::vector<Take> takes;
    std::vector<PlayOptions> plays{options.play};
    if (options.isCompared) {
        plays.insert(plays.begin(), options.play);
        plays.front().isUnbreakable = true;
    }
    for (const PlayOptions& one : plays) {
        Result<Session> session = startedSession(play, one, options.threads);
        if (!session) return session.error();
        takes.push_back(
            {std::move(*session), std::make_unique<MomentBuilder>(play.scene, sceneOptions(options.picture))});
        takes.back().builder->setOverlays(playOverlays(options.picture));
    }
    return takes;
}

/// The moment of all takes after so many steps, side by side.
Result<Image> frameOf(std::vector<Take>& takes, PictureMaker& maker, const PictureView& view, int samples,
                      std::uint64_t step, const CliContext& context, const TaskContext& task) {
    std::optional<Image> frame;
    for (Take& take : takes) {
        const auto moment = momentAfter(*take.builder, take.session, step, context, task);
        if (!moment) return moment.error();
        Result<Image> image = maker.pictureOf(*moment, view, samples, task);
        if (!image) return image.error();
        frame = frame ? besideEachOther(*frame, *image, kGap) : std::move(*image);
    }
    return std::move(*frame);
}

/// Refuses a folder in which the pictures of two films would be mixed.
Status unusedFolder(const FilmOptions& options) {
    std::error_code ignored;  // a folder that is not there has nothing in it
    for (const auto& entry : std::filesystem::directory_iterator(options.folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("frame-") || !name.ends_with(".png")) continue;
        return Error{ErrorCode::BadInput, options.folder + " holds a film already: " + name +
                                              ". Give another folder, or remove its pictures."};
    }
    return success();
}

Status shoot(std::vector<Take>& takes, const FilmOptions& options, const CliContext& context, const TaskContext& task) {
    Result<PictureMaker> maker = PictureMaker::made();
    if (!maker) return maker.error();
    const Box3 framed = withRoomToFall(boundsOf(*takes.front().builder->momentOf(takes.front().session)));
    const PictureView view = pictureView(options.picture, framed);
    const int frames = options.steps / options.every + 1;
    const TaskContext part{.cancel = task.cancel};
    for (int frame = 0; frame < frames; ++frame) {
        const auto step = static_cast<std::uint64_t>(frame) * static_cast<std::uint64_t>(options.every);
        const Result<Image> image = frameOf(takes, *maker, view, options.picture.samples, step, context, part);
        if (!image) return image.error();
        const Result<std::string> png = pngOf(*image);
        if (!png) return png.error();
        if (const Status written = writeFileAtomically(frameFile(options, frame), *png); !written) return written;
        task.report(static_cast<double>(frame + 1) / frames);
    }
    return success();
}

Status film(const FilmOptions& options, const CliContext& context) {
    const int frames = options.steps / options.every + 1;
    if (frames > kMostFrames) {
        return Error{ErrorCode::BadInput, "These are " + std::to_string(frames) + " pictures; a film can have " +
                                              std::to_string(kMostFrames) + ". --every takes fewer."};
    }
    TaskContext task{.cancel = context.cancel, .threads = options.threads};
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<ProjectInPlay> play = projectInPlay(*project, options.play, context, task);
    if (!play) return play.error();
    if (play->scene->project.instances.empty()) {
        return Error{ErrorCode::NotFound, "The project has no instance to film."};
    }
    Result<std::vector<Take>> takes = takesOf(*play, options);
    if (!takes) return takes.error();
    if (const Status unused = unusedFolder(options); !unused) return unused;
    MadeFolders folders;
    if (const Status made = folders.make(options.folder); !made) return made;
    ProgressLine line(context, "Filming");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const Status shot = shoot(*takes, options, context, task);
    line.clear();
    if (!shot) return shot;
    return writeOutput("-", std::to_string(frames) + " pictures in " + options.folder + "\n", context);
}

}  // namespace

Verb addFilm(CLI::App& program) {
    CLI::App* command = program.add_subcommand("film", "Draw a project in play as a sequence of PNG pictures");
    const auto options = std::make_shared<FilmOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    command->add_option("FOLDER", options->folder, "Where to write the pictures; made where it is not there")
        ->required()
        ->type_name("");
    command->add_option("--steps", options->steps, "How many steps to play")
        ->required()
        ->check(numberBetween(0, kMostSteps))
        ->option_text("N");
    command->add_option("--every", options->every, "Steps from picture to picture: 1 if not given")
        ->check(numberBetween(1, kMostSteps))
        ->option_text("K");
    addPlayOptions(*command, options->play);
    command->add_flag("--compare", options->isCompared, "Without destruction and with it, side by side")
        ->option_text(" ");  // or CLI11 tells of --no-destruction there
    command->get_option("--compare")->excludes(command->get_option("--no-destruction")->option_text(" "));
    addViewOptions(*command, options->picture);
    addLookOptions(*command, options->picture);
    addOverlayOption(*command, options->picture);
    addSamplesOption(*command, options->picture);
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return film(*options, context); }};
}

}  // namespace rubble
