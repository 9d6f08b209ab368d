#include "core/io/system/FileName.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class FileNameTest : public QObject {
    Q_OBJECT
private slots:
    void namesAreValidOnEverySystem() {
        QCOMPARE(safeFileName("wall"), std::string("wall"));
        QCOMPARE(safeFileName("Mauer Süd-2"), std::string("Mauer Süd-2"));
        QCOMPARE(safeFileName("a/b\\c:d*e"), std::string("a_b_c_d_e"));
        QCOMPARE(safeFileName("../up"), std::string("_._up"));
        QCOMPARE(safeFileName("dot."), std::string("dot_"));
        QCOMPARE(safeFileName(""), std::string("_"));
    }
};

RUBBLE_TEST(FileNameTest)
#include "FileNameTest.moc"
