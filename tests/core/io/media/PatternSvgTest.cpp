#include "core/io/media/PatternSvg.h"

#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

using namespace rubble;

namespace {

PatternPanel panel(const std::string& title, const Polygon& outline, std::vector<Vec2> seeds) {
    PatternPanel result{.title = title, .outlines = {outline}, .depth = 0.5};
    const Delaunay delaunay = *triangulate(seeds);
    result.triangles = triangleList(delaunay);
    result.partition = *voronoiPartition(outline, delaunay);
    result.seeds = std::move(seeds);
    return result;
}

PatternPanel scattered(std::uint32_t count) {
    const Pattern pattern{{{.id = 1, .randomSeed = 3, .parameters = UniformScatter{.count = count}}}};
    return panel("scattered", unitSquare(), seedsOf(pattern, unitSquare())->positions);
}

QString drawn(const std::vector<PatternPanel>& panels, const PatternSvgOptions& shown = {}) {
    return QString::fromStdString(patternSvg(panels, shown));
}

/// Returns all matches of the first group of an expression.
QStringList captured(const QString& text, const QString& expression) {
    QStringList found;
    auto matches = QRegularExpression(expression).globalMatch(text);
    while (matches.hasNext()) found << matches.next().captured(1);
    return found;
}

const QString kCellFill = "<path fill=\"(#[0-9a-f]{6})\" d=\"M";
const QString kDot = "<circle cx=\"[-0-9.]+\" cy=\"[-0-9.]+\" r=\"[0-9.]+\"(/?)";

bool isXml(const QString& text) {
    QXmlStreamReader reader(text);
    while (!reader.atEnd()) reader.readNext();
    return !reader.hasError();
}

}  // namespace

class PatternSvgTest : public QObject {
    Q_OBJECT
private slots:
    void everyCellAndSeedIsDrawnOnce() {
        const QString svg = drawn({scattered(20)});
        QVERIFY(isXml(svg));
        QCOMPARE(captured(svg, kCellFill).size(), 20);
        QCOMPARE(captured(svg, kDot).count("/"), 20);
        QVERIFY(svg.contains("20 seeds, 20 cells; 1 × 1 × 0.5 m"));
    }
    /// A section has several outlines, says where it is, and has no triangulation.
    void sectionsSayWhereTheyAre() {
        PatternPanel cut = scattered(9);
        cut.outlines.push_back({{{3.0, 0.0}, {4.0, 0.0}, {4.0, 1.0}}, {}});
        cut.section = "y = 0.3 m";
        const QString svg = drawn({cut});
        QVERIFY(isXml(svg) && svg.contains("9 seeds, 9 cells; 4 × 1 m at y = 0.3 m"));
        QVERIFY(!svg.contains("Delaunay"));
        QVERIFY(drawn({cut, scattered(2)}).contains("Delaunay"));
    }
    void onlyRequestedPartsAreDrawn() {
        QVERIFY(captured(drawn({scattered(20)}, {.cells = false}), kCellFill).isEmpty());
        QVERIFY(captured(drawn({scattered(20)}, {.seeds = false}), kDot).isEmpty());
        QVERIFY(!drawn({scattered(20)}, {.triangles = false}).contains("Delaunay"));
        const QString bare = drawn({scattered(20)}, {.cells = false, .triangles = false, .seeds = false});
        QVERIFY(isXml(bare) && bare.contains("outline") && !bare.contains("Voronoi"));
    }
    void neighboursDifferInColour() {
        const PatternPanel many = scattered(300);
        const QStringList fills = captured(drawn({many}), kCellFill);
        QCOMPARE(fills.size(), 300);
        for (std::uint32_t piece = 0; piece < 300; ++piece) {
            for (const PieceContact& contact : contactsOf(many.partition, piece, 0.0)) {
                QVERIFY(fills[static_cast<int>(piece)] != fills[static_cast<int>(contact.piece)]);
            }
        }
    }
    void piecesOfOneSeedHaveOneColour() {
        const Polygon arms{{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
        const PatternPanel cutApart = panel("arms", arms, {{1.5, 0.5}, {1.5, 2.5}});
        QStringList fills = captured(drawn({cutApart}), kCellFill);
        QCOMPARE(fills.size(), 3);
        fills.removeDuplicates();
        QCOMPARE(fills.size(), 2);
    }
    void seedsWithoutACellAreRings() {
        const QString svg = drawn({panel("far", unitSquare(), {{0.5, 0.5}, {1.001, 9.0}})});
        QCOMPARE(captured(svg, kDot), (QStringList{"/", ""}));
        QVERIFY(svg.contains("2 seeds, 1 cell;") && svg.contains("seed without a cell"));
        QVERIFY(!drawn({scattered(4)}).contains("seed without a cell"));
    }
    void titlesAreEscaped() {
        const QString svg = drawn({panel("a <b> & \"c\"", unitSquare(), {{0.5, 0.5}})});
        QVERIFY(isXml(svg) && svg.contains("a &lt;b&gt; &amp; &quot;c&quot;"));
    }
    void withoutSeedsThereIsOnePiece() {
        const QString svg = drawn({panel("whole", squareRing(), {})});
        QVERIFY(isXml(svg) && svg.contains("0 seeds, 0 cells;"));
    }
    void threePanelsFitInARow() {
        const std::vector<PatternPanel> panels(5, scattered(4));
        QStringList lefts = captured(drawn(panels), "<text x=\"([0-9.]+)\" y=\"[0-9.]+\" font-size=\"17\"");
        QCOMPARE(lefts.size(), 5);
        QCOMPARE(lefts[0], lefts[3]);
        lefts.removeDuplicates();
        QCOMPARE(lefts.size(), 3);
    }
    void flatAndTallOutlinesKeepTheirProportions() {
        for (const Vec2 size : {Vec2(1.0, 1e-3), Vec2(1e-3, 1.0), Vec2(1e6, 2e6), Vec2(1e-6, 1e-6)}) {
            const QString svg = drawn({panel("plank", {rectangle({0.0, 0.0}, size), {}}, {size / 2.0})});
            QVERIFY(isXml(svg) && !svg.contains("nan") && !svg.contains("inf"));
        }
    }
    void equalPanelsGiveEqualBytes() { QCOMPARE(drawn({scattered(50)}), drawn({scattered(50)})); }
};

RUBBLE_TEST(PatternSvgTest)
#include "PatternSvgTest.moc"
