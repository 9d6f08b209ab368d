#pragma once

#include "tests/support/Patience.h"

#include <QCoreApplication>
#include <QTest>

#include <string_view>
#include <vector>

// Qt's own limit, 5 s, is too short for a busy machine.
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, ::rubble::kPatience)
#define QTRY_VERIFY2(condition, message) QTRY_VERIFY2_WITH_TIMEOUT(condition, message, ::rubble::kPatience)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, ::rubble::kPatience)

namespace rubble {

/// A test class as the program of its folder knows it.
struct RegisteredTest {
    std::string_view name;                            // of the class, which is that of its file
    int (*run)(int argumentCount, char** arguments);  // returns the number of failures
};

/// All tests of this program. TestProgram.cpp runs the one whose name is the first argument, or all of them.
inline std::vector<RegisteredTest>& registeredTests() {
    static std::vector<RegisteredTest> tests;
    return tests;
}

struct NoApplication {
    NoApplication(int&, char**) {}
};

/// Runs one test class while an Application lives. As QTEST_MAIN, it calls a static Test::initMain() before that.
template <class Test, class Application>
int runTest(int argumentCount, char** arguments) {
    if constexpr (requires { Test::initMain(); }) Test::initMain();
    [[maybe_unused]] Application application(argumentCount, arguments);
    Test test;
    return QTest::qExec(&test, argumentCount, arguments);
}

template <class Test, class Application>
bool registerTest(std::string_view name) {
    registeredTests().push_back({name, runTest<Test, Application>});
    return true;
}

}  // namespace rubble

/// Registers a test class that needs an application object: QCoreApplication, QGuiApplication or QApplication.
#define RUBBLE_TEST_WITH(Test, Application) \
    [[maybe_unused]] static const bool isRegistered##Test = ::rubble::registerTest<Test, Application>(#Test);
/// Registers a test class that needs none.
#define RUBBLE_TEST(Test) RUBBLE_TEST_WITH(Test, ::rubble::NoApplication)
