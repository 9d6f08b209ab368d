// The editor: rubble [FILE...]
#include "core/io/system/ChildProcess.h"
#include "editor/document/FilePath.h"
#include "editor/widgets/Icon.h"
#include "editor/window/Program.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>

int main(int argumentCount, char** argumentList) {
    rubble::occupyStandardStreams();
    QApplication::setOrganizationName("Rubble");
    QApplication::setApplicationName("Rubble");
    QApplication::setApplicationVersion(RUBBLE_VERSION);
    QApplication::setDesktopFileName("io.github.rubble.Rubble");
    QApplication application(argumentCount, argumentList);
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
    program.start(parser.positionalArguments());
    return QApplication::exec();
}
