#pragma once

#include <QProcess>

namespace rubble {

/// How a program ended and what it printed; -1 where it could not be started, crashed or took over two minutes.
struct ProgramOutcome {
    int exit = -1;
    QString output;
    QString error;
};

inline ProgramOutcome runProgram(const QString& program, const QStringList& arguments,
                                 const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment()) {
    constexpr int kLongestMilliseconds = 120000;
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(program, arguments);
    if (!process.waitForFinished(kLongestMilliseconds) || process.exitStatus() != QProcess::NormalExit) return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace rubble
