// Tests editor/actions/PictureActions.cpp, editor/dialogs/PictureDialog.cpp and editor/dialogs/PictureFile.cpp.
#include "editor/dialogs/PictureDialog.h"
#include "editor/help/ActionSearch.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/files/FileLimits.h"
#include "tests/support/viewport/Pictures.h"
#include "tests/support/viewport/ShownPicture.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QMessageBox>

using namespace rubble;

/// Pictures of the canvas and of the 3D view, saved from the window.
class SavePictureTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openFile(RUBBLE_SOURCE_DIR "/projects/house.rubble");
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(project()), kPatience);
    }
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        viewport().setFocus();
    }

    void isFoundByItsNames() {
        for (const char* word : {"picture", "screenshot", "image"}) {
            const QList<QAction*> found = matchingActions(word, window().findChildren<QAction*>());
            QVERIFY2(found.contains(action("file-save-picture")), word);
        }
        QCOMPARE(matchingActions("picture", window().findChildren<QAction*>()).front(), action("file-save-picture"));
    }
    void viewInFocusIsSaved() {
        if (!hasView()) QSKIP("no OpenGL");
        save("view.png", 0);
        const QImage saved = picture("view.png");
        const ImageSize size = viewport().imageSize();
        QCOMPARE(saved.size(), QSize(size.width, size.height));
        const QImage shown = test::shownPicture(viewport()).convertToFormat(QImage::Format_RGB888);
        const QRect middle(saved.width() / 4, saved.height() / 4, saved.width() / 2, saved.height() / 2);
        const double difference = test::meanDifference(saved.copy(middle), shown.copy(middle));
        QVERIFY2(difference < 6.0, qPrintable(QString::number(difference)));  // soft light; hints are left out
    }
    void sizesAreThoseOfTheList() {
        if (!hasView()) QSKIP("no OpenGL");
        const ImageSize size = viewport().imageSize();
        save("twice.png", 1);
        QCOMPARE(picture("twice.png").size(), QSize(2 * size.width, 2 * size.height));
        save("screen.jpg", 2);
        QCOMPARE(picture("screen.jpg").size(), QSize(1920, 1080));
        QFile file(m_folder->filePath("screen.jpg"));
        QVERIFY(file.open(QIODevice::ReadOnly) && file.read(3) == QByteArray("\xff\xd8\xff"));
    }
    void canvasInFocusIsSaved() {
        canvas().setFocus();
        save("canvas.png", 0);
        QCOMPARE(picture("canvas.png").size(), canvas().size() * canvas().devicePixelRatioF());
        const QImage shown = canvas().grab().toImage().convertToFormat(QImage::Format_RGB888);
        QVERIFY(test::meanDifference(picture("canvas.png"), shown) < 1.0);
        save("large.png", 3);
        QCOMPARE(picture("large.png").size(), QSize(3840, 2160));
    }
    void dialogRemembersSizeFolderAndFormat() {
        canvas().setFocus();
        save("first.jpg", 2);
        ask([this](PictureDialog& dialog) {
            QCOMPARE(dialog.options().path, m_folder->filePath("house.jpg"));
            QCOMPARE(dialog.options().size, (ImageSize{1920, 1080}));
            dialog.reject();
        });
    }
    void badPathsAreReported() {
        canvas().setFocus();
        ask([this](PictureDialog& dialog) {
            enter(dialog, "picture.gif");
            QCOMPARE(summary(dialog), QString("Pictures are saved as .png or .jpg; \"picture.gif\" is neither."));
            QVERIFY(!saveButton(dialog).isEnabled());
            dialog.findChild<QLineEdit*>("picture-path")->clear();
            QCOMPARE(summary(dialog), QString("The file is empty. Enter a path."));
            dialog.findChild<QLineEdit*>("picture-path")->setText(m_folder->path());
            QVERIFY(!saveButton(dialog).isEnabled());
            enter(dialog, "plain");
            QCOMPARE(dialog.options().path, m_folder->filePath("plain.png"));
            QVERIFY(saveButton(dialog).isEnabled());
            dialog.reject();
        });
        const QString error = errorOf("missing/picture.png");
        QVERIFY2(error.contains("missing"), qPrintable(error));
        QVERIFY(QDir(m_folder->path()).isEmpty());
    }
    void fullDiskKeepsTheFormerPicture() {
        canvas().setFocus();
        save("canvas.png", 0);
        const QImage before = picture("canvas.png");
        const FileSizeLimit full(2000);
        const QString error = errorOf("canvas.png");
        QVERIFY2(error.contains("File too large"), qPrintable(error));
        QCOMPARE(picture("canvas.png"), before);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"canvas.png"});
    }

    void cleanupTestCase() { close(); }

private:
    void ask(const std::function<void(PictureDialog&)>& answer) {
        test::onNextDialog<PictureDialog>([answer](PictureDialog& dialog) {
            answer(dialog);
            if (dialog.isVisible()) dialog.reject();  // a check failed
        });
        action("file-save-picture")->trigger();
    }
    void enter(PictureDialog& dialog, const QString& name) {
        dialog.findChild<QLineEdit*>("picture-path")->setText(m_folder->filePath(name));
    }
    void accept(PictureDialog& dialog, const QString& name, int size) {
        dialog.findChildren<QComboBox*>().last()->setCurrentIndex(size);
        enter(dialog, name);
        dialog.accept();
    }
    /// Saves a picture and closes the box that offers its folder.
    void save(const QString& name, int size) {
        ask([this, name, size](PictureDialog& dialog) { accept(dialog, name, size); });
        auto* box = window().findChild<QMessageBox*>();
        QVERIFY(box);
        QVERIFY2(box->text().startsWith("Saved " + name + ", "), qPrintable(box->text()));
        delete box;
    }
    /// Returns the text of the error box that follows.
    QString errorOf(const QString& name) {
        QString error;
        ask([&](PictureDialog& dialog) {
            test::onNextDialog<QMessageBox>([&error](QMessageBox& box) {
                error = box.text();
                box.accept();
            });
            accept(dialog, name, 0);
        });
        return error;
    }
    static QString summary(PictureDialog& dialog) { return dialog.findChild<QLabel*>("picture-summary")->text(); }
    static QPushButton& saveButton(PictureDialog& dialog) {
        for (QAbstractButton* button : dialog.findChild<QDialogButtonBox*>()->buttons()) {
            if (button->text() == "Save") return static_cast<QPushButton&>(*button);
        }
        qFatal("Save button not found.");
    }
    QImage picture(const QString& name) const {
        return QImage(m_folder->filePath(name)).convertToFormat(QImage::Format_RGB888);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

RUBBLE_TEST_WITH(SavePictureTest, QApplication)
#include "SavePictureTest.moc"
