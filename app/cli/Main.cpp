#include "app/cli/Cli.h"
#include "app/cli/console/PrintableBuffer.h"
#include "app/cli/console/Terminal.h"
#include "core/base/limits/MemoryReserve.h"
#include "core/io/system/ChildProcess.h"
#include "core/io/system/ProgramFolder.h"

#include <unistd.h>

#include <iostream>

int main(int argumentCount, char** arguments) {
    rubble::occupyStandardStreams();
    rubble::holdMemoryReserve();
    std::ios::sync_with_stdio(false);
    rubble::PrintableBuffer outBuffer(std::cout);
    rubble::PrintableBuffer errBuffer(std::cerr);
    std::ostream out(&outBuffer);
    std::ostream err(&errBuffer);
    err << std::unitbuf;
    const bool outIsTerminal = rubble::isTerminal(STDOUT_FILENO);
    rubble::CliContext context{.in = STDIN_FILENO, .out = outIsTerminal ? out : std::cout, .err = err};
    if (rubble::isTerminal(STDERR_FILENO)) context.terminal = &std::cerr;
    context.programFolder = rubble::programFolder();
    rubble::cancelOnSignals(context.cancel);
    return rubble::runCli({arguments + 1, arguments + argumentCount}, context);
}
