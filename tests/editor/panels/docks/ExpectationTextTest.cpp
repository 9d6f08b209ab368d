#include "editor/panels/docks/ExpectationText.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class ExpectationTextTest : public QObject {
    Q_OBJECT
private slots:
    void eachKindHasANameAndSentences() {
        QCOMPARE(expectationKindNames().size(), kExpectationKinds);
        Project project;
        project.instances = {{.id = 7, .name = "wall"}};
        for (int k = 0; k < static_cast<int>(kExpectationKinds); ++k) {
            const auto kind = static_cast<ExpectationKind>(k);
            for (const Id instance : {Id{0}, Id{7}}) {
                const QString text = expectationText({kind, instance, 2.0}, project, {});
                QVERIFY2(!text.contains("%1") && !text.contains("%2"), qPrintable(text));
                QCOMPARE(text.startsWith("wall "), instance != 0);
                QCOMPARE(text.contains('2'), expectationFormat(kind, {}).has_value());
            }
        }
    }
    void valuesHaveTheirUnits() {
        const auto text = [](ExpectationKind kind, double value, const Units& units) {
            return expectationText({kind, 0, value}, {}, units).replace(QChar(QChar::Nbsp), ' ');
        };
        QCOMPARE(text(ExpectationKind::StandsUntouched, 5.0, {}), "Everything stays intact for 5 s");
        QCOMPARE(text(ExpectationKind::NothingAbove, 0.5, {LengthUnit::Centimetre}),
                 "Everything ends below a height of 50 cm");
        QCOMPARE(text(ExpectationKind::NothingFaster, 0.5, {}), "Everything ends below a speed of 0.5 m/s");
        QCOMPARE(text(ExpectationKind::StaysUp, 0.1, {}), "Every instance loses at most 10 % of its mass");
        QCOMPARE(text(ExpectationKind::HoleAtMost, 0.5, {}), "Every instance has holes of at most 0.5 m");
        QCOMPARE(text(ExpectationKind::BreaksIntoAtLeast, 2.0, {}), "Something breaks into at least 2 fragments");
    }
};

RUBBLE_TEST_WITH(ExpectationTextTest, QCoreApplication)
#include "ExpectationTextTest.moc"
