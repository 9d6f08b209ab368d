// The editor used step by step: tests/attack/limits.sh runs it where the machine has too little of something.
#include "editor/document/FilePath.h"
#include "editor/window/Application.h"
#include "editor/window/Program.h"
#include "tests/attack/steps/EditorSteps.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace {

int run(int argumentCount, char** arguments) {
    using namespace rubble;
    const attack::StepFiles files{fromPath(arguments[1]), fromPath(arguments[2])};
    QApplication::setOrganizationName("Rubble");
    QApplication::setApplicationName("Rubble");
    Application application(argumentCount, arguments);
    QApplication::setQuitOnLastWindowClosed(false);
    Program program;
    attack::EditorSteps steps(program, files);
    QObject::connect(&application, &Application::ranOut, &steps, &attack::EditorSteps::note);
    const int status = QApplication::exec();
    return steps.hasFailed() ? 3 : status;
}

}  // namespace

/// Starts as app/Main.cpp does.
int main(int argumentCount, char** arguments) {
    if (argumentCount != 3) {
        std::fputs("usage: editor-steps PROJECT MESH\n", stderr);
        return 2;
    }
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_terminate(&rubble::Application::terminate);
    if (const auto fault = rubble::Application::startFault()) {
        std::fprintf(stderr, "%s\n", fault->c_str());
        return 1;
    }
    try {
        return run(argumentCount, arguments);
    } catch (const std::bad_alloc&) {
        std::fputs("Out of memory.\n", stderr);
        return 1;
    }
}
