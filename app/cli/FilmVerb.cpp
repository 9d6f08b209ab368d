#include "app/cli/CommonOptions.h"
#include "app/cli/PictureOptions.h"
#include "app/cli/PlayOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/FilmFile.h"
#include "core/io/PictureSequence.h"
#include "core/io/ProjectFile.h"
#include "viewport/film/Film.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Plays a project and draws it at a step and every so many steps after it, seen from one place. Pictures are named
FOLDER/frame-0000.png and so on; each is written whole or not at all, and a sequence that is stopped keeps those it has. A
folder that holds such pictures is refused. Where ffmpeg is installed, FILM.mp4 (or .mkv, .mov, .webm) makes a film of
them, whole or not at all. With --compare each picture shows the same moment twice, side by side: without destruction on
the left, with it on the right, each in --size.

Examples:
  rubble-cli film house.rubble hit.mp4 --steps 300 --shot "block under the roof"
  rubble-cli film house.rubble slow.mp4 --from 40 --steps 120 --rate 12 --shot "block under the roof"
  rubble-cli film house.rubble both --steps 120 --every 2 --compare --size 640x480 --shot "box at the door")";

constexpr double kMostPicturesASecond = 240.0;  // pictures a second; no screen shows more

struct FilmOptions {
    std::string file;
    std::string place;
    PictureOptions picture{.samples = 8};
    PlayOptions play;
    int first = 0;
    int steps = 0;
    int every = 1;
    std::optional<double> rate;  // pictures a second; else as fast as it was played
    bool isCompared = false;
    int threads = 1;
};

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
        takes.emplace_back(play.scene, std::move(*session), std::vector<TimedInput>(), sceneOptions(options.picture),
                           playOverlays(options.picture));
    }
    return takes;
}

Result<FilmPlan> planOf(const FilmOptions& options) {
    if (options.first > options.steps) {
        return Error{ErrorCode::BadInput, "The film would begin at step " + std::to_string(options.first) +
                                              " and end at step " + std::to_string(options.steps) + "."};
    }
    const int pictures = picturesBetween(options.first, options.steps, options.every);
    if (pictures > kMostPictures) {
        return Error{ErrorCode::BadInput, "These are " + std::to_string(pictures) + " pictures; a film can have " +
                                              std::to_string(kMostPictures) + ". --every takes fewer."};
    }
    const double asPlayed = 1.0 / (options.play.stepLength * options.every);
    return FilmPlan{.samples = options.picture.samples,
                    .first = static_cast<double>(options.first),
                    .every = static_cast<double>(options.every),
                    .pictures = pictures,
                    .rate = options.rate.value_or(std::min(asPlayed, kMostPicturesASecond))};
}

Status film(const FilmOptions& options, const CliContext& context) {
    Result<FilmPlan> plan = planOf(options);
    if (!plan) return plan.error();
    const bool isFilm = isFilmPath(options.place);
    if (isFilm && !ffmpegProgram()) {
        return Error{ErrorCode::NotFound,
                     "There is no ffmpeg on this machine to make a film with; give a folder to get its pictures."};
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
    plan->view = pictureView(options.picture, withRoomToFall(boundsOf(*takes->front().moment())));
    ProgressLine line(context, "Filming");
    task.progress = [&line](double fraction) { line.show(fraction); };
    const Status shot = isFilm ? filmFile(*takes, *plan, options.place, task)
                               : filmPictures(*takes, *plan, options.place, Unfinished::Kept, task);
    line.clear();
    for (Take& take : *takes) tellNotices(take, context);
    if (!shot) return shot;
    return writeOutput("-", std::to_string(plan->pictures) + " pictures in " + options.place + "\n", context);
}

}  // namespace

Verb addFilm(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("film", "Draw a project in play as a sequence of PNG pictures, or a film");
    const auto options = std::make_shared<FilmOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    command
        ->add_option("FOLDER", options->place, "Where to write the pictures, made where it is not there; or FILM.mp4")
        ->required()
        ->type_name("");
    command->add_option("--from", options->first, "The step of the first picture: 0 if not given")
        ->check(numberBetween(0, kMostSteps))
        ->option_text("STEP");
    command->add_option("--steps", options->steps, "How many steps to play")
        ->required()
        ->check(numberBetween(0, kMostSteps))
        ->option_text("N");
    command->add_option("--every", options->every, "Steps from picture to picture: 1 if not given")
        ->check(numberBetween(1, kMostSteps))
        ->option_text("K");
    command->add_option("--rate", options->rate, "Pictures a second, of a film: as fast as it was played if not given")
        ->check(numberBetween(1.0, kMostPicturesASecond))
        ->option_text("N");
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
