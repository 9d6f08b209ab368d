// Tests editor/canvas/painting/CanvasPainting.cpp and editor/canvas/painting/CanvasContents.cpp.
#include "editor/canvas/painting/CanvasPainting.h"

#include "core/fracture/pieces/PieceGap.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QImage>
#include <QTest>

using namespace rubble;

namespace {

constexpr int kSize = 400;  // pixels
constexpr QRgb kBackground = 0xffffffff;

/// The cells of a unit square with a gap between them, as a canvas shows them.
CanvasContents cellsWithGap(Asset asset, double gap) {
    asset.shaping.gap = gap;
    auto baked = std::make_shared<BakedPattern>();
    baked->asset = std::make_shared<const Asset>(asset);
    baked->seeds = *seedsOf(asset.pattern, asset.prism().outline);
    baked->triangulation = *triangulate(baked->seeds.positions);
    baked->partition = *voronoiPartition(asset.prism().outline, baked->triangulation);
    CanvasContents contents;
    contents.shrunk = std::make_shared<const Partition>(*shrunkPartition(baked->partition, gap / 2.0));
    contents.pattern = std::make_shared<const DrawablePattern>(std::move(baked));
    contents.overlays = {.hasGrid = false, .hasSeeds = false, .hasLegend = false};
    return contents;
}

CanvasView viewOfUnitSquare() { return {.size = {kSize, kSize}, .centre = {0.5, 0.5}, .scale = kSize}; }

QImage painted(const CanvasContents& contents) {
    QImage image(kSize, kSize, QImage::Format_RGB32);
    QPainter painter(&image);
    CanvasColours colours = canvasColours(QPalette());
    colours.background = QColor(kBackground);
    paintContents(painter, QRectF(0, 0, kSize, kSize), viewOfUnitSquare(), contents, colours);
    return image;
}

/// Whether a point is far enough from a polygon's edges not to be affected by antialiasing.
bool isClear(const Polygon& polygon, Vec2 at) {
    return std::ranges::all_of(edgesOf(polygon), [&](const std::array<Vec2, 2>& edge) {
        return distanceToSegment(at, edge[0], edge[1]) > 1.5 / kSize;
    });
}

/// The first pixel that is not the background although it lies in a gap, or is although it lies in a fragment.
QString faultOf(const QImage& image, const CanvasContents& contents) {
    std::vector<Polygon> fragments;
    for (std::uint32_t piece = 0; piece < contents.shrunk->pieceCount(); ++piece) {
        if (!contents.shrunk->isEmpty(piece)) fragments.push_back(pieceOutline(*contents.shrunk, piece));
    }
    for (int y = 2; y < kSize - 2; y += 3) {
        for (int x = 2; x < kSize - 2; x += 3) {
            const Vec2 at = viewOfUnitSquare().metres(QPointF(x + 0.5, y + 0.5)) - contents.shrunk->origin;
            if (!std::ranges::all_of(fragments, [&](const Polygon& one) { return isClear(one, at); })) continue;
            const bool isInside = std::ranges::any_of(
                fragments, [&](const Polygon& one) { return containment(one, at) == Containment::Inside; });
            if (isInside != (image.pixel(x, y) != kBackground))
                return QString("%1, %2 is %3").arg(x).arg(y).arg(isInside ? "a hole" : "not a gap");
        }
    }
    return {};
}

int emptyPieces(const Partition& shrunk) {
    int count = 0;
    for (std::uint32_t piece = 0; piece < shrunk.pieceCount(); ++piece) count += shrunk.isEmpty(piece) ? 1 : 0;
    return count;
}

}  // namespace

class CanvasPaintingTest : public QObject {
    Q_OBJECT
private slots:
    void gapsAreBackgroundAndFragmentsAreNot_data() {
        QTest::addColumn<std::uint32_t>("seeds");
        QTest::addColumn<double>("gap");
        QTest::addColumn<bool>("doSomeVanish");
        QTest::newRow("all fragments remain") << 12u << 0.02 << false;
        QTest::newRow("some fragments vanish") << 60u << 0.12 << true;
        QTest::newRow("all fragments vanish") << 60u << 1.5 << true;
    }
    /// A fragment that is narrower than the gap has no outline; the place of its outline is that of another's.
    void gapsAreBackgroundAndFragmentsAreNot() {
        QFETCH(std::uint32_t, seeds);
        QFETCH(double, gap);
        QFETCH(bool, doSomeVanish);
        const Asset asset = boxAsset(2, 3, UniformScatter{.count = seeds});
        const CanvasContents contents = cellsWithGap(asset, gap);
        QCOMPARE(emptyPieces(*contents.shrunk) > 0, doSomeVanish);
        const QString fault = faultOf(painted(contents), contents);
        QVERIFY2(fault.isEmpty(), qPrintable(fault));
    }
    void areaIsThatWithoutTheGap() {
        const CanvasContents contents = cellsWithGap(boxAsset(2, 3, UniformScatter{.count = 60}), 0.12);
        for (std::uint32_t piece = 0; piece < contents.shrunk->pieceCount(); ++piece) {
            const double area = contents.area(piece);
            QCOMPARE(area == 0.0, contents.shrunk->isEmpty(piece));
            QVERIFY(area < contents.pattern->area(piece));
        }
    }
};

RUBBLE_TEST_WITH(CanvasPaintingTest, QGuiApplication)
#include "CanvasPaintingTest.moc"
