// The editor: rubble [FILE...]
#include "editor/widgets/Icon.h"
#include "editor/window/Program.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>

int main(int argc, char** argv) {
    QApplication::setOrganizationName("Rubble");
    QApplication::setApplicationName("Rubble");
    QApplication::setApplicationVersion(RUBBLE_VERSION);
    QApplication::setDesktopFileName("io.github.rubble.Rubble");
    QApplication application(argc, argv);
    QApplication::setWindowIcon(rubble::iconNamed("rubble"));

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Desktop editor for destructible assets."));
    parser.addPositionalArgument("file", QApplication::translate("main", "Projects to open, or meshes to import."),
                                 "[FILE...]");
    parser.addHelpOption();
    parser.addVersionOption();
    parser.process(application);

    rubble::Program program;
    program.start(parser.positionalArguments());
    return QApplication::exec();
}
