#pragma once

#include "tests/support/Patience.h"

#include <QProcess>

#include <chrono>

namespace rubble {

/// How a program ended and what it printed; its exit code is -1 where it could not be started, crashed or was killed.
struct ProgramOutcome {
    int exit = -1;
    QString output;
    QString error;
};

struct RunOptions {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    std::chrono::milliseconds limit{kPatience};  // a program that runs longer is killed
};

/// Runs a program to its end.
inline ProgramOutcome runProgram(const QString& program, const QStringList& arguments, const RunOptions& options = {}) {
    QProcess process;
    process.setProcessEnvironment(options.environment);
    process.start(program, arguments);
    const bool hasEnded = process.waitForFinished(static_cast<int>(options.limit.count()));
    if (!hasEnded) {
        process.kill();
        process.waitForFinished(kPatience);
    }
    return {hasEnded && process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardOutput()), QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace rubble
