#include "app/cli/CommonOptions.h"
#include "app/cli/PictureOptions.h"
#include "app/cli/PlayOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/AtomicFile.h"
#include "core/io/JUnitXml.h"
#include "core/io/MadeFolders.h"
#include "core/io/ProjectFile.h"
#include "viewport/render/Picture.h"
#include "viewport/scene/MomentBuilder.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Plays each play-test that is saved in the project, with its shots, and says which expectations are met. Exit status 1 where
one is not.

Examples:
  rubble-cli test house.rubble
  rubble-cli test house.rubble --test "the house stands"
  rubble-cli test house.rubble --junit report.xml --pictures failures)";

constexpr int kSamples = 8;  // of a picture: it shows what went wrong, quickly

struct TestOptions {
    std::string file;
    std::vector<std::string> names;
    std::string junit;
    std::string pictures;  // the folder for those of failures; empty: none are taken
    int threads = 1;
};

/// The tests with these names, in the project's order; all where there is no name.
///
/// Errors: NotFound for a name that no test has, and where the project has no tests.
Result<std::vector<PlayTest>> chosenTests(const Project& project, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::ranges::find(project.playTests, name, &PlayTest::name) != project.playTests.end()) continue;
        return Error{ErrorCode::NotFound,
                     "The project has no play-test \"" + name + "\"; " + quotedNamesOf(project.playTests) + "."};
    }
    if (project.playTests.empty()) return Error{ErrorCode::NotFound, "The project has no play-tests."};
    std::vector<PlayTest> chosen;
    for (const PlayTest& test : project.playTests) {
        if (names.empty() || std::ranges::find(names, test.name) != names.end()) chosen.push_back(test);
    }
    return chosen;
}

std::string toldText(const PlayTestOutcome& outcome) {
    std::string text = (outcome.isPassed() ? "ok      " : "FAILED  ") + outcome.name + '\n';
    for (const ExpectationOutcome& one : outcome.expectations) {
        if (!one.isMet) text += "        " + one.expected + ": " + one.seen + '\n';
    }
    return text;
}

/// Draws the moment at which a test failed, and says where the picture lies.
Status drawFailure(const std::shared_ptr<const PlayScene>& scene, const PlayTest& test, const PlayTestOutcome& outcome,
                   const TestOptions& options, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    Result<Session> session = sessionOf(scene, test, {.threads = options.threads});
    if (!session) return session.error();
    MomentBuilder builder(scene);
    const Box3 framed = withRoomToFall(boundsOf(*builder.momentOf(*session)));
    if (const Status played = playTo(*session, outcome.failedAt(), context, task); !played) return played;
    const PictureOptions picture{.samples = kSamples};
    const Result<Image> image =
        pictureOf(builder.momentOf(*session), pictureView(picture, framed), picture.samples, task);
    if (!image) return image.error();
    const Result<std::string> png = pngOf(*image);
    if (!png) return png.error();
    MadeFolders folders;
    if (const Status made = folders.make(options.pictures); !made) return made;
    const std::string file =
        (std::filesystem::path(options.pictures) / ("play-test-" + std::to_string(test.id) + ".png")).string();
    if (const Status written = writeFileAtomically(file, *png); !written) return written;
    return writeOutput("-", "        after step " + std::to_string(outcome.failedAt()) + ": " + file + '\n', context);
}

Result<std::vector<TimedPlayTest>> runTests(const Project& project, const std::vector<PlayTest>& tests,
                                            const TestOptions& options, const CliContext& context) {
    const Result<std::shared_ptr<const PlayScene>> scene =
        playScene(project, {.cancel = context.cancel, .threads = options.threads});
    if (!scene) return scene.error();
    std::vector<TimedPlayTest> done;
    for (const PlayTest& test : tests) {
        ProgressLine line(context, "Playing \"" + test.name + '"');
        const auto start = std::chrono::steady_clock::now();
        Result<PlayTestOutcome> outcome =
            runPlayTest(*scene, test, {.threads = options.threads},
                        {.cancel = context.cancel, .progress = [&](double fraction) { line.show(fraction); }});
        line.clear();
        if (!outcome) return outcome.error();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (const Status written = writeOutput("-", toldText(*outcome), context); !written) return written.error();
        if (!outcome->isPassed() && !options.pictures.empty()) {
            const Status drawn = drawFailure(*scene, test, *outcome, options, context);
            if (!drawn) return drawn.error();
        }
        done.push_back({std::move(*outcome), passed.count()});
    }
    return done;
}

Status test(const TestOptions& options, const CliContext& context) {
    const Result<Project> project = loadProject(options.file);
    if (!project) return project.error();
    const Result<std::vector<PlayTest>> tests = chosenTests(*project, options.names);
    if (!tests) return tests.error();
    const Result<std::vector<TimedPlayTest>> done = runTests(*project, *tests, options, context);
    if (!done) return done.error();
    if (!options.junit.empty()) {
        const std::string suite = std::filesystem::path(options.file).stem().string();
        if (const Status written = writeOutput(options.junit, junitXml(suite, *done), context); !written)
            return written;
    }
    const auto failed = std::ranges::count_if(*done, [](const TimedPlayTest& one) { return !one.outcome.isPassed(); });
    if (failed == 0) return success();
    return Error{ErrorCode::BadInput,
                 std::to_string(failed) + " of " + std::to_string(done->size()) + " play-tests failed."};
}

}  // namespace

Verb addTest(CLI::App& program) {
    CLI::App* command = program.add_subcommand("test", "Run the play-tests that are saved in a project");
    const auto options = std::make_shared<TestOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project")->required()->type_name("");
    command->add_option("--test", options->names, "Only this play-test; may be given several times")
        ->expected(1)
        ->take_all()
        ->option_text("NAME");
    command->add_option("--junit", options->junit, "Write a report as JUnit XML")->option_text("FILE.xml");
    command->add_option("--pictures", options->pictures, "Draw the moment of each failure into this folder")
        ->option_text("FOLDER");
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return test(*options, context); }};
}

}  // namespace rubble
