// The editor: rubble [FILE...]
#include "core/base/limits/MemoryReserve.h"
#include "core/io/system/ChildProcess.h"
#include "editor/document/FilePath.h"
#include "editor/widgets/Icon.h"
#include "editor/window/Application.h"
#include "editor/window/Program.h"

#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <QTimer>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace {

int run(int argumentCount, char** argumentList) {
    QApplication::setOrganizationName("Rubble");
    QApplication::setApplicationName("Rubble");
    QApplication::setApplicationVersion(RUBBLE_VERSION);
    QApplication::setDesktopFileName("io.github.rubble.Rubble");
    rubble::Application application(argumentCount, argumentList);
    QApplication::setWindowIcon(rubble::iconNamed("rubble"));

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Desktop editor for destructible assets."));
    parser.addPositionalArgument("file", QApplication::translate("main", "Projects to open, or meshes to import."),
                                 "[FILE...]");
    parser.addHelpOption();
    parser.addVersionOption();
    QStringList arguments;
    for (int k = 0; k < argumentCount; ++k) arguments.append(rubble::fromPath(argumentList[k]));
    parser.process(arguments);  // Qt's own list loses the bytes of paths that are not UTF-8

    rubble::Program program;
    // Within the event loop, where the application notices that memory runs out.
    QTimer::singleShot(0, &program, [&] { program.start(parser.positionalArguments()); });
    try {
        return QApplication::exec();
    } catch (const std::bad_alloc&) {  // outside of any event, so that the loop cannot go on
        rubble::releaseMemoryReserve();
        program.backUp();
        std::fputs("Out of memory. Changes that were not saved are offered as a backup at the next start.\n", stderr);
        return 1;
    }
}

}  // namespace

int main(int argumentCount, char** argumentList) {
    rubble::occupyStandardStreams();
    std::signal(SIGXFSZ, SIG_IGN);  // writing fails instead, which is reported
    std::set_terminate(&rubble::Application::terminate);
    if (const auto fault = rubble::Application::startFault()) {
        std::fprintf(stderr, "%s\n", fault->c_str());
        return 1;
    }
    try {
        return run(argumentCount, argumentList);
    } catch (const std::bad_alloc&) {  // before there is a window
        std::fputs("Out of memory.\n", stderr);
        return 1;
    }
}
