#include "core/fracture/kinds/BrickCourses.h"

#include "core/base/Random.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace rubble;

namespace {

constexpr double kRounding = 1e-12;  // m

/// Bricks with joints of 0.25 and 0.125 m from each other, in courses of 0.0625 m.
BrickBond bondOf(BondKind kind) {
    return {.bond = kind, .length = 0.24, .width = 0.115, .height = 0.0525, .mortar = 0.01, .origin = {1.0, 2.0}};
}

bool isNear(double a, double b) { return std::abs(a - b) < kRounding; }

}  // namespace

class BrickCoursesTest : public QObject {
    Q_OBJECT
private slots:
    void coursesAreBrickAndJointHigh() {
        const BrickCourses courses(bondOf(BondKind::Stretcher));
        QVERIFY(isNear(courses.bottom(0), 2.0));
        QVERIFY(isNear(courses.bottom(4), 2.25));
        QVERIFY(isNear(courses.bottom(-2), 1.875));
    }
    void bondDecidesTheJoints_data() {
        QTest::addColumn<int>("bond");
        QTest::addColumn<QList<double>>("even");  // the joints left of columns 0, 1 and 2
        QTest::addColumn<QList<double>>("odd");
        using Joints = QList<double>;
        QTest::newRow("stretcher") << int(BondKind::Stretcher) << Joints{1.0, 1.25, 1.5} << Joints{1.125, 1.375, 1.625};
        QTest::newRow("stack") << int(BondKind::Stack) << Joints{1.0, 1.25, 1.5} << Joints{1.0, 1.25, 1.5};
        QTest::newRow("English") << int(BondKind::English) << Joints{1.0, 1.25, 1.5} << Joints{1.0625, 1.1875, 1.3125};
        QTest::newRow("header") << int(BondKind::Header) << Joints{1.0, 1.125, 1.25} << Joints{1.0625, 1.1875, 1.3125};
        QTest::newRow("Flemish") << int(BondKind::Flemish) << Joints{1.0, 1.25, 1.375}
                                 << Joints{1.1875, 1.4375, 1.5625};
    }
    void bondDecidesTheJoints() {
        QFETCH(int, bond);
        QFETCH(QList<double>, even);
        QFETCH(QList<double>, odd);
        const BrickCourses courses(bondOf(BondKind(bond)));
        for (int column = 0; column < 3; ++column) {
            QVERIFY(isNear(courses.left(0, column), even[column]));
            QVERIFY(isNear(courses.left(-4, column), even[column]));
            QVERIFY(isNear(courses.left(1, column), odd[column]));
            QVERIFY(isNear(courses.left(-3, column), odd[column]));
        }
    }
    void pointsAreInTheCellAroundThem() {
        for (std::uint64_t number = 1; number <= 5000; ++number) {
            Random random(number);
            const BrickCourses courses(bondOf(BondKind(number % 5)));
            const int course = static_cast<int>(random.below(100)) - 50,
                      column = static_cast<int>(random.below(100)) - 50;
            const double left = courses.left(course, column), right = courses.left(course, column + 1);
            const double low = courses.bottom(course), high = courses.bottom(course + 1);
            QVERIFY2(right - left > 0.1 && right - left < 0.26, qPrintable(faultOfSeed(number, "width")));
            const double x = left + random.between(0.001, 0.999) * (right - left);
            QCOMPARE(courses.courseAt(low + random.between(0.001, 0.999) * (high - low)), course);
            QVERIFY2(courses.columnAt(course, x) == column, qPrintable(faultOfSeed(number, "column")));
        }
    }
    void farPointsAreOneBeyondTheLimit() {
        const BrickCourses courses(bondOf(BondKind::Stretcher));
        QCOMPARE(courses.courseAt(1e9), BrickCourses::kMaxIndex + 1);
        QCOMPARE(courses.courseAt(-1e9), -BrickCourses::kMaxIndex - 1);
        QCOMPARE(courses.columnAt(0, 1e9), BrickCourses::kMaxIndex + 1);
    }
    void cellsHaveDifferentIndices() {
        std::set<std::uint32_t> indices;
        for (int course = -20; course <= 20; ++course)
            for (int column = -20; column <= 20; ++column) indices.insert(BrickCourses::cellIndex(course, column));
        QCOMPARE(indices.size(), std::size_t{41 * 41});
        constexpr int kFar = BrickCourses::kMaxIndex + 1;
        for (const int course : {-kFar, kFar})
            for (const int column : {-kFar, kFar}) QVERIFY(BrickCourses::cellIndex(course, column) < 1u << 31);
    }
};

RUBBLE_TEST(BrickCoursesTest)
#include "BrickCoursesTest.moc"
