#include "editor/document/FilePath.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class FilePathTest : public QObject {
    Q_OBJECT
private slots:
    void textIsKept() {
        const std::string text = "/home/w\u00e4nd/\u5899 \U0001F9F1.rubble";
        QCOMPARE(fromPath(text), QString::fromStdString(text));
        QCOMPARE(toPath(QString::fromStdString(text)).string(), text);
        QVERIFY(toPath(QString()).empty() && fromPath({}).isEmpty());
    }
    void everyByteIsKept() {
        std::string bytes;
        for (int byte = 1; byte < 256; ++byte) bytes += static_cast<char>(byte);
        bytes += "\xed\xb2\x80";  // a surrogate, which is not UTF-8
        bytes += "\u00e4\xff\U0001F9F1\xf0\x9f";
        QCOMPARE(toPath(fromPath(bytes)).string(), bytes);
    }
    void absolutePathsKeepAllBytes() {
        const std::filesystem::path folder = std::filesystem::current_path();
        QCOMPARE(toPath(absolutePath(fromPath("a/../h\xff.rubble"))), folder / "h\xff.rubble");
        QCOMPARE(absolutePath("/x/./y"), "/x/y");
    }
    void pairedSurrogatesAreCharacters() {
        const QString brick = QString::fromUtf8("\U0001F480");  // its second half is U+DC80
        QVERIFY(brick[1] == QChar(0xDC80));
        QCOMPARE(toPath(brick).string(), std::string("\U0001F480"));
    }
};

RUBBLE_TEST(FilePathTest)
#include "FilePathTest.moc"
