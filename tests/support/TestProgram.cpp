// The main function of the test program of a folder: PROGRAM [TEST [option of Qt Test]...].
#include "tests/support/TestProgram.h"

#include <cstdio>

int main(int argumentCount, char** arguments) {
    using rubble::RegisteredTest;
    // Qt Test ends the program after five minutes in a test function, which is too short for a busy machine.
    if (!qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) qputenv("QTEST_FUNCTION_TIMEOUT", "3000000");
    if (argumentCount < 2) {
        int failures = 0;
        for (const RegisteredTest& test : rubble::registeredTests()) failures += test.run(argumentCount, arguments);
        return failures;
    }
    for (const RegisteredTest& test : rubble::registeredTests()) {
        if (test.name != arguments[1]) continue;
        // What follows the name is for Qt Test, which expects the program's name in front.
        arguments[1] = arguments[0];
        return test.run(argumentCount - 1, arguments + 1);
    }
    std::fprintf(stderr, "There is no test \"%s\". This program has:\n", arguments[1]);
    for (const RegisteredTest& test : rubble::registeredTests()) std::fprintf(stderr, "  %s\n", test.name.data());
    return 1;
}
