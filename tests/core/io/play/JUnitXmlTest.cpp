#include "core/io/play/JUnitXml.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class JUnitXmlTest : public QObject {
    Q_OBJECT
private slots:
    void failuresListTheExpectationsThatWereNotMet() {
        const TimedPlayTest stands{{.name = "stands", .expectations = {{.isMet = true}}}, 0.25};
        const TimedPlayTest falls{{.name = "falls",
                                   .expectations = {{.expected = "\"wall\" breaks", .seen = "it did not"},
                                                    {.isMet = true, .expected = "nothing"},
                                                    {.expected = "speed < 1 m/s", .seen = "2 m/s"}}},
                                  1.5};
        QCOMPARE(QString::fromStdString(junitXml("a & b", std::vector{stands, falls})),
                 QString("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                         "<testsuites>\n"
                         "  <testsuite name=\"a &amp; b\" tests=\"2\" failures=\"1\" time=\"1.75\">\n"
                         "    <testcase classname=\"a &amp; b\" name=\"stands\" time=\"0.25\"/>\n"
                         "    <testcase classname=\"a &amp; b\" name=\"falls\" time=\"1.5\">\n"
                         "      <failure message=\"&quot;wall&quot; breaks: it did not\">"
                         "&quot;wall&quot; breaks: it did not\nspeed &lt; 1 m/s: 2 m/s</failure>\n"
                         "    </testcase>\n"
                         "  </testsuite>\n"
                         "</testsuites>\n"));
    }
    void projectWithoutTestsIsAnEmptySuite() {
        const QString xml = QString::fromStdString(junitXml("empty", {}));
        QVERIFY2(xml.contains("tests=\"0\" failures=\"0\" time=\"0\""), qPrintable(xml));
    }
};

RUBBLE_TEST(JUnitXmlTest)
#include "JUnitXmlTest.moc"
