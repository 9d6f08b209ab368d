#include "editor/background/PlayTestRunner.h"

#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "editor/document/FilePath.h"

#include <algorithm>

namespace rubble {

namespace {

/// Plays a test of a project in a folder.
Result<PlayTestOutcome> outcomeIn(const std::filesystem::path& folder, const std::shared_ptr<const PlayScene>& scene,
                                  const PlayTest& test, const TaskContext& task) {
    const auto state = loadStart(test, folder, sceneHash(scene->project));
    if (!state) return state.error();
    return runPlayTest(scene, test, {.threads = task.threads}, task, state->get());
}

}  // namespace

PlayTestRunner::PlayTestRunner(const Document& document, const DocumentFile& file, const Bakes& bakes, QObject* parent)
    : Derived({document, kEveryPart, "running tests", nullptr, OnChange::Discard}, {}, parent),
      m_file(file),
      m_bakes(bakes) {}

const PlayTestOutcome* PlayTestRunner::outcomeOf(Id test) const {
    const auto found = value().find(test);
    return found != value().end() ? &found->second : nullptr;
}

int PlayTestRunner::passedCount() const {
    return static_cast<int>(std::ranges::count_if(value(), [](const auto& entry) { return entry.second.isPassed(); }));
}

void PlayTestRunner::run(std::vector<Id> tests) {
    request([this, tests = std::move(tests)]() -> Result<Work> {
        if (!m_bakes.areCurrent(project())) {
            return Error{ErrorCode::NotFound,
                         tr("Some assets are not baked yet; try again in a moment.").toStdString()};
        }
        return Work(
            [tests, outcomes = value(), project = project(), bakes = m_bakes.assetBakes(),
             folder = toPath(m_file.path()).parent_path()](
                const TaskContext& task, const Publish& publish) mutable -> Result<std::map<Id, PlayTestOutcome>> {
                const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task);
                if (!scene) return scene.error();
                const auto count = static_cast<double>(tests.size());
                for (std::size_t k = 0; k < tests.size() && !task.isCancelled(); ++k) {
                    const auto test = std::ranges::find(project.playTests, tests[k], &PlayTest::id);
                    if (test == project.playTests.end()) continue;
                    const TaskContext stage =
                        task.stage(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
                    const Result<PlayTestOutcome> outcome = outcomeIn(folder, *scene, *test, stage);
                    outcomes.erase(test->id);
                    if (outcome) outcomes.emplace(test->id, *outcome);
                    publish(outcomes);
                    if (!outcome) return outcome.error();
                }
                return outcomes;
            });
    });
}

}  // namespace rubble
