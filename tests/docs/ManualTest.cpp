#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QImageReader>
#include <QRegularExpression>
#include <QTest>

namespace {

const QDir kManual(RUBBLE_SOURCE_DIR "/docs/manual");

QString textOf(const QString& page) {
    QFile file(kManual.filePath(page));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList pages() { return kManual.entryList({"*.md"}, QDir::Files); }

QStringList captures(const QString& text, const char* pattern) {
    QStringList found;
    for (auto match = QRegularExpression(pattern).globalMatch(text); match.hasNext();) {
        found.append(match.next().captured(1));
    }
    return found;
}

}  // namespace

class ManualTest : public QObject {
    Q_OBJECT
private slots:
    void theContentsListEveryPage() {
        QStringList listed = captures(textOf("index.md"), "\n- \\[[^\\]]+\\]\\(([a-z0-9-]+\\.md)\\)");
        listed.append("index.md");
        listed.sort();
        QCOMPARE(listed, pages());
    }
    void everyPageLeadsBack() {
        for (const QString& page : pages()) {
            if (page == "index.md") continue;
            QVERIFY2(textOf(page).section('\n', 2, 2) == "[Contents](index.md)", qPrintable(page));
        }
    }
    void picturesCanBeReadAndSayWhatTheyShow() {
        for (const QString& page : pages()) {
            QVERIFY2(!textOf(page).contains("![]("), qPrintable(page));
            for (const QString& picture : captures(textOf(page), "!\\[[^\\]]+\\]\\(([^)]+)\\)")) {
                QVERIFY2(QImageReader(kManual.filePath(picture)).canRead(), qPrintable(picture));
            }
        }
    }
    /// Those of actions; what canvas and 3D view do with keys themselves is told on their pages.
    void everyShortcutIsTold() {
        const QString told = textOf("shortcuts.md");
        int shortcuts = 0;
        for (QDirIterator at(RUBBLE_SOURCE_DIR "/editor", {"*Actions.cpp"}, QDir::Files); at.hasNext();) {
            for (const QString& keys : captures(textOf(at.next()), "QKeySequence\\(\"([^\"]+)\"\\)")) {
                QVERIFY2(told.contains("**" + keys + "**"), qPrintable(keys));
                ++shortcuts;
            }
        }
        QVERIFY(shortcuts > 15);
    }
    /// Qt's browser gives headings no anchors.
    void noLinkLeadsIntoAPage() {
        for (const QString& page : pages())
            QVERIFY2(!textOf(page).contains(QRegularExpression("\\]\\([^)]*#")), qPrintable(page));
    }
};

QTEST_GUILESS_MAIN(ManualTest)
#include "ManualTest.moc"
