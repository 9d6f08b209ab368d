#include "editor/panels/models/ProblemModel.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Manual.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QImageReader>
#include <QRegularExpression>
#include <QTest>

using rubble::kManual;

namespace {

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
    void contentsListEveryPage() {
        QStringList listed = captures(textOf("index.md"), "\n- \\[[^\\]]+\\]\\(([a-z0-9-]+\\.md)\\)");
        listed.append("index.md");
        listed.sort();
        QCOMPARE(listed, pages());
    }
    void everyPageLinksToTheContents() {
        for (const QString& page : pages()) {
            if (page == "index.md") continue;
            QVERIFY2(textOf(page).section('\n', 2, 2) == "[Contents](index.md)", qPrintable(page));
        }
    }
    void picturesExistAndHaveATitle() {
        for (const QString& page : pages()) {
            QVERIFY2(!textOf(page).contains("![]("), qPrintable(page));
            for (const QString& picture : captures(textOf(page), "!\\[[^\\]]+\\]\\(([^)]+)\\)")) {
                QVERIFY2(QImageReader(kManual.filePath(picture)).canRead(), qPrintable(picture));
            }
        }
    }
    /// Of all actions. Keys that canvas and 3D view handle themselves are documented on their pages.
    void everyShortcutIsDocumented() {
        const QString documented = textOf("shortcuts.md");
        int shortcuts = 0;
        QDirIterator file(RUBBLE_SOURCE_DIR "/editor", {"*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
        while (file.hasNext()) {
            for (const QString& keys : captures(textOf(file.next()), "QKeySequence\\(\"([^\"]+)\"\\)")) {
                QVERIFY2(documented.contains("**" + keys + "**"), qPrintable(keys));
                ++shortcuts;
            }
        }
        QVERIFY(shortcuts > 50);
    }
    void everyKindOfProblemIsDocumented() {
        const QString documented = textOf("inspection.md");
        int kinds = 0;
        for (int code = 0; code < rubble::kDiagnosticCodes; ++code) {
            const QString title = rubble::textOf(static_cast<rubble::DiagnosticCode>(code));
            if (title.isEmpty()) continue;  // never listed as a problem
            QVERIFY2(documented.contains("\n| " + title + " | "), qPrintable(title));
            ++kinds;
        }
        QVERIFY(kinds > 10);
    }
    /// QTextBrowser gives headings no anchors.
    void linksHaveNoAnchors() {
        for (const QString& page : pages())
            QVERIFY2(!textOf(page).contains(QRegularExpression("\\]\\([^)]*#")), qPrintable(page));
    }
};

RUBBLE_TEST_WITH(ManualTest, QCoreApplication)
#include "ManualTest.moc"
