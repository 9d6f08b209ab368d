#include "editor/panels/inspector/FragmentSection.h"

#include "core/asset/bake/FragmentSets.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/LayeredBox.h"
#include "tests/support/editor/PlayStage.h"

#include <QLabel>
#include <QTest>

using namespace rubble;

namespace {

Project twoLevels() {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {layeredBox()};
    project.assets[0].threshold = 80.0;
    return project;
}

/// The section for a box of two halves, each of which breaks into quarters.
struct FragmentDesk {
    FragmentDesk() {
        selection.setAsset(asset().id);
        QObject::connect(&stage.document, &Document::changed, &section, &FragmentSection::refresh);  // as its page does
        window.resize(300, 200);
        window.show();
    }
    const Asset& asset() const { return stage.document.project().assets[0]; }
    void select(std::initializer_list<std::uint32_t> fragments) {
        const Bake& bake = *stage.bakes.find(asset().id)->bake;
        FragmentSet set(bake.fragmentCount(), false);
        for (const std::uint32_t k : fragments) set[k] = true;
        selection.setFragments(selectionOf(set, bake));
    }
    void breakAs(BreakAs breakAs) {
        Asset changed = asset();
        changed.breakAs = breakAs;
        stage.document.push({.text = "Break", .replacements = {Replacement<Asset>{changed.id, changed}}});
    }
    QCheckBox& neverBreaks() { return *section.findChild<QCheckBox*>("never-breaks"); }
    QCheckBox& box() { return *section.findChild<QCheckBox*>("override-fragment-threshold"); }
    SliderField& field() { return *section.findChild<SliderField*>(); }
    void enter(const QString& text) {
        auto* number = field().findChild<NumberField*>();
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, text);
        QTest::keyClick(number, Qt::Key_Return);
    }

    test::Stage stage{twoLevels()};
    Selection selection;
    QWidget window;
    FragmentSection section{stage.document, selection, stage.bakes, &window};
};

}  // namespace

class FragmentSectionTest : public QObject {
    Q_OBJECT
private slots:
    void hiddenWithoutSelectedFragments() {
        FragmentDesk desk;
        QVERIFY(desk.section.isHidden());
        desk.select({0});
        QVERIFY(!desk.section.isHidden());
    }
    void fragmentsThatDoNotBreakHaveNoThreshold() {
        FragmentDesk desk;
        desk.select({3});
        QVERIFY(desk.box().isHidden());
        QVERIFY(desk.section.findChildren<QLabel*>().last()->text().startsWith("None of the selected fragments"));
    }
    void thresholdOfOneFragmentIsSetAndUndone() {
        FragmentDesk desk;
        desk.select({1});
        QVERIFY(!desk.box().isChecked() && !desk.field().isEnabled());
        QTest::mouseClick(&desk.box(), Qt::LeftButton, {}, {8, desk.box().height() / 2});
        QCOMPARE(desk.asset().fragmentThresholds.size(), std::size_t{1});
        QCOMPARE(desk.asset().fragmentThresholds[0].fragment, FragmentPath("5.1"));
        desk.enter("3.25");
        QCOMPARE(desk.asset().fragmentThresholds, (std::vector<FragmentThreshold>{{"5.1", 3.25}}));
        desk.stage.document.undoStack().undo();
        desk.stage.document.undoStack().undo();
        QVERIFY(desk.asset().fragmentThresholds.empty());
    }
    void neverBreaksIsForBondedAssetsOnly() {
        FragmentDesk desk;
        desk.select({0, 3});
        QVERIFY(desk.neverBreaks().isHidden() && !desk.box().isHidden());
        desk.breakAs(BreakAs::Bonded);
        QVERIFY(!desk.neverBreaks().isHidden() && desk.box().isHidden());
        desk.select({});
        QVERIFY(desk.section.isHidden());
    }
    void severalFragmentsNeverBreakAtOnce() {
        FragmentDesk desk;
        desk.breakAs(BreakAs::Bonded);
        const auto press = [&] { desk.neverBreaks().click(); };
        desk.select({1});
        press();
        QCOMPARE(desk.asset().bonding.neverBreaks, std::vector<FragmentPath>{"5.1"});
        desk.select({0, 1});
        QCOMPARE(desk.neverBreaks().checkState(), Qt::PartiallyChecked);
        press();
        QCOMPARE(desk.asset().bonding.neverBreaks, (std::vector<FragmentPath>{"5.0", "5.1"}));
        QCOMPARE(desk.neverBreaks().checkState(), Qt::Checked);
        press();
        QVERIFY(desk.asset().bonding.neverBreaks.empty());
        desk.stage.document.undoStack().undo();
        desk.stage.document.undoStack().undo();
        QCOMPARE(desk.asset().bonding.neverBreaks, std::vector<FragmentPath>{"5.1"});
    }
    void onlyTheRootsOfTheSelectionNeverBreak() {
        FragmentDesk desk;
        desk.breakAs(BreakAs::Bonded);
        const Bake& bake = *desk.stage.bakes.find(desk.asset().id)->bake;
        const FragmentSet first = withDescendants(bake, [&] {
            FragmentSet set(bake.fragmentCount(), false);
            set[0] = true;
            return set;
        }());
        desk.selection.setFragments(selectionOf(first, bake));
        desk.neverBreaks().click();
        QCOMPARE(desk.asset().bonding.neverBreaks, std::vector<FragmentPath>{"5.0"});
    }
    void severalFragmentsAreSetAtOnce() {
        FragmentDesk desk;
        desk.select({0, 1, 2});
        QTest::mouseClick(&desk.box(), Qt::LeftButton, {}, {8, desk.box().height() / 2});
        desk.enter("4");
        QCOMPARE(desk.asset().fragmentThresholds, (std::vector<FragmentThreshold>{{"5.0", 4.0}, {"5.1", 4.0}}));
        QTest::mouseClick(&desk.box(), Qt::LeftButton, {}, {8, desk.box().height() / 2});
        QVERIFY(desk.asset().fragmentThresholds.empty());
    }
};

RUBBLE_TEST_WITH(FragmentSectionTest, QApplication)
#include "FragmentSectionTest.moc"
