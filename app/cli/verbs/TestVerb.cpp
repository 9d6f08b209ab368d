#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PictureOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/io/play/JUnitXml.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/CreatedDirectories.h"
#include "viewport/render/OffscreenRenderer.h"
#include "viewport/scene/play/SessionPlayback.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kTestFooter =
    R"(Runs the tests that are saved in the project, with their saved throws, and prints the expectations that are not
met. Exits with 3 if a test fails. A test may start from a state that lies beside the project.

Examples:
  rubble-cli test house.rubble
  rubble-cli test house.rubble --test "the house stands"
  rubble-cli test house.rubble --junit report.xml --pictures failures)";

constexpr int kSamples = 8;  // of a picture of a failure

struct TestOptions {
    std::string file;
    std::vector<std::string> names;
    std::string junit;
    std::string pictures;  // the folder for pictures of failures; empty: none
    int threads = 1;
};

/// Returns the tests with these names, in the project's order; all if `names` is empty.
///
/// Errors: NotFound if there is no test with a name.
Result<std::vector<PlayTest>> selectedTests(const Project& project, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::ranges::find(project.playTests, name, &PlayTest::name) != project.playTests.end()) continue;
        return Error{ErrorCode::NotFound,
                     "The project has no test " + quotedName(name) + "; " + quotedNamesOf(project.playTests) + "."};
    }
    std::vector<PlayTest> selected;
    for (const PlayTest& test : project.playTests) {
        if (names.empty() || std::ranges::find(names, test.name) != names.end()) selected.push_back(test);
    }
    return selected;
}

std::string resultText(const PlayTestOutcome& outcome) {
    std::string text = (outcome.isPassed() ? "ok      " : "FAILED  ") + shownName(outcome.name) + '\n';
    for (const ExpectationOutcome& expectation : outcome.expectations) {
        if (!expectation.isMet) text += "        " + expectation.expected + ": " + expectation.seen + '\n';
    }
    return text;
}

/// Renders the moment at which a test failed and prints the picture's path.
Status renderFailure(const std::shared_ptr<const PlayScene>& scene, const PlayTest& test, const SavedSession* start,
                     const PlayTestOutcome& outcome, const TestOptions& options, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    Result<Session> session = sessionOf(scene, test, {.threads = options.threads}, start);
    if (!session) return session.error();
    SessionPlayback playback(scene, std::move(*session));
    const Box3 framed = withSpaceForDebris(boundsOf(*playback.scene()));
    const auto failed = playback.sceneAtStep(outcome.failedAt(), task);
    if (!failed) return failed.error();
    printWarnings(playback, context);
    const PictureOptions picture{.samples = kSamples};
    const Result<Image> image = renderImage(*failed, pictureView(picture, framed), picture.samples, task);
    if (!image) return image.error();
    const Result<std::string> png = pngOf(*image);
    if (!png) return png.error();
    CreatedDirectories folders;
    if (const Status created = folders.create(options.pictures); !created) return created;
    const std::string file =
        (std::filesystem::path(options.pictures) / ("play-test-" + std::to_string(test.id) + ".png")).string();
    if (const Status written = writeFileAtomically(file, *png); !written) return written;
    return printText("        after step " + std::to_string(outcome.failedAt()) + ": " + file + '\n', context);
}

Result<std::vector<TimedPlayTest>> runTests(const Project& project, const std::vector<PlayTest>& tests,
                                            const TestOptions& options, const CliContext& context) {
    if (tests.empty()) return std::vector<TimedPlayTest>();
    const Result<std::shared_ptr<const PlayScene>> scene =
        playScene(project, {.cancel = context.cancel, .threads = options.threads});
    if (!scene) return scene.error();
    const std::filesystem::path folder = std::filesystem::path(options.file).parent_path();
    std::vector<TimedPlayTest> done;
    for (const PlayTest& test : tests) {
        const auto state = loadStart(test, folder, sceneHash(project));
        if (!state) return state.error();
        ProgressLine line(context, "Playing " + quotedName(test.name));
        const auto start = std::chrono::steady_clock::now();
        Result<PlayTestOutcome> outcome = runPlayTest(
            *scene, test, {.threads = options.threads},
            {.cancel = context.cancel, .progress = [&](double fraction) { line.show(fraction); }}, state->get());
        line.clear();
        if (!outcome) return outcome.error();
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (const Status written = printText(resultText(*outcome), context); !written) return written.error();
        if (!outcome->isPassed() && !options.pictures.empty()) {
            const Status rendered = renderFailure(*scene, test, state->get(), *outcome, options, context);
            if (!rendered) return rendered.error();
        }
        done.push_back({std::move(*outcome), passed.count()});
    }
    return done;
}

Status test(const TestOptions& options, VerbReport& report, const CliContext& context) {
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    const Result<std::vector<PlayTest>> tests = selectedTests(*project, options.names);
    if (!tests) return tests.error();
    if (tests->empty()) context.err << "The project has no tests.\n";
    const Result<std::vector<TimedPlayTest>> done = runTests(*project, *tests, options, context);
    if (!done) return done.error();
    if (!options.junit.empty()) {
        const std::string suite = std::filesystem::path(options.file).stem().string();
        if (const Status written = writeOutput(options.junit, junitXml(suite, *done), context); !written)
            return written;
    }
    const auto failed =
        std::ranges::count_if(*done, [](const TimedPlayTest& test) { return !test.outcome.isPassed(); });
    if (failed > 0)
        addFinding(report, std::to_string(failed) + " of " + std::to_string(done->size()) + " tests failed.");
    return success();
}

}  // namespace

Verb addTest(CLI::App& program) {
    Command command(program, "test", "Run the tests of a project", kTestFooter);
    const auto options = std::make_shared<TestOptions>();
    addProjectArgument(command, options->file);
    command.option("--test", options->names, "Run only this test; repeatable").repeatable().valueName("NAME");
    command.option("--junit", options->junit, "Write a report as JUnit XML").valueName("FILE.xml");
    command.option("--pictures", options->pictures, "Render the moment of each failure into this folder")
        .valueName("FOLDER");
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return test(*options, report, context); }};
}

}  // namespace rubble
