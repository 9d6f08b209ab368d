// How long the editor takes from the start of its process to a window with the house that has been painted and answers,
// beside an empty Qt window. Needs a display, or Xvfb.
#include "core/asset/StarterProject.h"
#include "editor/MainWindow.h"
#include "editor/Program.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>

#include <algorithm>
#include <cstdio>

namespace {

constexpr int kRuns = 7;
constexpr const char* kReady = "ready\n";

/// Tells when the window was painted first and nothing waits to be done any more.
class FirstPaint : public QObject {
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::Paint || m_isTold) return false;
        m_isTold = true;
        QTimer::singleShot(0, [] {
            std::fputs(kReady, stdout);
            std::fflush(stdout);
            QCoreApplication::exit();
        });
        return false;
    }

private:
    bool m_isTold = false;
};

int showEmpty() {
    QWidget window;
    window.resize(1440, 900);
    FirstPaint paint;
    window.installEventFilter(&paint);
    window.show();
    return QApplication::exec();
}

int showHouse(const QString& project) {
    rubble::Program program;
    FirstPaint paint;
    rubble::MainWindow* window = program.open(project);
    window->centralWidget()->installEventFilter(&paint);
    return QApplication::exec();
}

/// Milliseconds from the start of a process to its window; the least of several, as other work only adds time.
double millisecondsOf(const QStringList& arguments) {
    double least = 1e300;
    for (int run = 0; run < kRuns; ++run) {
        QElapsedTimer timer;
        timer.start();
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(), arguments);
        while (child.waitForReadyRead() && !child.canReadLine()) {
        }
        least = std::min(least, static_cast<double>(timer.nsecsElapsed()) / 1e6);
        child.waitForFinished();
    }
    return least;
}

}  // namespace

int main(int argc, char** argv) {
    QStandardPaths::setTestModeEnabled(true);
    QApplication application(argc, argv);
    QApplication::setOrganizationName("RubbleBench");
    const QStringList arguments = QApplication::arguments();
    if (arguments.size() == 2 && arguments[1] == "--empty") return showEmpty();
    if (arguments.size() == 3 && arguments[1] == "--house") return showHouse(arguments[2]);
    if (arguments.size() != 2) {
        std::fputs("usage: StartupBench PROJECT\n", stderr);
        return 2;
    }
    const double empty = millisecondsOf({"--empty"});
    const double house = millisecondsOf({"--house", arguments[1]});
    std::printf(
        "\n| window | ms to its first picture |\n| --- | --- |\n| empty Qt window | %.0f |\n| editor with %s | %.0f |\n"
        "| difference | %.0f |\n",
        empty, qPrintable(arguments[1]), house, house - empty);
    return 0;
}
