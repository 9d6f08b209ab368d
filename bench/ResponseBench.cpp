// Measures how the window responds while its 3D view draws a project, on a display: the time until the project is open
// and drawn sharply, the pictures a second while the camera orbits, the time until a selection is seen, and in play,
// with a blast that breaks much, the pictures a second and the time until a step that was sought is seen. Beside each
// the longest time in which the window did not respond, and the peak memory.
//
//   ResponseBench PROJECT [STEPS]    STEPS of play; none by default
#include "editor/document/Document.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <QTimer>

#include <sys/resource.h>

#include <cstdio>
#include <functional>

using namespace rubble;

namespace {

constexpr QSize kView{1280, 720};  // the 3D view's
constexpr int kMotionMilliseconds = 6'000;
constexpr int kPointerMilliseconds = 8;     // from one event of a pointer to the next
constexpr int kWarmUpMilliseconds = 3'000;  // until the quality fits

/// The processor time of the process, s.
double processorTime() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Handles events, and measures the longest time that one took.
class EventLoop {
public:
    void runUntil(const std::function<bool()>& isDone) {
        m_longest = 0;
        while (!isDone()) handleOne();
    }
    void runFor(int milliseconds) {
        QElapsedTimer timer;
        timer.start();
        runUntil([&] { return timer.elapsed() > milliseconds; });
    }
    /// Of the last run, ms.
    double longest() const { return 1e-6 * static_cast<double>(m_longest); }

private:
    void handleOne() {
        QElapsedTimer timer;
        timer.start();
        QCoreApplication::processEvents();
        m_longest = std::max(m_longest, timer.nsecsElapsed());
        QThread::msleep(1);
    }
    qint64 m_longest = 0;  // ns
};

class Measurement {
public:
    explicit Measurement(const QString& project) {
        m_cpu = processorTime();
        m_timer.start();
        m_window = m_program.open(project);
    }

    bool isOpen() const { return m_window != nullptr; }

    void measureAll(int steps) {
        std::printf("| act | time, s | processor time, s | pictures/s | longest event, ms |\n");
        std::printf("| --- | --- | --- | --- | --- |\n");
        setViewSize();
        Workspace& workspace = m_window->workspace();
        m_loop.runUntil([&] { return workspace.bakes().areCurrent(workspace.project()) && view().isPictureCurrent(); });
        report("open");
        setViewSize();  // of the arrangement of the project
        restart();
        m_loop.runUntil([&] { return view().isPictureFinished(); });
        report("refine");
        moving("orbit", [this] { view().setCamera(orbited(view().camera(), 0.01, 0.0)); });
        m_loop.runUntil([&] { return view().isPictureFinished(); });
        restart();
        workspace.selection().setInstances(workspace.project(), {workspace.project().instances.front().id});
        m_loop.runFor(1);  // the scene follows
        m_loop.runUntil([&] { return view().isPictureCurrent(); });
        report("select");
        if (steps > 0) play(static_cast<std::uint64_t>(steps));
        rusage used{};
        getrusage(RUSAGE_SELF, &used);
        std::printf("view of %d x %d, peak memory %ld MiB\n", view().width(), view().height(), used.ru_maxrss / 1024);
        std::fflush(stdout);
    }

private:
    /// The window's size follows, which other views share.
    void setViewSize() {
        constexpr int kRounds = 12;
        for (int round = 0; round < kRounds && view().size() != kView; ++round) {
            m_window->resize(m_window->size() + kView - view().size());
            m_loop.runFor(1);
        }
    }
    ViewportWidget& view() { return m_window->views().scene().viewport(); }

    void restart() {
        m_cpu = processorTime();
        m_timer.start();
    }
    void report(const char* act, double pictures = 0.0) {
        std::printf("| %s | %.2f | %.2f | %.1f | %.0f |\n", act, 1e-3 * static_cast<double>(m_timer.elapsed()),
                    processorTime() - m_cpu, pictures, m_loop.longest());
        std::fflush(stdout);
    }
    /// Changes something as often as a pointer moves.
    void moving(const char* act, const std::function<void()>& change) {
        int pictures = 0;
        const auto counting = QObject::connect(&view(), &ViewportWidget::drawn, qApp, [&] { ++pictures; });
        QTimer pointer;
        if (change) {
            QObject::connect(&pointer, &QTimer::timeout, qApp, change);
            pointer.start(kPointerMilliseconds);
        }
        m_loop.runFor(kWarmUpMilliseconds);
        pictures = 0;
        restart();
        m_loop.runFor(kMotionMilliseconds);
        report(act, 1000.0 * pictures / kMotionMilliseconds);
        QObject::disconnect(counting);
    }
    void play(std::uint64_t steps) {
        PlayController& play = m_window->workspace().play();
        restart();
        play.play();
        m_loop.runUntil([&] { return play.frame().has_value() && view().isPictureCurrent(); });
        report("start play");
        setViewSize();
        const Box3 bounds = boundsOf(view().scene());
        const Blast blast{.at = bounds.centre(), .impulse = 2e4, .radius = bounds.diagonal()};
        play.fire({.name = "blast", .action = blast});
        moving("play", {});
        m_loop.runUntil([&] { return play.frame()->step >= steps; });
        play.pause();
        m_loop.runFor(500);
        for (const std::uint64_t step : {steps / 2, steps / 4, steps - 1}) {
            restart();
            play.seek(step);
            m_loop.runUntil([&] { return play.frame()->step == step; });
            int pictures = 0;
            const auto counting = QObject::connect(&view(), &ViewportWidget::drawn, qApp, [&] { ++pictures; });
            m_loop.runUntil([&] { return pictures > 0; });
            QObject::disconnect(counting);
            report("seek");
            m_loop.runUntil([&] { return view().isPictureCurrent(); });
            report("seek, sharp");
        }
    }

    Program m_program;
    MainWindow* m_window = nullptr;
    EventLoop m_loop;
    QElapsedTimer m_timer;
    double m_cpu = 0.0;
};

}  // namespace

int main(int argc, char** argv) {
    QStandardPaths::setTestModeEnabled(true);
    QApplication program(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false);
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() < 2) return std::puts("usage: ResponseBench PROJECT [STEPS]"), 2;
    Measurement measurement(arguments[1]);
    if (!measurement.isOpen()) return std::puts("The project cannot be opened."), 1;
    measurement.measureAll(arguments.size() > 2 ? arguments[2].toInt() : 0);
    std::_Exit(0);  // the window would ask whether to save
}
