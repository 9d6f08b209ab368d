// Tests editor/panels/inspector/BondSection.cpp, editor/panels/inspector/HeightStrengthEditor.cpp,
// editor/panels/inspector/NumberDelegate.cpp and editor/panels/models/HeightStrengthModel.cpp.
#include "editor/panels/inspector/BondSection.h"

#include "core/asset/checks/VerifyProject.h"
#include "editor/panels/inspector/PictureField.h"
#include "editor/widgets/SliderField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>

using namespace rubble;
using test::InspectorDesk;

namespace {

/// The inspector with the asset 9, "box", which breaks as bonded, and after the test with the project as it was.
struct BondDesk : InspectorDesk {
    BondDesk() {
        selection.setAsset(9);
        select("Break as", BreakAs::Bonded);
    }
    BondSection& section() { return *inspector.page().findChild<BondSection*>(); }
    const Bonding& bonds() const { return asset().bonding; }
    template <class Value>
    void select(const QString& name, Value value) {
        auto& box = control<QComboBox>(name);
        const int row = box.findData(static_cast<Id>(value));
        box.setCurrentIndex(row);
        emit box.activated(row);
    }
    QPushButton& button(const QString& name) { return control<QPushButton>(name); }
    QLabel& derivation() { return *section().findChild<QLabel*>("bondDerivation"); }
    HeightStrengthEditor& heights() { return *section().findChild<HeightStrengthEditor*>(); }
    QString heightsText() {
        QString text;
        for (const auto& [height, factor] : bonds().heightStrengths)
            text += QString("%1 m: %2, ").arg(height).arg(factor);
        return text;
    }
    bool isRestored() {
        if (verifyProject(document.project())) return false;
        undoAll();
        return text() == projectText(fullProject());
    }
};

}  // namespace

class BondSectionTest : public QObject {
    Q_OBJECT
private slots:
    void isShownForBondedAssetsOnly() {
        BondDesk desk;
        QCOMPARE(desk.asset().breakAs, BreakAs::Bonded);
        QVERIFY(desk.section().isVisible());
        desk.select("Break as", BreakAs::Whole);
        QVERIFY(!desk.section().isVisible());
        QCOMPARE(desk.document.undoStack().count(), 2);
        QVERIFY(desk.isRestored());
    }
    void bondedAssetsHaveNoThreshold() {
        BondDesk desk;
        const auto isShown = [&](const char* name) { return desk.control<QWidget>(name).isVisible(); };
        QVERIFY(!isShown("Threshold") && !isShown("Source") && isShown("Contact time"));
        desk.select("Bond strength", Id{1});  // entered
        QVERIFY(!isShown("Contact time"));
        desk.select("Break as", BreakAs::Whole);
        QVERIFY(isShown("Threshold") && isShown("Source"));
        QVERIFY(desk.isRestored());
    }
    void numbersChangeTheBonds() {
        BondDesk desk;
        desk.type("Falloff radius", "0.75");
        desk.type("Damage limit", "25");
        desk.type("Maximum span", "2.5");
        desk.type("Collapse delay", "1.5");
        desk.type("Smallest island", "4");
        desk.select("Falloff curve", HitFalloff::Smooth);
        QCOMPARE(desk.bonds(), (Bonding{.radius = 0.75,
                                        .falloff = HitFalloff::Smooth,
                                        .damageFrom = 0.25,
                                        .span = 2.5,
                                        .collapseDelay = 1.5,
                                        .minimumIsland = 4}));
        QCOMPARE(desk.document.undoStack().count(), 7);
        desk.type("Damage limit", "0");
        desk.type("Falloff radius", "0");
        QCOMPARE(desk.document.undoStack().count(), 7);
        desk.inspector.setUnits({LengthUnit::Centimetre});
        desk.type("Maximum span", "30");
        QCOMPARE(desk.bonds().span, 0.3);
        QVERIFY(desk.isRestored());
    }
    void dragOfASliderIsOneStep() {
        BondDesk desk;
        test::drag(desk.control<SliderField>("Falloff radius").slider());
        QVERIFY(desk.bonds().radius > 4.0);
        QCOMPARE(desk.document.undoStack().count(), 2);
        QVERIFY(desk.isRestored());
    }
    void impulseIsEnteredOrFollowsFromTheMaterial() {
        BondDesk desk;
        QVERIFY(!desk.control<SliderField>("Impulse per area").isVisible());
        QCOMPARE(desk.derivation().text(),
                 "Material \"brick\" has no strength. Enter its strength, or the impulse per area.");
        Material brick = desk.document.project().materials[0];
        brick.tensileStrength = 2e6;
        desk.document.push({.text = "Strengthen", .replacements = {Replacement<Material>{brick.id, brick}}});
        QVERIFY(!desk.control<SliderField>("Impulse per area").isEnabled());
        QCOMPARE(desk.control<SliderField>("Impulse per area").value(), 2000.0);
        QCOMPARE(desk.derivation().text().replace(QChar(0xa0), ' '),
                 "2000 N·s/m² follows from the strength 2 MPa and the contact time 1 ms.");
        desk.select("Bond strength", 1);
        QCOMPARE(desk.bonds().impulsePerArea, std::optional(2000.0));  // keeps its value
        QVERIFY(!desk.derivation().isVisible());
        desk.type("Impulse per area", "750");
        QCOMPARE(desk.bonds().impulsePerArea, std::optional(750.0));
        desk.select("Bond strength", 2);
        QVERIFY(!desk.bonds().impulsePerArea);
        QVERIFY(desk.isRestored());
    }
    void strengthsByHeightAreAddedEditedAndDeleted() {
        BondDesk desk;
        QVERIFY(!desk.heights().view().isVisible());
        auto& add = desk.control<QToolButton>("Add Height");
        add.click();
        QCOMPARE(desk.heightsText(), "0 m: 1, ");
        QVERIFY(desk.heights().view().isVisible());
        add.click();
        add.click();
        QCOMPARE(desk.heightsText(), "0 m: 1, 0.5 m: 1, 0.75 m: 1, ");  // of an outline that is 1 m high
        HeightStrengthModel& model = desk.heights().model();
        QVERIFY(model.setData(model.index(1, HeightStrengthModel::Factor), 2.5, Qt::EditRole));
        QVERIFY(model.setData(model.index(0, HeightStrengthModel::Height), 0.6, Qt::EditRole));
        QCOMPARE(desk.heightsText(), "0.5 m: 2.5, 0.6 m: 1, 0.75 m: 1, ");
        QCOMPARE(model.index(0, HeightStrengthModel::Factor).data(Qt::ToolTipRole).toString().replace(QChar(0xa0), ' '),
                 "At a height of 0.5 m, bonds are 2.5 times as strong");
        QVERIFY(!model.setData(model.index(0, HeightStrengthModel::Height), 0.75, Qt::EditRole));
        QCOMPARE(desk.refusals.last()[0].toString().replace(QChar(0xa0), ' '),
                 "There is a strength at the height 0.75 m already. Enter another height.");
        desk.heights().view().setCurrentIndex(model.index(1, 0));
        desk.control<QToolButton>("Delete Heights").click();
        QCOMPARE(desk.heightsText(), "0.5 m: 2.5, 0.75 m: 1, ");
        QCOMPARE(desk.document.undoStack().count(), 7);
        QVERIFY(desk.isRestored());
    }
    void strengthsByHeightAreTyped() {
        BondDesk desk;
        desk.control<QToolButton>("Add Height").click();
        QTableView& view = desk.heights().view();
        const QModelIndex cell = desk.heights().model().index(0, HeightStrengthModel::Height);
        view.setCurrentIndex(cell);
        view.edit(cell);
        auto* field = view.viewport()->findChild<NumberField*>();
        QVERIFY(field);
        field->selectAll();
        QTest::keyClicks(field, "-1");
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(!field->refusal().isEmpty());  // stays open
        field->selectAll();
        QTest::keyClicks(field, "0.25");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(desk.heightsText(), "0.25 m: 1, ");
        QVERIFY(desk.isRestored());
    }
    void pictureIsSetAndCleared() {
        BondDesk desk;
        auto& picture = *desk.section().findChild<PictureField*>();
        auto& clear = *picture.findChild<QPushButton*>("clearPicture");
        QVERIFY(!clear.isVisible() && !desk.control<SliderField>("Darkest").isVisible());
        QTemporaryDir folder;
        QImage image(4, 2, QImage::Format_Grayscale8);
        image.fill(40);
        QVERIFY(image.save(folder.filePath("grey.png")));
        picture.load(folder.filePath("grey.png"));
        QVERIFY(desk.bonds().strengthImage && desk.bonds().strengthImage->image->width == 4);
        desk.type("Darkest", "0.25");
        desk.type("Brightest", "3");
        QCOMPARE(desk.bonds().strengthImage->darkest, 0.25);
        QCOMPARE(desk.bonds().strengthImage->brightest, 3.0);
        picture.load(folder.filePath("none.png"));
        QCOMPARE(desk.refusals.count(), 1);
        QCOMPARE(desk.document.undoStack().count(), 4);
        clear.click();
        QVERIFY(!desk.bonds().strengthImage && !clear.isVisible());
        QVERIFY(desk.isRestored());
    }
    void strokesAreCountedAndClearedByBrush() {
        InspectorDesk desk;  // asset 3 has a stroke of each brush
        desk.selection.setAsset(3);
        const auto brushes = [&] {
            QString text;
            for (const BondStroke& stroke : desk.asset(3).bonding.strokes)
                text += QString::number(static_cast<int>(stroke.brush));
            return text;
        };
        QCOMPARE(brushes(), "120");
        auto& section = *desk.inspector.page().findChild<BondSection*>();
        const auto brushesWithOneStroke = [&] {
            return std::ranges::count_if(section.findChildren<QLabel*>(), [](const QLabel* label) {
                return label->text().startsWith("1 stroke");  // "(s)" without a translation
            });
        };
        QCOMPARE(brushesWithOneStroke(), 3);
        desk.control<QPushButton>("Clear Strength Strokes").click();
        QCOMPARE(brushes(), "20");
        QCOMPARE(brushesWithOneStroke(), 2);
        QVERIFY(!desk.control<QPushButton>("Clear Strength Strokes").isEnabled());
        desk.control<QPushButton>("Clear Anchor Strokes").click();
        desk.control<QPushButton>("Clear Never-Breaks Strokes").click();
        QCOMPARE(brushes(), "");
        QCOMPARE(desk.document.undoStack().count(), 3);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void assetsThatAreCutAtImpactSayThatTheyAreNot() {
        BondDesk desk;
        auto& note = *desk.section().findChild<QLabel*>("cutNote");
        QVERIFY(!note.isVisible());
        desk.selection.setAsset(3);
        QVERIFY(desk.asset(3).cutAtImpact && note.isVisible());
        QVERIFY(desk.isRestored());
    }
};

RUBBLE_TEST_WITH(BondSectionTest, QApplication)
#include "BondSectionTest.moc"
