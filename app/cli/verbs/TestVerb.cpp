#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PictureOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/io/json/JsonWriter.h"
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

/// A test that was run, and the picture of its failure.
struct RunTest {
    TimedPlayTest timed;
    std::string picture;  // empty: none
};

std::string resultText(const PlayTestOutcome& outcome) {
    std::string text = (outcome.isPassed() ? "ok      " : "FAILED  ") + shownName(outcome.name) + '\n';
    for (const ExpectationOutcome& expectation : outcome.expectations) {
        if (!expectation.isMet) text += "        " + expectation.expected + ": " + expectation.seen + '\n';
    }
    return text;
}

/// Renders the moment at which a test failed. Returns the picture's path.
Result<std::string> renderFailure(const std::shared_ptr<const PlayScene>& scene, const PlayTest& test,
                                  const SavedSession* start, const PlayTestOutcome& outcome, const TestOptions& options,
                                  const CliContext& context) {
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
    if (const Status created = folders.create(options.pictures); !created) return created.error();
    const std::string file =
        (std::filesystem::path(options.pictures) / ("play-test-" + std::to_string(test.id) + ".png")).string();
    if (const Status written = writeFileAtomically(file, *png); !written) return written.error();
    return file;
}

Result<std::vector<RunTest>> runTests(const Project& project, const std::vector<PlayTest>& tests,
                                      const TestOptions& options, const VerbReport& report, const CliContext& context) {
    if (tests.empty()) return std::vector<RunTest>();
    const Result<std::shared_ptr<const PlayScene>> scene =
        playScene(project, {.cancel = context.cancel, .threads = options.threads});
    if (!scene) return scene.error();
    const std::filesystem::path folder = std::filesystem::path(options.file).parent_path();
    std::vector<RunTest> done;
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
        const auto print = outcome->isPassed() ? printSummary : printResult;
        if (const Status written = print(resultText(*outcome), report, context); !written) return written.error();
        std::string picture;
        if (!outcome->isPassed() && !options.pictures.empty()) {
            const Result<std::string> rendered = renderFailure(*scene, test, state->get(), *outcome, options, context);
            if (!rendered) return rendered.error();
            picture = *rendered;
            const std::string reported =
                "        after step " + std::to_string(outcome->failedAt()) + ": " + picture + '\n';
            if (const Status written = printResult(reported, report, context); !written) return written.error();
        }
        done.push_back({{std::move(*outcome), passed.count()}, std::move(picture)});
    }
    return done;
}

void writeTest(JsonWriter& json, const RunTest& run) {
    const PlayTestOutcome& outcome = run.timed.outcome;
    json.openObject();
    json.text("name", printableText(outcome.name));
    json.boolean("passed", outcome.isPassed());
    json.wholeNumber("steps", outcome.steps);
    if (!outcome.isPassed()) json.wholeNumber("failedAt", outcome.failedAt());
    if (!run.picture.empty()) json.text("picture", printableText(run.picture));
    json.openArray("expectations");
    for (const ExpectationOutcome& expectation : outcome.expectations) {
        json.openObject({}, JsonLayout::Inline);
        json.text("expected", printableText(expectation.expected));
        json.boolean("met", expectation.isMet);
        json.text("seen", printableText(expectation.seen));
        json.close();
    }
    json.close();
    json.close();
}

/// Reports the results of the tests, and their failures as findings.
void reportTests(const std::vector<RunTest>& done, const std::string& file, VerbReport& report) {
    std::size_t failed = 0;
    for (const RunTest& run : done) {
        const PlayTestOutcome& outcome = run.timed.outcome;
        for (const ExpectationOutcome& expectation : outcome.expectations) {
            if (expectation.isMet) continue;
            report.findings.push_back({Severity::Error,
                                       "FailedTest",
                                       {.file = file, .test = outcome.name},
                                       expectation.expected + ": " + expectation.seen + "."});
        }
        if (!outcome.isPassed()) ++failed;
    }
    report.writeResults = [done](JsonWriter& json) { json.list("tests", done, writeTest); };
    if (failed > 0) conclude(report, std::to_string(failed) + " of " + std::to_string(done.size()) + " tests failed.");
}

Status writeJUnit(const std::vector<RunTest>& done, const TestOptions& options, const CliContext& context) {
    std::vector<TimedPlayTest> tests;
    for (const RunTest& run : done) tests.push_back(run.timed);
    const std::string suite = std::filesystem::path(options.file).stem().string();
    return writeOutput(options.junit, junitXml(suite, tests), context);
}

Status test(const TestOptions& options, VerbReport& report, const CliContext& context) {
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    const Result<std::vector<PlayTest>> tests = selectedTests(*project, options.names);
    if (!tests) return tests.error();
    if (tests->empty()) context.err << "The project has no tests.\n";
    const Result<std::vector<RunTest>> done = runTests(*project, *tests, options, report, context);
    if (!done) return done.error();
    reportTests(*done, options.file, report);
    return options.junit.empty() ? success() : writeJUnit(*done, options, context);
}

}  // namespace

Verb addTest(CLI::App& program) {
    Command command(program, "test", "Run the tests of a project", kTestFooter);
    const auto options = std::make_shared<TestOptions>();
    addProjectArgument(command, options->file);
    command.option("--test", options->names, "Run only this test; repeatable").repeatable().valueName("NAME");
    command.option("--junit", options->junit, "Write a report as JUnit XML").writes({".xml"}).valueName("FILE.xml");
    command.option("--pictures", options->pictures, "Render the moment of each failure into this folder")
        .valueName("FOLDER");
    command.addReportFlag();
    addThreadsOption(command, options->threads);
    return {command,
            [options](VerbReport& report, const CliContext& context) { return test(*options, report, context); }};
}

}  // namespace rubble
