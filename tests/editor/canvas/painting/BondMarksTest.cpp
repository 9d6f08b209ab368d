// Tests editor/canvas/painting/BondMarks.cpp and editor/canvas/painting/BondMarkPainting.cpp.
#include "editor/canvas/painting/BondMarks.h"

#include "editor/canvas/painting/BondMarkPainting.h"
#include "editor/document/EnteredFragment.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QPalette>

#include <algorithm>
#include <limits>

using namespace rubble;

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// A square of two halves, left and right, each of two fragments of a level: lower and upper.
struct Halves : CanvasBench {
    Halves() : CanvasBench(project()) {
        QVERIFY(QTest::qWaitFor([&] { return bakes.find(2) && bakes.find(2)->bake; }, kPatience));
        marker = BondMarker::of(bakes.find(2)->bake, *canvas.displayedPattern());
    }
    static Project project() {
        Project project = projectOf(unitSquare(), PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}});
        project.assets[0].breakAs = BreakAs::Bonded;
        project.assets[0].levels = {
            {.pattern = {{{.id = 5, .parameters = PlacedSeeds{{{0, {0.0, -0.2}}, {1, {0.0, 0.2}}}}}}},
             .bondStrength = 0.5}};
        return project;
    }
    Asset painted(const BondStroke& stroke) const {
        Asset asset = this->asset();
        asset.bonding.strokes.push_back(stroke);
        return asset;
    }
    std::unique_ptr<BondMarker> marker;
};

}  // namespace

class BondMarksTest : public QObject {
    Q_OBJECT
private slots:
    void anchorsAreOfPieces() {
        Halves halves;
        const BondMarks marks =
            halves.marker->marks(halves.painted({.brush = BondBrush::Anchor, .points = {{0.75, 0.5}}}), false);
        QCOMPARE(marks.isAnchored, (std::vector<bool>{false, true}));
        QCOMPARE(marks.neverBreaks, (std::vector<bool>{false, false}));
        QVERIFY(marks.edges.empty());
    }
    /// Merged pieces have the same points.
    void fragmentsOfOtherPiecesHaveNoMarks() {
        Halves halves;
        const std::shared_ptr<const Bake> before = halves.bakes.find(2)->bake;
        QVERIFY(BondMarker::of(before, *halves.canvas.displayedPattern()));
        Asset merged = halves.asset();
        const std::string layer = std::to_string(merged.pattern.layers[0].id);
        merged.edits = {FragmentMerge{layer + ".0", {layer + ".1"}}};
        halves.document.push(modify("Merge", std::move(merged)));
        halves.settle();
        QCOMPARE(halves.canvas.displayedPattern()->partition().pieceCount(), 1u);
        QVERIFY(!BondMarker::of(before, *halves.canvas.displayedPattern()));
    }
    void strengthIsThatAtTheBond() {
        Halves halves;
        const BondStroke stroke{.brush = BondBrush::Strength, .strength = 3.0, .points = {{0.5, 0.5}}};
        const BondMarks marks = halves.marker->marks(halves.painted(stroke), true);
        QCOMPARE(marks.edges.size(), std::size_t{1});
        QCOMPARE(marks.edges[0].factor, 3.0);
        QCOMPARE(marks.edges[0].from.x, 0.5);
        QCOMPARE(std::abs(marks.edges[0].to.y - marks.edges[0].from.y), 1.0);
        QCOMPARE(halves.marker->marks(halves.asset(), true).edges[0].factor, 1.0);
    }
    void bondsOfTwoThatNeverBreakHoldForever() {
        Halves halves;
        const BondStroke one{.brush = BondBrush::NeverBreaks, .points = {{0.25, 0.5}}};
        QCOMPARE(halves.marker->marks(halves.painted(one), true).edges[0].factor, 1.0);
        const BondStroke both{.brush = BondBrush::NeverBreaks, .points = {{0.25, 0.5}, {0.75, 0.5}}};
        const BondMarks marks = halves.marker->marks(halves.painted(both), true);
        QCOMPARE(marks.edges[0].factor, kForever);
        QCOMPARE(marks.neverBreaks, (std::vector<bool>{true, true}));
    }
    void levelsHaveTheirStrength() {
        Halves halves;
        enterFragment(halves.selection, "3.1");
        QVERIFY(QTest::qWaitFor(
            [&] {
                const DrawablePattern* shown = halves.canvas.displayedPattern();
                return shown && shown->baked().parent == "3.1";
            },
            kPatience));
        const auto marker = BondMarker::of(halves.bakes.find(2)->bake, *halves.canvas.displayedPattern());
        QVERIFY(marker);
        const BondStroke stroke{.brush = BondBrush::Anchor, .radius = 0.05, .points = {{0.75, 0.1}}};
        const BondMarks marks = marker->marks(halves.painted(stroke), true);
        QCOMPARE(marks.isAnchored, (std::vector<bool>{true, false}));
        QCOMPARE(marks.edges.size(), std::size_t{1});
        QCOMPARE(marks.edges[0].factor, 0.5);
        QCOMPARE(marks.edges[0].from.y, 0.0);  // in the frame of the fragment
    }
    void thereIsNoneForAPatternThatIsNotBaked() {
        Halves halves;
        QVERIFY(!BondMarker::of(nullptr, *halves.canvas.displayedPattern()));
        CanvasBench other(projectOf(unitSquare(), PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.5}}}}));
        QVERIFY(!BondMarker::of(halves.bakes.find(2)->bake, *other.canvas.displayedPattern()));
    }
    void coloursAreMonotoneBetweenWeakAndStrong() {
        for (const QColor window : {QColor(Qt::white), QColor(Qt::black)}) {
            QPalette palette;
            palette.setColor(QPalette::Window, window);
            palette.setColor(QPalette::WindowText, window == QColor(Qt::white) ? Qt::black : Qt::white);
            const CanvasColours colours = canvasColours(palette);
            QCOMPARE(bondColour(1.0, colours), colours.neutralBond);
            QCOMPARE(bondColour(0.0, colours), colours.weakBond);
            QCOMPARE(bondColour(0.1, colours), colours.weakBond);
            QCOMPARE(bondColour(1000.0, colours), colours.strongBond);
            QCOMPARE(bondColour(kForever, colours), colours.neverBreaks);
            QVERIFY(bondColour(2.0, colours) != colours.neutralBond);
        }
    }
    void bondsAreShownIfAnOverlayOrAToolShowsThem() {
        Halves halves;
        Asset asset = halves.painted({.brush = BondBrush::Strength, .strength = 10.0, .points = {{0.5, 0.5}}});
        halves.document.push(modify("Paint", std::move(asset)));
        halves.settle();
        const auto colourOfBond = [&] {
            return halves.canvas.picture({640, 480}).pixelColor(halves.pixels({0.5, 0.75}));
        };
        const QColor strong = canvasColours(halves.canvas.palette()).strongBond;
        QVERIFY(colourOfBond() != strong);
        halves.canvas.setTool(CanvasToolKind::StrengthBrush);
        QCOMPARE(colourOfBond(), strong);
        halves.canvas.setTool(CanvasToolKind::Seeds);
        QVERIFY(colourOfBond() != strong);
        CanvasOverlays overlays = halves.canvas.overlays();
        overlays.hasBondStrengths = true;
        halves.canvas.setOverlays(overlays);
        QCOMPARE(colourOfBond(), strong);
    }
    void legendExplainsMarksAndStrengths() {
        Halves halves;
        const double before = halves.canvas.legendArea().height();
        Asset asset = halves.painted({.brush = BondBrush::Anchor, .points = {{0.75, 0.5}}});
        halves.document.push(modify("Paint", std::move(asset)));
        halves.settle();
        const double withAnchor = halves.canvas.legendArea().height();
        QVERIFY(withAnchor > before);
        halves.canvas.setTool(CanvasToolKind::StrengthBrush);
        QVERIFY(halves.canvas.legendArea().height() > withAnchor);
    }
    void marksGoWithTheBonds() {
        Halves halves;
        const QImage plain = halves.canvas.picture({640, 480});
        halves.document.push(modify("Paint", halves.painted({.brush = BondBrush::Anchor, .points = {{0.75, 0.5}}})));
        halves.settle();
        QVERIFY(halves.canvas.picture({640, 480}) != plain);
        Asset whole = halves.asset();
        whole.breakAs = BreakAs::Whole;
        halves.document.push(modify("Break Whole", std::move(whole)));
        halves.settle();
        QCOMPARE(halves.canvas.picture({640, 480}), plain);
    }
};

RUBBLE_TEST_WITH(BondMarksTest, QApplication)
#include "BondMarksTest.moc"
