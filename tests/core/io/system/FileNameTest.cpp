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
        QCOMPARE(safeFileName("-rf"), std::string("_rf"));
        QCOMPARE(safeFileName("--"), std::string("_-"));
        QCOMPARE(safeFileName(""), std::string("_"));
        QCOMPARE(safeFileName("con"), std::string("_con"));
        QCOMPARE(safeFileName("LPT1.txt"), std::string("_LPT1.txt"));
        QCOMPARE(safeFileName("COM\xc2\xb9 .x"), std::string("_COM\xc2\xb9 .x"));
        QCOMPARE(safeFileName("console"), std::string("console"));
        QCOMPARE(safeFileName("a\xe2\x80\x8b\xc2\x85z"), std::string("a__z"));  // zero width, next line
        QCOMPARE(safeFileName("e\xcc\x81"), std::string("\xc3\xa9"));           // composed
        QCOMPARE(safeFileName("bad\xff"), std::string("bad_"));
    }
    void longNamesAreShortened() {
        const std::string a(201, 'a'), b = std::string(200, 'a') + 'b';
        QCOMPARE(safeFileName(a).size(), std::size_t{200});
        QVERIFY(safeFileName(a) != safeFileName(b) && safeFileName(a).starts_with("aaa"));
        QCOMPARE(safeFileName(std::string(200, 'a')), std::string(200, 'a'));
        QCOMPARE(safeFileName(std::string(32, 'a'), kShortestName), std::string(32, 'a'));
        QCOMPARE(safeFileName(a, kShortestName).size(), kShortestName);
        QVERIFY(safeFileName(a, kShortestName) != safeFileName(b, kShortestName));
    }
    void namesWithEndingsFit() {
        QCOMPARE(fittingFileName(".", "wall", ".lock"), std::string(".wall.lock"));
        const std::string longest(255, 'x');
        QCOMPARE(fittingFileName("", longest, ""), longest);
        const std::string fitting = fittingFileName(".", longest, ".lock");
        QCOMPARE(fitting.size(), std::size_t{255});
        QVERIFY(fitting.starts_with(".xxx") && fitting.ends_with(".lock"));
    }
};

RUBBLE_TEST(FileNameTest)
#include "FileNameTest.moc"
