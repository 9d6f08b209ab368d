// Tests editor/document/ShownText.cpp and all widgets that show names: those from a file neither break the layout nor
// are taken for HTML, which could name files to read.
#include "editor/dialogs/ExportDialog.h"
#include "editor/dialogs/MaterialDialog.h"
#include "editor/dialogs/MaterialPictures.h"
#include "editor/dialogs/MessageBoxes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/Dialogs.h"
#include "tests/support/editor/EditorStory.h"

#include <QLabel>
#include <QMessageBox>
#include <QTextDocument>

using namespace rubble;

namespace {

constexpr int kMaxCharacters = 1000;  // of a text
constexpr int kMaxWidth = 1600;       // pixels; of the display

/// A name that is long, looks like HTML and controls the text around it.
std::string hostileName(int number) {
    return "<img src=\"/dev/zero\">\n\t\x1b[31m\u202e" + std::string(5000, 'w') + std::to_string(number);
}

Project hostileProject() {
    Project project = fullProject();
    project.assets.erase(project.assets.begin());  // the rest is baked at once
    project.instances.erase(project.instances.begin());
    project.instances[0].isHidden = project.instances[0].isLocked = false;
    int number = 0;
    for (Material& material : project.materials) material.name = hostileName(number++);
    for (Asset& asset : project.assets) asset.name = hostileName(number++);
    for (Instance& instance : project.instances) instance.name = hostileName(number++);
    for (Shot& shot : project.shots) shot.name = hostileName(number++);
    for (PlayTest& test : project.playTests) test.name = hostileName(number++);
    return project;
}

/// The first text below a widget that is too long or would be taken for HTML, and was not escaped.
QString faultIn(const QWidget& widget) {
    for (const auto* label : widget.findChildren<QLabel*>()) {
        const bool isHtml = label->textFormat() != Qt::PlainText && Qt::mightBeRichText(label->text());
        if (isHtml && label->text().contains("<img")) return "HTML: " + label->text();
        if (label->text().size() > kMaxCharacters) return "long: " + label->text();
    }
    for (const auto* child : widget.findChildren<QWidget*>()) {
        const QString tip = child->toolTip();
        if ((Qt::mightBeRichText(tip) && tip.contains("<img")) || tip.size() > kMaxCharacters) return "tip: " + tip;
        if (child->isVisible() && child->width() > kMaxWidth) return "wide: " + child->objectName();
    }
    return {};
}

}  // namespace

class NamesStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void cleanup() { close(); }

    void windowShowsNamesAsText() {
        open(hostileProject());
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(project()), kPatience);
        const auto check = [&] {
            QCoreApplication::processEvents();
            QCOMPARE(faultIn(window()), QString());
            QVERIFY(window().minimumSizeHint().width() <= kMaxWidth);
        };
        check();
        selection().setAsset(9);
        selection().setSubject(Part::Asset);
        check();
        selection().setMaterial(2);
        check();
        selection().setInstances(project(), {21});
        check();
        QVERIFY(window().windowTitle().size() < kMaxCharacters);
    }
    void dialogsShowNamesAsText() {
        open(hostileProject());
        selection().setAsset(9);
        const QTemporaryDir presets;
        ExportDialog exports(window().workspace(), nullptr);
        MaterialPictures pictures;
        MaterialDialog materials(window().workspace().document(), selection(), pictures, presets.path(), {}, nullptr);
        for (QDialog* dialog : {static_cast<QDialog*>(&exports), static_cast<QDialog*>(&materials)}) {
            dialog->show();
            QCOMPARE(faultIn(*dialog), QString());
            QVERIFY(dialog->width() <= kMaxWidth);
        }
    }
    void messagesShowNamesAsText() {
        Qt::TextFormat format = Qt::AutoText;
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            format = box.textFormat();
            QTest::keyClick(&box, Qt::Key_Return);
        });
        showError(nullptr, "The asset \"<img src=/dev/zero>\" is wrong.");
        QCOMPARE(format, Qt::PlainText);
        test::onNextDialog<QMessageBox>([&](QMessageBox& box) {
            format = box.textFormat();
            QTest::keyClick(&box, Qt::Key_Escape);
        });
        format = Qt::AutoText;
        confirmLoss(nullptr, "Discard \"<img src=/dev/zero>\"?", "Discard", "Cancel");
        QCOMPARE(format, Qt::PlainText);
    }
};

RUBBLE_TEST_WITH(NamesStoryTest, QApplication)
#include "NamesStoryTest.moc"
