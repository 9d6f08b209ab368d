#include "core/io/play/JUnitXml.h"

#include "core/base/MessageText.h"
#include "core/io/text/XmlText.h"

#include <algorithm>
#include <vector>

namespace rubble {
namespace {

std::string attribute(const std::string& name, const std::string& value) {
    return ' ' + name + "=\"" + escapedXml(value) + '"';
}

std::string timeText(double seconds) { return attribute("time", roundedText(seconds, 3)); }

/// The failed expectations with the observed values.
std::vector<std::string> failuresOf(const PlayTestOutcome& outcome) {
    std::vector<std::string> failures;
    for (const ExpectationOutcome& expectation : outcome.expectations) {
        if (!expectation.isMet) failures.push_back(expectation.expected + ": " + expectation.seen);
    }
    return failures;
}

/// One on each line.
std::string linesOf(const std::vector<std::string>& failures) {
    std::string lines;
    for (const std::string& failure : failures) lines += (lines.empty() ? "" : "\n") + escapedXml(failure);
    return lines;
}

}  // namespace

std::string junitXml(const std::string& suite, std::span<const TimedPlayTest> tests) {
    double seconds = 0.0;
    for (const TimedPlayTest& test : tests) seconds += test.seconds;
    const auto failed =
        std::ranges::count_if(tests, [](const TimedPlayTest& test) { return !test.outcome.isPassed(); });
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite" +
                      attribute("name", suite) + attribute("tests", std::to_string(tests.size())) +
                      attribute("failures", std::to_string(failed)) + timeText(seconds) + ">\n";
    for (const TimedPlayTest& test : tests) {
        xml += "    <testcase" + attribute("classname", suite) + attribute("name", test.outcome.name) +
               timeText(test.seconds);
        if (test.outcome.isPassed()) {
            xml += "/>\n";
            continue;
        }
        const std::vector<std::string> failures = failuresOf(test.outcome);
        xml += ">\n      <failure" + attribute("message", failures.front()) + '>' + linesOf(failures) +
               "</failure>\n    </testcase>\n";
    }
    return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace rubble
