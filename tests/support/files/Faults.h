#pragma once

#include "tests/support/files/FileBytes.h"
#include "tests/support/files/RunProgram.h"

#include <QFile>

namespace rubble {

/// A call to the file system that fails: see FaultInjection.cpp.
struct Fault {
    QString folder;  // the calls for files below it count
    QString report;  // a file elsewhere
    int call = 1;
    int code = 0;  // of errno; 0 kills the program
};

struct FaultyRun {
    ProgramOutcome outcome;
    QString failed;  // the name of the call that failed; empty if there are fewer
};

/// Runs a program with a fault. `library` is that of FaultInjection.cpp.
inline FaultyRun runWithFault(const QString& program, const QStringList& arguments, const QString& library,
                              const Fault& fault,
                              QProcessEnvironment environment = QProcessEnvironment::systemEnvironment()) {
    environment.insert("LD_PRELOAD", library);
    environment.insert("RUBBLE_FAULT_FOLDER", fault.folder);
    environment.insert("RUBBLE_FAULT_CALL", QString::number(fault.call));
    environment.insert("RUBBLE_FAULT_CODE", QString::number(fault.code));
    environment.insert("RUBBLE_FAULT_REPORT", fault.report);
    QFile::remove(fault.report);
    FaultyRun run{.outcome = runProgram(program, arguments, {.environment = environment})};
    run.failed = QString::fromUtf8(bytesOfFile(fault.report));
    return run;
}

}  // namespace rubble
