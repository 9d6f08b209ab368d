#include "core/io/play/JUnitXml.h"

#include "core/base/MessageText.h"
#include "core/io/text/XmlText.h"

#include <algorithm>

namespace rubble {
namespace {

std::string attribute(const std::string& name, const std::string& value) {
    return ' ' + name + "=\"" + escapedXml(value) + '"';
}

std::string timeText(double seconds) { return attribute("time", roundedText(seconds, 3)); }

/// The failed expectations with the observed values, one per line.
std::string failureText(const PlayTestOutcome& outcome) {
    std::string text;
    for (const ExpectationOutcome& expectation : outcome.expectations) {
        if (!expectation.isMet) text += (text.empty() ? "" : "\n") + expectation.expected + ": " + expectation.seen;
    }
    return text;
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
        const std::string text = failureText(test.outcome);
        xml += ">\n      <failure" + attribute("message", text.substr(0, text.find('\n'))) + '>' + escapedXml(text) +
               "</failure>\n    </testcase>\n";
    }
    return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace rubble
