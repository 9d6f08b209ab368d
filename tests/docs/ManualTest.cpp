#include <QDir>
#include <QFile>
#include <QImageReader>
#include <QRegularExpression>
#include <QTest>

namespace {

const QDir kManual(RUBBLE_SOURCE_DIR "/docs/manual");
constexpr int kWidestPicture = 820;  // pixels that the manual's window has room for

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
    void picturesFitAndSayWhatTheyShow() {
        for (const QString& page : pages()) {
            QVERIFY2(!textOf(page).contains("![]("), qPrintable(page));
            for (const QString& picture : captures(textOf(page), "!\\[[^\\]]+\\]\\(([^)]+)\\)")) {
                const QSize size = QImageReader(kManual.filePath(picture)).size();
                QVERIFY2(size.isValid() && size.width() <= kWidestPicture, qPrintable(picture));
            }
        }
    }
    /// Qt's browser gives headings no anchors.
    void noLinkLeadsIntoAPage() {
        for (const QString& page : pages())
            QVERIFY2(!textOf(page).contains(QRegularExpression("\\]\\([^)]*#")), qPrintable(page));
    }
};

QTEST_GUILESS_MAIN(ManualTest)
#include "ManualTest.moc"
