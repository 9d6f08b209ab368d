#include "editor/play/PlayTestRunner.h"

#include <QMetaObject>
#include <QThread>

#include <algorithm>

namespace rubble {

PlayTestRunner::PlayTestRunner(const Document& document, const Bakes& bakes, QObject* parent)
    : QObject(parent), m_document(document), m_bakes(bakes) {
    m_thread.setMaxThreadCount(1);
    connect(&document, &Document::changed, this, &PlayTestRunner::forget);
}

PlayTestRunner::~PlayTestRunner() {
    m_cancel.cancel();
    m_thread.waitForDone();
}

void PlayTestRunner::forget() {
    cancel();
    if (m_outcomes.empty()) return;
    m_outcomes.clear();
    emit changed();
}

void PlayTestRunner::cancel() {
    m_cancel.cancel();
    ++m_run;
    if (!std::exchange(m_isBusy, false)) return;
    emit changed();
}

const PlayTestOutcome* PlayTestRunner::outcomeOf(Id test) const {
    const auto found = m_outcomes.find(test);
    return found != m_outcomes.end() ? &found->second : nullptr;
}

int PlayTestRunner::passed() const {
    return static_cast<int>(std::ranges::count_if(m_outcomes, [](const auto& one) { return one.second.isPassed(); }));
}

int PlayTestRunner::failed() const { return static_cast<int>(m_outcomes.size()) - passed(); }

/// On copies: the document may change meanwhile.
void PlayTestRunner::run(std::vector<Id> tests) {
    cancel();
    if (!m_bakes.areCurrent(m_document.project())) return emit said(tr("Not all is baked yet; try again in a moment."));
    m_cancel = CancelToken();
    m_isBusy = true;
    emit changed();
    emit progressed(0.0);
    m_thread.start([this, run = m_run, tests = std::move(tests), project = m_document.project(),
                    bakes = m_bakes.assetBakes(), cancel = m_cancel] {
        const auto inWindow = [this](auto work) { QMetaObject::invokeMethod(this, work); };
        TaskContext task{.cancel = cancel, .threads = std::max(1, QThread::idealThreadCount())};
        const Result<std::shared_ptr<const PlayScene>> scene = playScene(project, bakes, task);
        for (std::size_t k = 0; k < tests.size() && !task.isCancelled(); ++k) {
            const auto test = std::ranges::find(project.playTests, tests[k], &PlayTest::id);
            if (test == project.playTests.end()) continue;
            const double share = 1.0 / static_cast<double>(tests.size());
            task.progress = [this, inWindow, run, share, done = static_cast<double>(k)](double fraction) {
                const double whole = (done + fraction) * share;
                inWindow([this, run, whole] {
                    if (run == m_run) emit progressed(whole);
                });
            };
            const SessionSettings settings{.threads = task.threads};
            const Result<PlayTestOutcome> outcome =
                scene ? runPlayTest(*scene, *test, settings, task) : Result<PlayTestOutcome>(scene.error());
            inWindow([this, run, outcome] { take(run, outcome); });
            if (!outcome) break;
        }
        inWindow([this, run] { finish(run); });
    });
}

void PlayTestRunner::take(int run, const Result<PlayTestOutcome>& outcome) {
    if (run != m_run) return;
    if (!outcome) return emit said(QString::fromStdString(outcome.error().message));
    m_outcomes.insert_or_assign(outcome->test, *outcome);
    emit changed();
}

void PlayTestRunner::finish(int run) {
    if (run != m_run) return;
    m_isBusy = false;
    emit changed();
}

}  // namespace rubble
