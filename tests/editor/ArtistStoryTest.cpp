#include "core/asset/StarterProject.h"
#include "editor/ContactSheetWindow.h"
#include "editor/MaterialDialog.h"
#include "editor/SelectDialogs.h"
#include "editor/panels/NumberField.h"
#include "editor/panels/ShapingSection.h"
#include "tests/support/Dialogs.h"
#include "tests/support/EditorStory.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include <algorithm>

using namespace rubble;

/// An artist's afternoon with one wall, by mouse and keys: it is made of concrete, hit by a bullet, painted where it is weak, rid of
/// its crumbs, its big pieces broken again, looked at piece by piece, and compared with variants of itself.
class ArtistStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        open(starterProject());
        selection().setAsset(wall().id);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        window().views().fit();
        m_before = text();
    }
    void cleanupTestCase() { close(); }

    void itIsMadeOfConcrete() {
        test::whenAsked<MaterialDialog>([](MaterialDialog& dialog) {
            auto& list = *dialog.findChild<QListWidget*>();
            QListWidgetItem* concrete = list.findItems("concrete", Qt::MatchExactly).value(0);
            QVERIFY(concrete);
            list.scrollToItem(concrete);
            QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(concrete).center());
            for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
                if (button->text().remove('&').startsWith("Use for")) QTest::mouseClick(button, Qt::LeftButton);
            }
        });
        act("material library");
        QTRY_COMPARE_WITH_TIMEOUT(findMaterial(project(), wall().material)->name, std::string("concrete"), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
    }
    void aBulletHoleIsStackedOverTheScatterAndDragged() {
        const std::size_t layers = wall().pattern.layers.size();
        act("add radial");
        QTRY_COMPARE_WITH_TIMEOUT(wall().pattern.layers.size(), layers + 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        const Vec2 from = hole().centre;
        drag(canvas(), pixels(from), pixels(from + Vec2(0.2, 0.15)));
        QVERIFY(glm::distance(hole().centre, from + Vec2(0.2, 0.15)) < 0.02);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
    }
    void whereItIsWeakIsPainted() {
        const std::size_t layers = wall().pattern.layers.size();
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_B, Qt::AltModifier);
        drag(canvas(), pixels({-0.4, -0.3}), pixels({-0.1, -0.3}));
        QCOMPARE(wall().pattern.layers.size(), layers + 1);
        QVERIFY(std::get<DensityImage>(wall().pattern.layers.back().parameters).image);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(), kPatience);
        m_pieces = bake().fragmentCount();
        QVERIFY(m_pieces > 100);
        QTest::keyClick(&canvas(), Qt::Key_Escape);
    }
    void crumbsGoIntoTheirNeighbours() {
        auto* rule = window().findChild<ShapingSection*>()->findChild<QComboBox*>();
        QVERIFY(rule);
        rule->setFocus();
        QTest::keyClick(rule, Qt::Key_Down);
        QCOMPARE(wall().shaping.smallPieces.rule, SmallPieceRule::Merge);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked() && bake().fragmentCount() < m_pieces, kPatience);
        double total = 0.0, least = 1.0;
        for (std::uint32_t k = 0; k < bake().fragmentCount(); ++k) {
            total += bake().fragment(k).solid.volume();
            least = std::min(least, bake().fragment(k).solid.volume());
        }
        QVERIFY(std::abs(total - bake().whole.volume) < 1e-9 * total);
        QVERIFY(least >= wall().shaping.smallPieces.limit * total / bake().fragmentCount() * (1.0 - 1e-9));
        m_pieces = bake().fragmentCount();
    }
    void bigPiecesAreBrokenAgain() {
        test::whenAsked<VolumeRangeDialog>([](VolumeRangeDialog& dialog) {
            auto& least = *dialog.findChildren<NumberField*>().front();
            least.setFocus();
            least.selectAll();
            QTest::keyClicks(&least, QString::number(0.6 * dialog.most(), 'g', 6));
            QTest::keyClick(&least, Qt::Key_Return);
            for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
                if (button->text().remove('&') == "Select") QTest::mouseClick(button, Qt::LeftButton);
            }
        });
        act("by volume");
        QTRY_VERIFY_WITH_TIMEOUT(!selection().seeds().empty(), kPatience);
        QVERIFY(selection().seeds().size() < m_pieces / 2);
        QTest::keyClick(&window(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(!wall().leaves.empty(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked() && bake().breakings.size() > 1, kPatience);
        QCOMPARE(bake().breakings.back().level, 1u);
    }
    void someAreIsolatedAndShownAgain() {
        QApplication::setActiveWindow(&window());
        canvas().setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(canvas().hasFocus() && !selection().seeds().empty(), kPatience);
        QTest::keyClick(&canvas(), Qt::Key_Slash);
        QVERIFY(!selection().hidden().isEmpty());
        QTest::keyClick(&canvas(), Qt::Key_H, Qt::AltModifier);
        QVERIFY(selection().hidden().isEmpty());
    }
    void variantsAreComparedSideBySide() {
        act("contact sheet");
        ContactSheetWindow* sheet = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((sheet = sheetShown()), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!sheet->maker().isBusy() && sheet->list().count() == 12, kPatience);
        const Pattern before = wall().pattern;
        QListWidget& list = sheet->list();
        QListWidgetItem* last = list.item(list.count() - 1);
        list.scrollToItem(last);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(last).center());
        QTest::keyClick(&list, Qt::Key_Return);
        QVERIFY(wall().pattern != before);
        if (sheetShown()) QTest::keyClick(sheet, Qt::Key_Escape);
    }
    void allOfItIsUndone() {
        while (stack().canUndo()) QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), m_before);
    }

private:
    const Asset& wall() { return project().assets.front(); }
    const RadialPattern& hole() { return std::get<RadialPattern>(wall().pattern.layers.back().parameters); }
    const Bake& bake() { return *window().workspace().bakes().find(wall().id)->bake; }
    bool isBaked() { return window().workspace().bakes().areCurrent(project()); }
    /// Searches an action by its name, and does it.
    void act(const QString& words) {
        window().activateWindow();
        QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QWidget* search = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((search = QApplication::activePopupWidget()), kPatience);
        auto* line = search->findChild<QLineEdit*>();
        QTest::keyClicks(line, words);
        QTest::keyClick(line, Qt::Key_Return);
    }
    static ContactSheetWindow* sheetShown() {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* sheet = qobject_cast<ContactSheetWindow*>(widget);
            if (sheet && sheet->isVisible()) return sheet;
        }
        return nullptr;
    }

    std::uint32_t m_pieces = 0;
};

QTEST_MAIN(ArtistStoryTest)
#include "ArtistStoryTest.moc"
