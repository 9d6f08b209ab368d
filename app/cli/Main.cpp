#include "app/cli/Cli.h"
#include "app/cli/console/Terminal.h"

#include <iostream>
#include <system_error>

int main(int argumentCount, char** arguments) {
    std::ios::sync_with_stdio(false);
    std::error_code ignored;  // no /proc: rubble-importer is then looked for in the current folder
    rubble::CliContext context{std::cin, std::cout, std::cerr};
    context.errIsTerminal = rubble::standardErrorIsTerminal();
    context.programFolder = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
    rubble::cancelOnSignals(context.cancel);
    return rubble::runCli({arguments + 1, arguments + argumentCount}, context);
}
