#include "editor/panels/inspector/Inspector.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/base/Random.h"
#include "core/io/project/ProjectFile.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/commands/Resizing.h"
#include "editor/panels/inspector/OutlineEditor.h"
#include "editor/panels/inspector/PatternEditor.h"
#include "editor/panels/inspector/PictureField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/TestImages.h"

#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyle>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>

using namespace rubble;

namespace {

/// A document with the inspector in a window.
struct InspectorDesk {
    Document document;
    Selection selection;
    Bakes bakes;
    Inspector inspector{document, selection, bakes};
    QSignalSpy refusals{&inspector, &Inspector::refused};

    explicit InspectorDesk(Project project = fullProject()) : document(std::move(project)) {
        selection.prune(document.project());
        inspector.resize(360, 900);
        inspector.show();
        inspector.activateWindow();
        if (!QTest::qWaitForWindowActive(&inspector, kPatience)) qFatal("The window does not become active.");
    }
    const Asset& asset(Id id = 9) const { return *findAsset(document.project(), id); }
    std::string text() const { return projectText(document.project()); }

    /// The control of the visible page with this accessible name.
    template <class Control>
    Control& control(const QString& name) {
        for (Control* control : inspector.page().findChildren<Control*>()) {
            if (control->accessibleName() == name) return *control;
        }
        qFatal("There is no control \"%s\".", qPrintable(name));
    }
    void type(const QString& name, const QString& text) {
        auto& field = control<NumberField>(name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    void undoAll() {
        while (document.undoStack().canUndo()) document.undoStack().undo();
    }
};

/// Drags a slider's handle to its right end.
void drag(QSlider& slider) {
    constexpr int kHalfHandle = 6;
    const int middle = slider.height() / 2;
    const int from = kHalfHandle + QStyle::sliderPositionFromValue(slider.minimum(), slider.maximum(), slider.value(),
                                                                   slider.width() - 2 * kHalfHandle);
    QTest::mousePress(&slider, Qt::LeftButton, {}, {from, middle});
    for (int x = from; x < slider.width(); x += 5) QTest::mouseMove(&slider, {x, middle});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {slider.width() - 2, middle});
}

double width(const Asset& asset) { return boundsOf(asset.prism.outline.outer).size().x; }

}  // namespace

class InspectorTest : public QObject {
    Q_OBJECT
private slots:
    void pageFollowsTheSubject() {
        InspectorDesk desk;
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::AssetPage");
        desk.selection.setMaterial(2);
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::MaterialPage");
        desk.selection.setInstances(desk.document.project(), {20, 21});
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::InstancePage");
        desk.selection.setSubject(Part::Scene);
        QCOMPARE(desk.inspector.page().metaObject()->className(), "rubble::ScenePage");
    }
    void typedNumbersChangeTheDocument() {
        InspectorDesk desk;
        desk.inspector.setLocale(QLocale(QLocale::German, QLocale::Germany));
        desk.selection.setAsset(9);
        desk.type("Threshold", "12,5");
        QCOMPARE(desk.asset().threshold, 12.5);
        desk.inspector.setUnits({LengthUnit::Centimetre});
        desk.type("Depth", "7,25");
        QCOMPARE(desk.asset().prism.depth, 0.0725);
        QCOMPARE(desk.document.undoStack().count(), 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
        QCOMPARE(desk.control<NumberField>("Depth").value(), 0.5);
    }
    void textureIsShownAndRemoved() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto* row = desk.inspector.findChild<QLabel*>("texture");
        QVERIFY(!row->isVisibleTo(&desk.inspector));
        Asset asset = desk.asset();
        asset.texture = Texture{.name = "checker.png",
                                .image = std::make_shared<const EncodedImage>(imageOf(checkerPng())),
                                .materials = {0}};
        desk.document.push(modify("import", asset));
        QVERIFY(row->isVisibleTo(&desk.inspector));
        QCOMPARE(row->text(), QString("checker.png (16 × 16)"));
        desk.inspector.findChild<QPushButton*>("removeTexture")->click();
        QVERIFY(!desk.asset().texture && !row->isVisibleTo(&desk.inspector));
        desk.document.undoStack().undo();
        QVERIFY(desk.asset().texture == asset.texture && row->isVisibleTo(&desk.inspector));
    }
    void sliderDragIsOneUndoStep() {
        InspectorDesk desk;
        desk.selection.setMaterial(1);
        drag(desk.control<SliderField>("Friction").slider());
        QVERIFY(findMaterial(desk.document.project(), 1)->friction > 1.0);
        QCOMPARE(desk.document.undoStack().count(), 1);
        drag(desk.control<SliderField>("Density").slider());
        QCOMPARE(desk.document.undoStack().count(), 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void showingChangesNothing() {
        InspectorDesk desk;
        for (const LengthUnit unit : {LengthUnit::Metre, LengthUnit::Millimetre}) {
            desk.inspector.setUnits({unit});
            for (const Id asset : {3u, 9u, 11u}) desk.selection.setAsset(asset);
            for (const Id material : {1u, 2u}) desk.selection.setMaterial(material);
            desk.selection.setInstances(desk.document.project(), {21});
            for (int k = 0; k < 40; ++k) QTest::keyClick(desk.inspector.focusWidget(), Qt::Key_Tab);
            desk.selection.setSubject(Part::Scene);
            for (int k = 0; k < 40; ++k) QTest::keyClick(desk.inspector.focusWidget(), Qt::Key_Tab);
        }
        QCOMPARE(desk.document.undoStack().count(), 0);
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void invalidNamesAndNumbersAreRefused() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& name = desk.control<QLineEdit>("Name");
        name.setFocus();
        name.selectAll();
        QTest::keyClicks(&name, "wall");
        QTest::keyClick(&name, Qt::Key_Return);
        QCOMPARE(desk.refusals.count(), 1);
        QCOMPARE(desk.refusals[0][0], "The name \"wall\" is already taken.");
        QCOMPARE(name.text(), "box");
        desk.type("Depth", "0");
        desk.type("Width", "1e300");
        QCOMPARE(desk.document.undoStack().count(), 0);
        QCOMPARE(desk.control<NumberField>("Width").value(), 1.0);
    }
    void resizingStretchesOutlineSeedsAndUvs() {
        const Asset wall = fullProject().assets[0];
        const Vec3 size = sizeOf(wall);
        const Asset wide = resized(wall, {size.x * 2.0, size.y, size.z});
        QCOMPARE(width(wide), size.x * 2.0);
        QVERIFY(validated(wide.prism).hasValue());
        const auto uOf = [](const Asset& asset, Vec2 at) {
            const auto& c = asset.surface->front.map.coefficients;
            return c[0] * at.x + c[1] * at.y + c[2];
        };
        for (std::size_t k = 0; k < wall.prism.outline.outer.size(); ++k) {
            QCOMPARE(uOf(wide, wide.prism.outline.outer[k]), uOf(wall, wall.prism.outline.outer[k]));
        }
        const auto placedSeeds = [](const Asset& asset) {
            return std::get<PlacedSeeds>(asset.pattern.layers[2].parameters).seeds;
        };
        const double middle = width(wall) / 2.0 + boundsOf(wall.prism.outline.outer).min.x;
        QCOMPARE(placedSeeds(wide)[0].position.x - middle, 2.0 * (placedSeeds(wall)[0].position.x - middle));
        QCOMPARE(resized(wall, size), wall);
    }
    void typedPointsAreValidated() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<OutlineEditor*>();
        const QModelIndex cell = editor.model().index(2, 0);
        editor.view().setCurrentIndex(cell);
        editor.view().edit(cell);
        auto* field = editor.view().viewport()->findChild<NumberField*>();
        QVERIFY(field);
        field->selectAll();
        QTest::keyClicks(field, "1.25");
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(desk.asset().prism.outline.outer[2].x, 1.25);
        QVERIFY(!editor.model().setData(editor.model().index(2, 1), -5.0, Qt::EditRole));
        QCOMPARE(desk.refusals.count(), 1);
        QVERIFY2(desk.refusals[0][0].toString().contains("outline"), qPrintable(desk.refusals[0][0].toString()));
        editor.model().insertAfter(0);
        QCOMPARE(desk.asset().prism.outline.outer.size(), 5u);
        QVERIFY(editor.model().addHole());
        QCOMPARE(desk.asset().prism.outline.holes.size(), 1u);
        editor.model().removePoints({0, 1, 2});
        QCOMPARE(desk.refusals.last()[0], "An outline needs at least three points. Delete fewer.");
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void layersAreAddedMovedDisabledAndDeleted() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.addLayer(LloydRelaxation{});
        QCOMPARE(desk.asset(3).pattern.layers.size(), 5u);
        const Id added = desk.asset(3).pattern.layers.back().id;
        QTest::mouseClick(&desk.control<QToolButton>("Move Up"), Qt::LeftButton);
        QCOMPARE(desk.asset(3).pattern.layers[3].id, added);
        const QRect row = editor.view().visualRect(editor.view().currentIndex());
        editor.view().setFocus();
        QTest::keyClick(&editor.view(), Qt::Key_Space);
        QVERIFY2(!desk.asset(3).pattern.layers[3].isOn, qPrintable(QString::number(row.height())));
        QTest::mouseClick(&desk.control<QToolButton>("Delete Layer"), Qt::LeftButton);
        QCOMPARE(desk.asset(3).pattern.layers.size(), 4u);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void aLayerThatTheMenuAddsBecomesCurrent() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        const QListView& view = desk.inspector.page().findChild<PatternEditor*>()->view();
        desk.document.push(addLayer(desk.document.project(), 3, LloydRelaxation{}).edit);
        QCOMPARE(view.currentIndex().row(), 4);
        desk.document.undoStack().undo();
        QCOMPARE(view.currentIndex().row(), 0);
    }
    void everyParameterOfEveryKindIsEditable() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        for (const PatternKind* kind : patternKinds()) {
            editor.addLayer(kind->defaultsFor(domainBounds(desk.asset())));
            const PatternLayer added = desk.asset().pattern.layers.back();
            for (const LayerParameter& parameter : kind->parameters) {
                if (parameter.type != ParameterType::Real || !parameter.isUsed(added.parameters)) continue;
                auto& field = desk.control<NumberField>(parameter.caption);
                QVERIFY2(field.isVisible(), parameter.caption);
                const bool isWithin = parameter.range.contains(0.75);
                desk.type(parameter.caption, isWithin ? "0.75" : "1.5");
                const double factor = parameter.quantity == Quantity::Angle ? 0x1.1df46a2529d39p-6 : 1.0;
                const auto typed = std::get<double>(parameter.read(desk.asset().pattern.layers.back().parameters));
                QVERIFY2(std::abs(typed - (isWithin ? 0.75 : 1.5) * factor) < 1e-15, parameter.caption);
            }
        }
        QCOMPARE(desk.refusals.count(), 0);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void pointAndOptionParametersAreEditable() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.addLayer(RadialPattern{});
        desk.type("Centre y", "0.25");
        QVERIFY(std::get<RadialPattern>(desk.asset().pattern.layers.back().parameters).centre == Vec2(0.0, 0.25));
        editor.addLayer(JitteredGrid{});
        QVERIFY(desk.control<NumberField>("Columns").isVisible() &&
                !desk.control<NumberField>("Cell width").isVisible());
        auto& grid = desk.control<QComboBox>("Grid");
        grid.setCurrentIndex(1);
        emit grid.activated(1);
        QVERIFY(!desk.control<NumberField>("Columns").isVisible() &&
                desk.control<NumberField>("Cell width").isVisible());
        desk.type("Jitter", "1.5");
        QCOMPARE(std::get<JitteredGrid>(desk.asset().pattern.layers.back().parameters).jitter, 0.5);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void countsAreExpressedInThreeWays() {
        InspectorDesk desk;
        desk.selection.setAsset(9);  // a square metre
        const auto count = [&] { return std::get<UniformScatter>(desk.asset().pattern.layers[0].parameters).count; };
        const auto select = [&](int way) {
            auto& box = desk.control<QComboBox>("Count by");
            box.setCurrentIndex(way);
            emit box.activated(way);
        };
        desk.type("Count", "25");
        select(1);
        QVERIFY(count() == SeedCount(CountBy::Density, 25.0));
        select(2);
        QVERIFY(count() == SeedCount(CountBy::FragmentSize, 0.2));
        desk.type("Fragment size", "0.1");
        select(0);
        QVERIFY(count() == SeedCount(100));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void picturesAreLoadedAndInvalidOnesRefused() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        desk.inspector.page().findChild<PatternEditor*>()->addLayer(DensityImage{});
        auto& picture = *desk.inspector.page().findChild<PictureField*>();
        QVERIFY(picture.isVisible());
        QTemporaryDir folder;
        QImage image(4, 2, QImage::Format_Grayscale8);
        image.fill(40);
        QVERIFY(image.save(folder.filePath("grey.png")));
        picture.load(folder.filePath("grey.png"));
        const auto& loaded = std::get<DensityImage>(desk.asset().pattern.layers.back().parameters).image;
        QVERIFY(loaded && loaded->width == 4 && loaded->grey[7] == 40);
        picture.load(folder.filePath("none.png"));
        QCOMPARE(desk.refusals.count(), 1);
        QVERIFY(image.scaled(2000, 1000).save(folder.filePath("large.png")));
        picture.load(folder.filePath("large.png"));
        QCOMPARE(desk.refusals.last()[0], "\"large.png\" was reduced from 2000 × 1000 to 1024 × 512 pixels.");
        const auto& reduced = std::get<DensityImage>(desk.asset().pattern.layers.back().parameters).image;
        QVERIFY(reduced->width == 1024 && reduced->height == 512 && reduced->grey[0] == 40);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void layersAreMovedByKeysAndDragging() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        const auto order = [&] {
            std::vector<Id> ids;
            for (const PatternLayer& layer : desk.asset(3).pattern.layers) ids.push_back(layer.id);
            return ids;
        };
        const std::vector<Id> first = order();
        editor.showLayer(first[2]);
        editor.view().setFocus();
        QTest::keyClick(&editor.view(), Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(order(), (std::vector{first[0], first[2], first[1], first[3]}));
        QTest::keyClick(&editor.view(), Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(order(), first);
        const int steps = desk.document.undoStack().count();
        // What a view does when a row is dropped before another one, or after the last.
        QAbstractItemModel& rows = *editor.view().model();
        QVERIFY(rows.moveRow({}, 0, {}, 4));
        QCOMPARE(order(), (std::vector{first[1], first[2], first[3], first[0]}));
        QVERIFY(rows.moveRow({}, 3, {}, 1));
        QCOMPARE(order(), (std::vector{first[1], first[0], first[2], first[3]}));
        QVERIFY(!rows.moveRow({}, 1, {}, 2));
        QCOMPARE(desk.document.undoStack().count(), steps + 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void collapsedSectionsAreRestored() {
        InspectorDesk desk, next;
        for (auto* section : desk.inspector.findChildren<Section*>()) {
            QVERIFY(!section->isCollapsed());
            if (section->objectName() == "shape") section->setCollapsed(true);
        }
        QCOMPARE(desk.inspector.collapsedSections(), QStringList{"shape"});
        next.inspector.setCollapsedSections(desk.inspector.collapsedSections());
        QCOMPARE(next.inspector.collapsedSections(), QStringList{"shape"});
        next.inspector.setCollapsedSections({});
        QCOMPARE(next.inspector.collapsedSections(), QStringList{});
    }
    void levelsAreAddedAndDeleted() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        QTest::mouseClick(&desk.control<QToolButton>("Add Level"), Qt::LeftButton);
        QCOMPARE(desk.asset().levels.size(), 1u);
        desk.type("Minimum volume", "0.001");
        QCOMPARE(desk.asset().levels[0].minimumVolume, 0.001);
        desk.type("Count", "6");
        QCOMPARE(std::get<UniformScatter>(desk.asset().levels[0].pattern.layers[0].parameters).count, SeedCount(6));
        QVERIFY(!verifyProject(desk.document.project()));
        QTest::mouseClick(&desk.control<QToolButton>("Delete Level"), Qt::LeftButton);
        QVERIFY(desk.asset().levels.empty());
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void fragmentsAreShaped() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        QVERIFY(!desk.control<SliderField>("Minimum size").isVisible());
        const auto select = [&](const QString& name, int row) {
            auto& box = desk.control<QComboBox>(name);
            box.setCurrentIndex(row);
            emit box.activated(row);
        };
        select("Small fragments", 1);
        QCOMPARE(desk.asset().shaping.smallPieces.rule, SmallPieceRule::Merge);
        QVERIFY(desk.control<SliderField>("Minimum size").isVisible());
        select("Measured by", 2);
        QCOMPARE(desk.asset().shaping.smallPieces.measure, PieceMeasure::Area);
        QCOMPARE(desk.asset().shaping.smallPieces.limit, 0.001);
        desk.type("Gap", "0.004");
        QCOMPARE(desk.asset().shaping.gap, 0.004);
        desk.type("Roughness", "0.01");
        QCOMPARE(desk.asset().shaping.roughness.amplitude, 0.01);
        select("Inside material", 2);
        QCOMPARE(desk.asset().insideMaterial, Id{2});
        QVERIFY(!verifyProject(desk.document.project()));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void fragmentPatternsAreEditedLikeLevels() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& levels = desk.control<QComboBox>("Pattern");
        QCOMPARE(levels.count(), 5);
        QCOMPARE(levels.itemText(3), QString("Fragment 4.3.1, kept intact"));
        emit levels.activated(4);
        QCOMPARE(levels.currentText(), QString("Fragment 6.0"));
        desk.type("Minimum volume", "0.25");
        QCOMPARE(desk.asset(3).fragmentLevels[1].level->minimumVolume, 0.25);
        desk.type("Count", "9");
        QCOMPARE(std::get<UniformScatter>(desk.asset(3).fragmentLevels[1].level->pattern.layers[0].parameters).count,
                 SeedCount(9));
        QTest::mouseClick(&desk.control<QToolButton>("Delete Level"), Qt::LeftButton);
        QCOMPARE(desk.asset(3).fragmentLevels.size(), std::size_t{1});
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void overridesAreRestoredAndSeedsRandomized() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.showLayer(4);
        const auto buttons = editor.findChildren<QPushButton*>();
        const auto restore = std::ranges::find(buttons, "Restore Seeds", &QPushButton::text);
        QVERIFY(restore != buttons.end());
        QTest::mouseClick(*restore, Qt::LeftButton);
        QVERIFY(desk.asset(3).pattern.layers[0].overrides.empty());
        QVERIFY(!(*restore)->isEnabled());
        auto& seed = *editor.findChild<RandomSeedField*>();
        QCOMPARE(seed.value(), ~quint64{0});
        QTest::mouseClick(&seed.randomizeButton(), Qt::LeftButton);
        QVERIFY(desk.asset(3).pattern.layers[0].randomSeed < 1'000'000u);
        seed.line().setFocus();
        seed.line().selectAll();
        QTest::keyClicks(&seed.line(), "-3");
        QTest::keyClick(&seed.line(), Qt::Key_Return);
        QCOMPARE(desk.refusals.count(), 1);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void editChangesAllSelectedInstances() {
        InspectorDesk desk;
        desk.selection.setInstances(desk.document.project(), {20, 21});
        QVERIFY(desk.control<NumberField>("Position x").isMixed());
        desk.type("Position x", "3");
        for (const Instance& instance : desk.document.project().instances) QCOMPARE(instance.pose.position.x, 3.0);
        QCOMPARE(desk.document.undoStack().count(), 1);
        auto& fixed = *[&] {
            for (QCheckBox* box : desk.inspector.page().findChildren<QCheckBox*>()) {
                if (box->text() == "Fixed") return box;
            }
            qFatal("There is no check box \"Fixed\".");
        }();
        QCOMPARE(fixed.checkState(), Qt::PartiallyChecked);
        fixed.setFocus();
        QTest::keyClick(&fixed, Qt::Key_Space);
        QVERIFY(desk.document.project().instances[0].isFixed == desk.document.project().instances[1].isFixed);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void fixedAndUnbreakableAreTwoCheckBoxes() {
        InspectorDesk desk;
        desk.selection.setInstances(desk.document.project(), {20});
        const Instance& instance = desk.document.project().instances[0];
        const auto press = [&](const char* text) {
            for (QCheckBox* box : desk.inspector.page().findChildren<QCheckBox*>()) {
                if (box->text() == text) return box->click();
            }
            qFatal("There is no check box \"%s\".", text);
        };
        press("Unbreakable");
        QVERIFY(instance.isUnbreakable && !instance.isFixed);
        press("Fixed");
        QVERIFY(instance.isUnbreakable && instance.isFixed);
        press("Unbreakable");
        QVERIFY(!instance.isUnbreakable && instance.isFixed);
        QCOMPARE(desk.document.undoStack().count(), 3);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void rotationsStayAsTyped() {
        InspectorDesk desk;
        desk.selection.setInstances(desk.document.project(), {20});
        desk.type("Rotation y", "100");
        desk.type("Rotation x", "30");
        QCOMPARE(desk.control<NumberField>("Rotation y").value(), 100.0);
        QCOMPARE(desk.control<NumberField>("Rotation x").value(), 30.0);
        QVERIFY(!verifyProject(desk.document.project()));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void sceneSettingsAreEdited() {
        InspectorDesk desk;
        desk.selection.setSubject(Part::Scene);
        desk.type("Gravity along y", "-3.7");
        QCOMPARE(desk.document.project().gravity.y, -3.7);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void undoingRandomEditsRestoresTheFile() {
        constexpr std::uint64_t kSeed = 2611;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        InspectorDesk desk;
        const auto below = [&](qsizetype count) {
            return static_cast<qsizetype>(random.below(static_cast<std::uint64_t>(count)));
        };
        for (int k = 0; k < 150; ++k) {
            switch (below(4)) {
                case 0: desk.selection.setAsset(std::array{3u, 9u, 11u}[static_cast<std::size_t>(below(3))]); break;
                case 1: desk.selection.setMaterial(1 + static_cast<Id>(below(2))); break;
                case 2: desk.selection.setInstances(desk.document.project(), {20, 21}); break;
                default: desk.selection.setSubject(Part::Scene); break;
            }
            const auto fields = desk.inspector.page().findChildren<NumberField*>();
            NumberField& field = *fields[below(fields.size())];
            if (!field.isVisible() || !field.isEnabled()) continue;
            field.setFocus();
            field.selectAll();
            QTest::keyClicks(&field, QString::number(random.unit() * 10.0 - 1.0));
            QTest::keyClick(&field, below(2) == 0 ? Qt::Key_Return : Qt::Key_Up);
            QVERIFY2(!verifyProject(desk.document.project()), qPrintable(field.accessibleName()));
        }
        QVERIFY(desk.document.undoStack().count() > 30);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void everyControlHasAToolTipAndIsReachableByKeyboard() {
        InspectorDesk desk;
        const auto check = [&] {
            for (QWidget* control : desk.inspector.page().findChildren<QWidget*>()) {
                if (!control->isVisible() || control->focusPolicy() == Qt::NoFocus || control->focusProxy()) continue;
                const bool isPart = qobject_cast<QAbstractSpinBox*>(control->parentWidget()) != nullptr;
                if (isPart) continue;
                const QByteArray name = control->metaObject()->className();
                QVERIFY2(!control->toolTip().isEmpty(), name + ' ' + control->accessibleName().toUtf8());
                const bool isButton = qobject_cast<QAbstractButton*>(control) != nullptr;
                QVERIFY2(isButton || !control->accessibleName().isEmpty(), name);
                QVERIFY2(control->focusPolicy() & Qt::TabFocus, name);
            }
        };
        check();
        desk.selection.setMaterial(1);
        check();
        desk.selection.setInstances(desk.document.project(), {20});
        check();
        desk.selection.setSubject(Part::Scene);
        check();
    }
};

RUBBLE_TEST_WITH(InspectorTest, QApplication)
#include "InspectorTest.moc"
