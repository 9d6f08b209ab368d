// Measures what one act costs the thread of the window with an asset of many fragments, drawing in the 3D view not
// included: select all, merge, undo, colour, explode; and what the journal costs it after an edit of as many placed
// seeds. Runs without a display; its 3D view has no OpenGL.
//
//   WindowBench [FRAGMENTS]...
#include "bench/BoxAssets.h"
#include "editor/document/UnrecordedEdits.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QSettings>
#include <QSlider>
#include <QStandardPaths>

#include <sys/resource.h>

#include <cstdio>
#include <functional>
#include <thread>

using namespace rubble;

namespace {

constexpr int kMerged = 850;

/// The processor time of the calling thread, or of the whole process, ms.
double processorTime(int whose = RUSAGE_THREAD) {
    rusage used{};
    getrusage(whose, &used);
    const auto milliseconds = [](const timeval& time) {
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
    };
    return milliseconds(used.ru_utime) + milliseconds(used.ru_stime);
}

class WindowSession {
public:
    explicit WindowSession(std::uint32_t fragments) : m_window(*m_program.showProject(bench::wallProject(fragments))) {
        m_window.setAttribute(Qt::WA_DeleteOnClose, false);
        m_window.resize(1440, 900);
        settle();
    }
    ~WindowSession() { delete &m_window; }

    void measureAll() {
        measure("select all", [this] { trigger("select-all"); });
        measure("select none", [this] { trigger("select-none"); });
        measure("select 850", [this] { selectSome(); });
        measure("merge", [this] { trigger("fragment-merge"); });
        measure("undo", [this] { stack().undo(); });
        measure("redo", [this] { stack().redo(); });
        measure("undo again", [this] { stack().undo(); });
        measure("select none", [this] { trigger("select-none"); });
        measureJournal();
        auto* colouring = m_window.findChild<QComboBox*>("colouring");
        measure("colour by volume", [&] { colouring->setCurrentIndex(3); });
        auto* exploded = m_window.findChild<QSlider*>("exploded");
        for (const int value : {10, 20, 30}) measure("explode", [&] { exploded->setValue(value); });
        measure("select all, exploded", [this] { trigger("select-all"); });
    }

private:
    QUndoStack& stack() { return m_window.workspace().document().undoStack(); }
    void trigger(const char* name) { m_window.findChild<QAction*>(name)->trigger(); }

    /// What the window's thread does for the journal of one edit; its record is made and written in the background.
    void measureJournal() {
        constexpr int kRounds = 100;
        const auto count = m_window.workspace().bakes().findPattern(2)->seeds.ids.size();
        Project project;
        project.assets = {bench::boxAsset(bench::seedSets(count).front())};
        const Changes changes{.list = {{Part::Asset, project.assets.front().id}}};
        UnrecordedEdits edits;
        const double start = processorTime();
        for (int round = 0; round < kRounds; ++round) {
            edits.note(changes);
            edits.take(project);
        }
        std::printf("| note an edit | %.3f | | |\n", (processorTime() - start) / kRounds);
    }

    void selectSome() {
        const auto pattern = m_window.workspace().bakes().findPattern(2);
        Selection::Seeds seeds;
        for (std::uint32_t k = 0; k < kMerged; ++k) seeds.insert(pattern->seeds.ids[k]);
        m_window.workspace().selection().setSeeds(seeds);
    }

    /// Handles events until everything is baked and nothing is left to do.
    void settle() {
        Workspace& workspace = m_window.workspace();
        do {
            QCoreApplication::processEvents();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        } while (!workspace.bakes().areCurrent(workspace.project()));
        for (int k = 0; k < 50; ++k) {
            QCoreApplication::processEvents();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    }

    void measure(const char* name, const std::function<void()>& act) {
        const double start = processorTime(), all = processorTime(RUSAGE_SELF);
        act();
        const double acted = processorTime();
        settle();
        const double end = processorTime();
        std::printf("| %s | %.0f | %.0f | %.0f |\n", name, acted - start, end - start,
                    processorTime(RUSAGE_SELF) - all);
        std::fflush(stdout);
    }

    Program m_program;
    MainWindow& m_window;
};

}  // namespace

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QStandardPaths::setTestModeEnabled(true);
    QApplication program(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    std::vector<std::uint32_t> counts;
    for (const QString& argument : QApplication::arguments().mid(1)) counts.push_back(argument.toUInt());
    if (counts.empty()) counts = {10'000, 50'000};
    for (const std::uint32_t count : counts) {
        std::printf("| %u fragments | act, ms | with what follows, ms | all threads, ms |\n| --- | --- | --- | --- |\n",
                    count);
        WindowSession(count).measureAll();
    }
    return 0;
}
