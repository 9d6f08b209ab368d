#include "editor/widgets/ProjectRange.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class ProjectRangeTest : public QObject {
    Q_OBJECT
private slots:
    void fieldsAllowWhatTheProjectAllows() {
        for (const ProjectNumber number : {ProjectNumber::Mass, ProjectNumber::TestDuration, ProjectNumber::Friction}) {
            const FieldRange field = fieldRange(number);
            const NumberRange& range = rangeOf(number);
            QCOMPARE(field.min, range.min);
            QCOMPARE(field.max, range.max);
            QCOMPARE(field.contains(range.min), !range.isMinExcluded);
            QVERIFY(field.contains(range.max) && !field.contains(2.0 * range.max));
        }
    }
    void wholeFieldsAllowNoFractions() {
        const FieldRange field = wholeFieldRange(ProjectNumber::ExpectedFragments);
        QVERIFY(field.contains(2.0) && !field.contains(2.5));
    }
    void optionalFieldsAllowZero() {
        const FieldRange field = optionalFieldRange(ProjectNumber::Mass);
        QVERIFY(field.contains(0.0) && !field.contains(-1.0));
        const double least = rangeOf(ProjectNumber::Mass).min;
        if (least > 0.0) QVERIFY(!field.contains(0.5 * least));
    }
};

RUBBLE_TEST(ProjectRangeTest)
#include "ProjectRangeTest.moc"
