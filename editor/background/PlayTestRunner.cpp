#include "editor/background/PlayTestRunner.h"

#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "editor/document/FilePath.h"

#include <algorithm>
#include <utility>

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
    : QObject(parent), m_document(document), m_file(file), m_bakes(bakes) {
    connect(&document, &Document::changed, this, &PlayTestRunner::discard);
    connect(&m_job, &BackgroundJob::progressed, this, &PlayTestRunner::progressed);
    connect(&m_job, &BackgroundJob::failed, this, [this](const QString& sentence) {
        emit changed();
        emit statusMessage(sentence);
    });
}

void PlayTestRunner::discard() {
    cancel();
    if (m_outcomes.empty()) return;
    m_outcomes.clear();
    emit changed();
}

void PlayTestRunner::cancel() {
    if (!isBusy()) return;
    m_job.cancel();
    emit changed();
}

const PlayTestOutcome* PlayTestRunner::outcomeOf(Id test) const {
    const auto found = m_outcomes.find(test);
    return found != m_outcomes.end() ? &found->second : nullptr;
}

int PlayTestRunner::passed() const {
    return static_cast<int>(
        std::ranges::count_if(m_outcomes, [](const auto& entry) { return entry.second.isPassed(); }));
}

int PlayTestRunner::failed() const { return static_cast<int>(m_outcomes.size()) - passed(); }

/// On copies, since the document may change meanwhile.
void PlayTestRunner::run(std::vector<Id> tests) {
    cancel();
    if (!m_bakes.areCurrent(m_document.project())) {
        return emit statusMessage(tr("Some assets are not baked yet; try again in a moment."));
    }
    for (const Id test : tests) m_outcomes.erase(test);
    m_job.start(
        [this, tests = std::move(tests), project = m_document.project(), bakes = m_bakes.assetBakes(),
         folder = toPath(m_file.path()).parent_path()](const TaskContext& task, const BackgroundJob::Post& post) {
            const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task);
            const auto count = static_cast<double>(tests.size());
            for (std::size_t k = 0; k < tests.size() && !task.isCancelled(); ++k) {
                const auto test = std::ranges::find(project.playTests, tests[k], &PlayTest::id);
                if (test == project.playTests.end()) continue;
                const TaskContext stage =
                    task.stage(static_cast<double>(k) / count, static_cast<double>(k + 1) / count);
                const Result<PlayTestOutcome> outcome =
                    scene ? outcomeIn(folder, *scene, *test, stage) : Result<PlayTestOutcome>(scene.error());
                post([this, outcome] { add(outcome); });
                if (!outcome) return false;
            }
            return true;
        },
        [this](bool) { emit changed(); });
    emit changed();
    emit progressed(0.0);
}

void PlayTestRunner::add(const Result<PlayTestOutcome>& outcome) {
    if (!outcome) return emit statusMessage(QString::fromStdString(outcome.error().message));
    m_outcomes.insert_or_assign(outcome->test, *outcome);
    emit changed();
}

}  // namespace rubble

#include "moc_PlayTestRunner.cpp"
