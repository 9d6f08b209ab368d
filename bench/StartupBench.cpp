// Measures the time from process start to a window that shows the house, compared with an empty Qt window. Needs a
// display.
#include "editor/window/MainWindow.h"
#include "editor/window/Program.h"
#include "viewport/widget/ViewportWidget.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>

namespace {

constexpr int kRuns = 15;
constexpr QSize kWindow{1440, 900};           // the editor's default size
constexpr int kTimeoutMilliseconds = 60'000;  // milliseconds; longer runs have failed

/// The stages of a window, in order.
enum class Stage { Painted, Complete };
constexpr std::array kNames = {"painted", "complete"};
using Times = std::array<double, kNames.size()>;  // ms

void report(Stage stage) {
    std::puts(kNames[static_cast<std::size_t>(stage)]);
    std::fflush(stdout);
}

/// Calls a function after a widget's first paint, when the queued events are processed.
class FirstPaint : public QObject {
public:
    FirstPaint(QWidget* widget, std::function<void()> then) : QObject(widget), m_then(std::move(then)) {
        widget->installEventFilter(this);
    }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::Paint) QTimer::singleShot(0, this, std::exchange(m_then, [] {}));
        return false;
    }

private:
    std::function<void()> m_then;
};

int showEmpty() {
    QWidget window;
    window.resize(kWindow);
    new FirstPaint(&window, [] {
        report(Stage::Painted);
        report(Stage::Complete);
        QCoreApplication::exit();
    });
    window.show();
    return QApplication::exec();
}

/// Waits until all assets are baked and the 3D view has drawn them.
void tellWhenComplete(rubble::MainWindow& window) {
    auto* view = window.findChild<rubble::ViewportWidget*>();
    const auto finish = [&window, view] {
        if (window.workspace().baker().isBusy()) return;
        // The scene is updated before the next frame.
        QTimer::singleShot(0, view, [view] {
            while (!view->isPictureCurrent()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            report(Stage::Complete);
            QCoreApplication::exit();
        });
    };
    if (!view->errorText().isEmpty()) {
        std::fputs("StartupBench: there is no OpenGL on this display.\n", stderr);
        return QCoreApplication::exit(1);
    }
    QObject::connect(&window.workspace().baker(), &rubble::Baker::progressed, view, finish);
    finish();
}

int showHouse(const QString& project) {
    rubble::Program program;
    program.start({project});
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        auto* window = qobject_cast<rubble::MainWindow*>(widget);
        if (!window) continue;
        new FirstPaint(window->centralWidget(), [window] {
            report(Stage::Painted);
            tellWhenComplete(*window);
        });
    }
    return QApplication::exec();
}

/// The times from process start to each stage; nothing on failure.
std::optional<Times> timesOf(const QStringList& arguments) {
    QElapsedTimer timer;
    timer.start();
    QProcess child;
    child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    child.start(QCoreApplication::applicationFilePath(), arguments);
    Times times;
    for (std::size_t stage = 0; stage < kNames.size(); ++stage) {
        while (!child.canReadLine()) {
            if (!child.waitForReadyRead(kTimeoutMilliseconds)) return std::nullopt;
        }
        times[stage] = static_cast<double>(timer.nsecsElapsed()) / 1e6;
        if (child.readLine().trimmed() != kNames[stage]) return std::nullopt;
    }
    child.waitForFinished();
    return times;
}

double median(const std::vector<Times>& runs, Stage stage) {
    std::vector<double> times;
    for (const Times& run : runs) times.push_back(run[static_cast<std::size_t>(stage)]);
    std::ranges::nth_element(times, times.begin() + kRuns / 2);
    return times[kRuns / 2];
}

int compare(const QString& project) {
    std::vector<Times> empty, house;
    // Alternating, so that disturbances affect both; the first run of each only warms the disk cache.
    for (int run = -1; run < kRuns; ++run) {
        const std::optional<Times> ofEmpty = timesOf({"--empty"}), ofHouse = timesOf({"--house", project});
        if (!ofEmpty || !ofHouse) {
            std::fputs("StartupBench: a window was not shown.\n", stderr);
            return 1;
        }
        if (run < 0) continue;
        empty.push_back(*ofEmpty);
        house.push_back(*ofHouse);
    }
    std::puts("\n| from the start of the process to | empty Qt window, ms | editor, ms | difference, ms |");
    std::puts("| --- | --- | --- | --- |");
    const auto print = [&](const char* what, Stage stage) {
        const double base = median(empty, stage), editor = median(house, stage);
        std::printf("| %s | %.0f | %.0f | %.0f |\n", what, base, editor, editor - base);
    };
    print("a window that is painted and answers", Stage::Painted);
    print("all pieces baked and drawn", Stage::Complete);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    QApplication::setOrganizationName("RubbleBench");
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() == 2 && arguments[1] == "--empty") return showEmpty();
    if (arguments.size() == 3 && arguments[1] == "--house") return showHouse(arguments[2]);
    if (arguments.size() == 2) return compare(arguments[1]);
    std::fputs("usage: StartupBench PROJECT\n", stderr);
    return 2;
}
