// Tests editor/canvas/painting/RulerPainting.cpp and editor/canvas/painting/GridPainting.cpp.
#include "editor/canvas/painting/GridPainting.h"
#include "editor/canvas/painting/RulerPainting.h"
#include "tests/support/TestProgram.h"

#include <QFont>
#include <QImage>
#include <QLocale>
#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

QFontMetrics letters() {
    QFont font;
    font.setPixelSize(10);
    return QFontMetrics(font);
}

const Units kMetres;

std::vector<RulerTick> labelled(Ruler ruler, const CanvasView& view, const Units& units = kMetres) {
    std::vector<RulerTick> ticks = rulerTicks(ruler, view, units, letters());
    std::erase_if(ticks, [](const RulerTick& tick) { return tick.label.isEmpty(); });
    return ticks;
}

/// The pixel of a point (m).
double pixelOf(Ruler ruler, const CanvasView& view, double metres) {
    const QPointF place = view.pixels(Vec2(metres));
    return std::floor((ruler == Ruler::Top ? place.x() : place.y()) + 1e-3) + 0.5;
}

CanvasView wide() { return {.size = {800.0, 600.0}, .centre = {0.0, 0.0}, .scale = 200.0}; }

}  // namespace

class RulerPaintingTest : public QObject {
    Q_OBJECT
private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void labelsShowMetres() {
        // 4 m wide and 3 m high: a label every 0.5 m, which is 100 pixels; 0.2 m would be 40.
        QStringList top, left;
        for (const RulerTick& tick : labelled(Ruler::Top, wide())) top.append(tick.label);
        for (const RulerTick& tick : labelled(Ruler::Left, wide())) left.append(tick.label);
        QCOMPARE(top, (QStringList{"-1.5", "-1.0", "-0.5", "0.0", "0.5", "1.0", "1.5"}));
        QCOMPARE(left, (QStringList{"-1.5", "-1.0", "-0.5", "0.0", "0.5", "1.0"}));
        QCOMPARE(labelled(Ruler::Top, wide())[3].at, 400.5);
        QCOMPARE(labelled(Ruler::Left, wide())[3].at, 300.5);
        QVERIFY(labelled(Ruler::Left, wide())[4].at < 300.0);  // y is up
        QCOMPARE(rulerTicks(Ruler::Top, wide(), kMetres, letters()).size(), std::size_t{41});
    }
    void ticksFollowZoomsAndPans() {
        CanvasView view = wide();
        for (int k = 0; k < 400; ++k) {
            view = zoomed(view, k < 60 ? 1.1 : 0.95, {13.0 * (k % 60), 7.0 * (k % 70)});
            view = panned(view, {3.7 * (k % 11) - 20.0, 25.0 - 4.3 * (k % 13)});
            for (const Ruler ruler : {Ruler::Top, Ruler::Left}) {
                const std::vector<RulerTick> ticks = labelled(ruler, view);
                QVERIFY(ticks.size() >= 2);
                for (const RulerTick& tick : ticks) {
                    const double metres = QLocale::c().toDouble(tick.label);
                    QVERIFY2(std::abs(tick.at - pixelOf(ruler, view, metres)) <= 1.0, qPrintable(tick.label));
                }
                const double step =
                    std::abs(QLocale::c().toDouble(ticks[1].label) - QLocale::c().toDouble(ticks[0].label));
                QVERIFY(step * view.scale >= 63.0 && step * view.scale <= 64.0 * 2.5 + 1.0);
                const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
                QVERIFY(std::abs(digit - 1.0) < 1e-6 || std::abs(digit - 2.0) < 1e-6 || std::abs(digit - 5.0) < 1e-6);
            }
        }
    }
    void labelsDoNotOverlap() {
        for (double scale = 1e-3; scale < 1e6; scale *= 1.37) {
            for (const Vec2 centre : {Vec2(0.0), Vec2(-123.4, 56.7), Vec2(1234.5, -987.6)}) {
                const CanvasView view{.size = {640.0, 480.0}, .centre = centre, .scale = scale};
                for (const Ruler ruler : {Ruler::Top, Ruler::Left}) {
                    double before = kRulerWidth;
                    std::vector<RulerTick> ticks = labelled(ruler, view);
                    if (ruler == Ruler::Left) std::ranges::reverse(ticks);  // from the top
                    for (const RulerTick& tick : ticks) {
                        QVERIFY2(tick.from >= before, qPrintable(QString("%1 at %2").arg(tick.label).arg(scale)));
                        before = tick.to;
                    }
                    QVERIFY(before <= (ruler == Ruler::Top ? 640.0 : 480.0));
                }
            }
        }
    }
    void labelsUseTheLocale() {
        QLocale::setDefault(QLocale(QLocale::German));
        QCOMPARE(labelled(Ruler::Top, wide())[4].label, QString("0,5"));
    }
    void labelsUseTheUnit() {
        const Units millimetres{LengthUnit::Millimetre};
        QCOMPARE(labelled(Ruler::Top, wide(), millimetres)[4].label, QString("500"));
        CanvasView near = wide();
        near.scale = 2e6;
        QCOMPARE(labelled(Ruler::Top, near, millimetres)[5].label, QString("0.10"));  // every 0.05 mm: 100 pixels
    }
    void stepsAreRoundInFeet() {
        const Units feet{LengthUnit::Foot};
        QStringList top;
        for (const RulerTick& tick : labelled(Ruler::Top, wide(), feet)) {
            top.append(tick.label);
            QCOMPARE(tick.at, pixelOf(Ruler::Top, wide(), 0.3048 * tick.label.toDouble()));
        }
        QCOMPARE(top, (QStringList{"-6", "-4", "-2", "0", "2", "4", "6"}));
        QCOMPARE(gridStep(wide(), feet), 0.5 * 0.3048);  // 14 pixels or more
    }
    void fontFollowsTheWindow() {
        QFont font;
        font.setPixelSize(13);
        QCOMPARE(rulerFont(font).pixelSize(), 10);
        font.setPixelSize(18);
        QCOMPARE(rulerFont(font).pixelSize(), 14);
        font.setPixelSize(60);
        QVERIFY(rulerFont(font).pixelSize() < kRulerWidth);
    }
    void rulersShowUnitAndTicks() {
        const CanvasColours colours = canvasColours(QPalette());
        QImage picture(800, 600, QImage::Format_RGB32);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        paintRulers(painter, wide(), kMetres, colours, {-10.0, -10.0});
        painter.end();
        const QRgb panel = colours.panel.rgb();
        int letters = 0;
        for (int y = 2; y < 20; ++y) {
            for (int x = 2; x < 20; ++x) letters += picture.pixel(x, y) != panel;
        }
        QVERIFY(letters > 5);
        for (const RulerTick& tick : rulerTicks(Ruler::Top, wide(), kMetres, ::letters())) {
            const int x = static_cast<int>(tick.at);
            if (x < 23 || x > 799) continue;
            QVERIFY(picture.pixel(x, 18) != panel);
            if (tick.isLabelled) QVERIFY(picture.pixel(x, 5) != panel);  // longer than the other ticks
        }
    }
};

RUBBLE_TEST_WITH(RulerPaintingTest, QApplication)
#include "RulerPaintingTest.moc"
