#include "core/asset/FragmentPlace.h"
#include "editor/canvas/PlaceTrail.h"
#include "editor/panels/FragmentTable.h"
#include "tests/support/EditorStory.h"
#include "tests/support/Projects.h"

#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QStatusBar>
#include <QTableView>
#include <QToolButton>

using namespace rubble;

namespace {

/// A box of 1 m in four quarters, which a level breaks into four pieces each.
Project quarters() {
    Project project =
        boxProject(PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}});
    project.assets[0].name = "Wall";
    const PlacedSeeds four{{{0, {-0.12, -0.12}}, {1, {0.12, -0.12}}, {2, {0.12, 0.12}}, {3, {-0.12, 0.12}}}};
    project.assets[0].levels = {{.pattern = {{{.id = 4, .parameters = four}}}}};
    return project;
}

}  // namespace

/// Into a fragment and out again, by mouse and keys, with what is done in there.
class InsideStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() {
        openBaked(quarters());
        QVERIFY(isBaked(2, 20));
        canvas().setFocus();
    }
    void cleanupTestCase() { close(); }

    void aDoubleClickGoesIntoAFragment() {
        doubleClick(pixels({0.6, 0.6}));
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        QCOMPARE(canvas().shownPattern()->seeds().positions.size(), std::size_t{4});
        QVERIFY(trail().isVisible());
        QCOMPARE(trailTexts(), (QStringList{"Wall", "▸", "Fragment 3.2"}));
        QCOMPARE(levels().currentText(), QString("Fragments, level 1"));
        QCOMPARE(text(), m_before);
        QCOMPARE(stack().count(), 0);
    }
    void aSeedPlacedThereGivesItAPatternOfItsOwn() {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.0, 0.0}));
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 21), kPatience);
        QCOMPARE(stack().count(), 1);
        QCOMPARE(asset().leaves.size(), std::size_t{1});
        QCOMPARE(asset().leaves[0].fragment, FragmentPath("3.2"));
        QVERIFY(window().statusBar()->currentMessage().startsWith("Fragment 3.2 has a pattern of its own"));
        QCOMPARE(levels().currentText(), QString("Fragment 3.2"));
    }
    void whichIsUndoneInOneStep() {
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(text(), m_before);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 20), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        QCOMPARE(levels().currentText(), QString("Fragments, level 1"));
    }
    void aLassoChoosesPiecesWhichListAndViewChooseToo() {
        lasso({{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.02}, {-0.2, 0.02}});
        QVERIFY((selection().choice() == FragmentChoice{{{4, 0}, {4, 1}}, std::nullopt, "3.2"}));
        QCOMPARE(chosenIds(), (QStringList{"2/3.2/4.0", "2/3.2/4.1"}));
        QTRY_COMPARE(table().view().selectionModel()->selectedRows().size(), 2);
        if (hasView()) QTRY_COMPARE(bodiesMarked(kSelected), 2);
    }
    void theSelectMenuWorksInThere() {
        QTest::keyClick(&window(), Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(chosenIds(), (QStringList{"2/3.2/4.2", "2/3.2/4.3"}));
        QTest::keyClick(&window(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(chosenIds().size(), 4);
        QTest::keyClick(&window(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(selection().choice().isEmpty());
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.12, 0.12}));
        QTest::keyClick(&window(), Qt::Key_G, Qt::ControlModifier);
        QCOMPARE(chosenIds(), (QStringList{"2/3.2/4.1", "2/3.2/4.2", "2/3.2/4.3"}));
    }
    void aPieceChosenInTheListIsASeedInThere() {
        clickRow("2/3.2/4.3");
        QVERIFY((selection().choice() == FragmentChoice{{{4, 3}}, std::nullopt, "3.2"}));
        QVERIFY((selection().seeds() == Selection::Seeds{{4, 3}}));
        clickRow("2/3.1");
        QVERIFY(selection().seeds().empty());  // it is elsewhere
        QCOMPARE(chosenIds(), QStringList{"2/3.1"});
    }
    void keysGoOutAndIn() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 2}}));  // what one came from
        QVERIFY(!trail().isVisible());
        QVERIFY(!action("fragment-out")->isEnabled());
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        QVERIFY(selection().choice().isEmpty());
        QCOMPARE(text(), m_before);  // no arrow key moved a seed
    }
    void aDoubleClickWhereNothingIsBrokenPlacesOneSeed() {
        const int steps = stack().index();
        doubleClick(pixels({0.0, 0.05}));
        QVERIFY(isInside("3.2"));
        QCOMPARE(stack().index(), steps + 1);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 21), kPatience);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 20), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        selection().setSeeds({});
    }
    void whoComesOutSeesWhatWasSeenBefore() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
        const CanvasView fitted = canvas().view();
        canvas().zoomBy(1.7);
        const CanvasView near = canvas().view();
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        QVERIFY(canvas().view() != near);  // the fragment is fitted
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
        QVERIFY(canvas().view() == near);
        canvas().fit();
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        QTest::keyClick(&canvas(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
        QVERIFY(canvas().view() == fitted);
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
    }
    void whatIsNotBrokenAgainIsFracturedFirst() {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.12, 0.12}));
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QVERIFY(isInside("3.2"));
        QVERIFY(window().statusBar()->currentMessage().startsWith("Fragment 3.2/4.2 is not broken again."));
        QCOMPARE(text(), m_before);

        QTest::keyClick(&window(), Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(asset().leaves[0].fragment, FragmentPath("3.2/4.2"));
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 25), kPatience);
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2/4.2"), kPatience);
        QCOMPARE(trailTexts(), (QStringList{"Wall", "▸", "Fragment 3.2", "▸", "Fragment 4.2"}));
        QCOMPARE(canvas().shownPattern()->partition().pieceCount(), 5u);
    }
    void whatIsGoneIsLeftForTheNearest() {
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2"), kPatience);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isBaked(2, 25), kPatience);
        QVERIFY(isInside("3.2"));
    }
    void aClickOnTheTrailGoesOutToIt() {
        doubleClick(pixels({0.05, 0.05}));
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.2/4.2"), kPatience);
        QList<QToolButton*> buttons = trail().findChildren<QToolButton*>();
        erase_if(buttons, [](const QToolButton* button) { return button->isHidden(); });
        QCOMPARE(buttons.size(), 2);
        QTest::mouseClick(buttons[0], Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
        QVERIFY((selection().seeds() == Selection::Seeds{{3, 2}}));
    }
    void aPieceOfAPieceChosenAnywhereLeadsToWhereItIsMade() {
        clickRow("2/3.0/4.1");
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.0"), kPatience);
        QVERIFY((selection().choice() == FragmentChoice{{{4, 1}}, std::nullopt, "3.0"}));
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
    }
    void anotherAssetIsSeenAsAWhole() {
        QTest::keyClick(&canvas(), Qt::Key_Down, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(isInside("3.0"), kPatience);
        QTest::keyClick(&window(), Qt::Key_D, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(selection().asset() != 2, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(isInside(""), kPatience);
        QVERIFY(!trail().isVisible());
    }

private:
    const Asset& asset() { return *findAsset(project(), 2); }
    bool isInside(const FragmentPath& path) {
        const ShownPattern* shown = canvas().shownPattern();
        return selection().inside() == path && shown && shown->baked().inside == path;
    }
    void doubleClick(QPoint at) {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, at);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at);
    }
    const Bake& bake() { return *window().workspace().bakes().find(2)->bake; }
    QStringList chosenIds() {
        QStringList ids;
        const FragmentSet set = fragmentsOf(selection().choice(), bake());
        for (std::uint32_t k = 0; k < set.size(); ++k) {
            if (set[k]) ids.append(QString::fromStdString(bake().fragmentId(k)));
        }
        ids.sort();
        return ids;
    }
    PlaceTrail& trail() { return *window().findChild<PlaceTrail*>(); }
    QStringList trailTexts() {
        QStringList texts;
        for (int k = 0; k < trail().layout()->count(); ++k) {
            const QWidget* widget = trail().layout()->itemAt(k)->widget();
            const auto* label = qobject_cast<const QLabel*>(widget);
            texts.append(label ? label->text() : static_cast<const QToolButton*>(widget)->text());
        }
        return texts;
    }
    QComboBox& levels() {
        for (QComboBox* box : window().findChildren<QComboBox*>()) {
            if (box->accessibleName() == "Level") return *box;
        }
        qFatal("There is no list of levels.");
    }
    FragmentTable& table() { return *window().findChild<FragmentTable*>(); }
    void clickRow(const QString& id) {
        QTableView& view = table().view();
        const QModelIndexList found =
            view.model()->match(view.model()->index(0, 0), Qt::DisplayRole, id, 1, Qt::MatchExactly);
        QVERIFY2(!found.isEmpty(), qPrintable(id));
        view.scrollTo(found.front());
        QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, view.visualRect(found.front()).center());
    }
};

QTEST_MAIN(InsideStoryTest)
#include "InsideStoryTest.moc"
