// Tests editor/canvas/widget/AccessibleCanvas.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QAccessible>
#include <QTest>

using namespace rubble;

namespace {

PlacedSeeds quarterSeeds() { return {{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}}; }

QString nameOf(const QAccessibleInterface& item) { return item.text(QAccessible::Name); }

struct AccessibleBench : CanvasBench {
    explicit AccessibleBench(LayerParameters parameters = quarterSeeds())
        : CanvasBench(projectOf(unitSquare(), std::move(parameters))) {}

    QAccessibleInterface& root() { return *QAccessible::queryAccessibleInterface(&canvas); }
    std::uint32_t pieces() const { return canvas.displayedPattern()->partition().pieceCount(); }
    QAccessibleInterface& fragment(std::uint32_t piece) { return *root().child(static_cast<int>(piece)); }
    QPoint centre(std::uint32_t piece) {
        return canvas.mapToGlobal(pixels(canvas.displayedPattern()->centroid(piece)));
    }
    QAccessibleInterface* childAt(QPoint point) { return root().childAt(point.x(), point.y()); }
    QList<bool> selected() {
        QList<bool> states;
        for (std::uint32_t piece = 0; piece < pieces(); ++piece) states << bool(fragment(piece).state().selected);
        return states;
    }
};

}  // namespace

class AccessibleCanvasTest : public QObject {
    Q_OBJECT
private slots:
    void childrenAreTheFragmentsAndThenTheWidgets() {
        AccessibleBench bench;
        QCOMPARE(bench.root().role(), QAccessible::List);
        int fragments = 0;
        for (int k = 0; k < bench.root().childCount(); ++k) {
            QAccessibleInterface* child = bench.root().child(k);
            QVERIFY(child);
            QCOMPARE(bench.root().indexOfChild(child), k);
            QCOMPARE(child->parent(), &bench.root());
            fragments += child->role() == QAccessible::ListItem;
        }
        QCOMPARE(fragments, 4);
        QCOMPARE(bench.root().child(bench.root().childCount()), nullptr);
        QCOMPARE(bench.root().child(-1), nullptr);
    }
    void fragmentsHaveTheNamesOfTheTable() {
        AccessibleBench bench;
        QStringList names;
        for (std::uint32_t piece = 0; piece < bench.pieces(); ++piece) names << nameOf(bench.fragment(piece));
        names.sort();
        QCOMPARE(names, QStringList({"Fragment 2/3.0", "Fragment 2/3.1", "Fragment 2/3.2", "Fragment 2/3.3"}));
    }
    void rectangleIsThatOnTheScreen() {
        AccessibleBench bench;
        for (const double factor : {1.0, 3.0}) {
            bench.canvas.zoomBy(factor);
            for (std::uint32_t piece = 0; piece < bench.pieces(); ++piece) {
                const QRect rect = bench.fragment(piece).rect();
                QVERIFY(rect.contains(bench.centre(piece)));
                const double side = 0.5 * bench.canvas.view().scale;
                QVERIFY(std::abs(rect.width() - side) <= 2.0 && std::abs(rect.height() - side) <= 2.0);
            }
        }
    }
    void childAtAPointIsTheFragmentThere() {
        AccessibleBench bench;
        for (std::uint32_t piece = 0; piece < bench.pieces(); ++piece) {
            QCOMPARE(bench.childAt(bench.centre(piece)), &bench.fragment(piece));
        }
        QCOMPARE(bench.childAt(bench.canvas.mapToGlobal(bench.pixels({-0.2, 0.5}))), nullptr);
        QCOMPARE(bench.childAt(bench.canvas.mapToGlobal(QPoint(-10, -10))), nullptr);
    }
    void actionsSelect() {
        AccessibleBench bench;
        QVERIFY(bench.fragment(1).state().selectable);
        QCOMPARE(bench.selected(), QList<bool>({false, false, false, false}));
        const auto act = [&](std::uint32_t piece, const QString& action) {
            QAccessibleActionInterface* actions = bench.fragment(piece).actionInterface();
            QVERIFY(actions && actions->actionNames().contains(action));
            actions->doAction(action);
        };
        act(1, QAccessibleActionInterface::pressAction());
        QCOMPARE(bench.selected(), QList<bool>({false, true, false, false}));
        QCOMPARE(bench.selection.seeds(), Selection::Seeds{bench.canvas.displayedPattern()->cellOf(1)});
        act(2, QAccessibleActionInterface::toggleAction());
        QCOMPARE(bench.selected(), QList<bool>({false, true, true, false}));
        act(3, QAccessibleActionInterface::pressAction());
        QCOMPARE(bench.selected(), QList<bool>({false, false, false, true}));
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void fragmentsFollowThePattern() {
        AccessibleBench bench;
        QAccessibleInterface& old = bench.fragment(3);
        QVERIFY(old.isValid());
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click({0.5, 0.4});
        QCOMPARE(bench.pieces(), 5u);
        QVERIFY(!old.isValid());
        QVERIFY(old.rect().isNull() && nameOf(old).isEmpty());
        QVERIFY(bench.fragment(3).isValid());
        QVERIFY(bench.fragment(4).isValid());
    }
    /// A screen reader asks for few of many fragments; only these are created.
    void fragmentsAreCreatedOnceTheyAreAskedFor() {
        AccessibleBench bench(UniformScatter{.count = 5000});
        const std::uint32_t pieces = bench.pieces();
        QVERIFY(pieces > 4000);
        QAccessibleInterface* last = &bench.fragment(pieces - 1);
        QCOMPARE(&bench.fragment(pieces - 1), last);
        QCOMPARE(bench.childAt(bench.centre(0)), &bench.fragment(0));
        // Ids are given in order: nothing was created between these two.
        const QAccessible::Id first = QAccessible::uniqueId(&bench.fragment(1));
        bench.childAt(bench.centre(2));
        QCOMPARE(QAccessible::uniqueId(&bench.fragment(2)), first + 1);
    }
};

RUBBLE_TEST_WITH(AccessibleCanvasTest, QApplication)
#include "AccessibleCanvasTest.moc"
