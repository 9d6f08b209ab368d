// Tests tools/mutate: which mutants it makes of a source.
#include "tests/support/TestProgram.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

struct Listing {
    int exit = -1;
    QStringList mutants;  // without the path
    QString error;
};

/// What the tool lists for a source with this text.
Listing mutantsOf(const QByteArray& text) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("Source.cpp");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) return {};
    file.close();
    QProcess process;
    process.start(RUBBLE_SOURCE_DIR "/tools/mutate", {"--list", path});
    process.waitForFinished(rubble::kPatience);
    Listing listing{process.exitCode(),
                    QString::fromUtf8(process.readAllStandardOutput()).split('\n', Qt::SkipEmptyParts),
                    process.readAllStandardError()};
    for (QString& line : listing.mutants) line.remove(path + ":");
    QFile unchanged(path);
    if (!unchanged.open(QIODevice::ReadOnly) || unchanged.readAll() != text) listing.error += "the source was changed";
    return listing;
}

void compare(const QByteArray& text, const QStringList& expected) {
    const Listing listing = mutantsOf(text);
    QCOMPARE(listing.error, QString());
    QCOMPARE(listing.exit, 0);
    QCOMPARE(listing.mutants, expected);
}

}  // namespace

class MutateTest : public QObject {
    Q_OBJECT
private slots:
    void signsAndProducts() {
        compare("int f(int a, int b) { return a + b; }\n",
                {"1: int f(int a, int b) { return a + b; }  ->  int f(int a, int b) { return a - b; }"});
        compare("x = a * b;\nx = a / b;\nx += -a;\n", {"1: x = a * b;  ->  x = a / b;", "2: x = a / b;  ->  x = a * b;",
                                                       "3: x += -a;  ->  x -= -a;", "3: x += -a;  ->  x += a;"});
    }
    void comparisonsBecomeTheirOpposite() {
        compare("x = a < b && c == d;\n", {"1: x = a < b && c == d;  ->  x = a >= b && c == d;",
                                           "1: x = a < b && c == d;  ->  x = a < b || c == d;",
                                           "1: x = a < b && c == d;  ->  x = a < b && c != d;"});
    }
    void loopsGoOneTooFar() {
        compare("for (int i = a; i < b; ++i) f(i > b);\n",
                {"1: for (int i = a; i < b; ++i) f(i > b);  ->  for (int i = a; i <= b; ++i) f(i > b);",
                 "1: for (int i = a; i < b; ++i) f(i > b);  ->  for (int i = a; i < b; ++i) f(i <= b);"});
    }
    void constantsMinimaAndMaxima() {
        compare("x = std::min(a, 7);\ny = lesser<W>(b, 0.5f) + 0.0;\n",
                {"1: x = std::min(a, 7);  ->  x = std::max(a, 7);", "1: x = std::min(a, 7);  ->  x = std::min(a, 8);",
                 "2: y = lesser<W>(b, 0.5f) + 0.0;  ->  y = greater<W>(b, 0.5f) + 0.0;",
                 "2: y = lesser<W>(b, 0.5f) + 0.0;  ->  y = lesser<W>(b, 5.0f) + 0.0;",
                 "2: y = lesser<W>(b, 0.5f) + 0.0;  ->  y = lesser<W>(b, 0.5f) - 0.0;",
                 "2: y = lesser<W>(b, 0.5f) + 0.0;  ->  y = lesser<W>(b, 0.5f) + 1.0;"});
    }
    void commentsStringsAndAssertsStay() {
        compare(
            "// a + b\n/* a < 1 */\n#if X > 1 && \\\n    Y > 2\n#endif\nf(\"a + 1\", '<', R\"(1 + 1)\");\n"
            "static_assert(sizeof(int) == 4);\nRUBBLE_ASSERT(a < b && f(1));\n",
            {});
    }
    void templatesTypesAndDeclarationsStay() {
        compare(
            "template <int W = 8>\nstd::array<float, 4> f(const A& a, B* b, C&& c);\nfloat rows[4]{};\n"
            "V operator+(const V& b) const;\n",
            {});
        compare(
            "struct S {\n    int count = 1;\n    Vec3f zero{0.0f, 0.0f, 0.0f};\n    int next() const { return count + "
            "1; }\n};\n",
            {"4: int next() const { return count + 1; }  ->  int next() const { return count - 1; }",
             "4: int next() const { return count + 1; }  ->  int next() const { return count + 2; }"});
    }
    void trailingCommentsAreNotListed() { compare("x = 1;  // one\n", {"1: x = 1;  ->  x = 2;"}); }
    void sourcesThatAreNotThereAreNamed() {
        QProcess process;
        process.start(RUBBLE_SOURCE_DIR "/tools/mutate", {"--list", "/nowhere/Source.cpp"});
        process.waitForFinished(rubble::kPatience);
        QCOMPARE(process.exitCode(), 1);
        QCOMPARE(process.readAllStandardError(), QByteArray("tools/mutate: /nowhere/Source.cpp is not there.\n"));
    }
};

RUBBLE_TEST(MutateTest)
#include "MutateTest.moc"
