#include "editor/canvas/painting/LegendPainting.h"

#include "core/asset/project/FragmentColours.h"
#include "editor/canvas/painting/BondMarkPainting.h"
#include "editor/canvas/painting/ChangePainting.h"
#include "editor/canvas/painting/LabelPainting.h"
#include "editor/widgets/ColourConversion.h"
#include "editor/widgets/appearance/LayerText.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rubble {

namespace {

// All in pixels.
constexpr double kLegendPadding = 8.0;
constexpr double kSampleWidth = 22.0;
constexpr double kRowHeight = 17.0;
constexpr double kScaleWidth = 130.0;
constexpr double kBetweenEnds = 16.0;  // at least, between the numbers below a scale
constexpr double kScaleHeight = 42.0;
constexpr double kSampleMarkerRadius = 4.0;
constexpr double kEdgeMargin = 10.0;
constexpr std::size_t kMaxLayers = 6;

struct CanvasLegendTexts {
    Q_DECLARE_TR_FUNCTIONS(CanvasLegend)
};

/// A sample, painted around a point, and its meaning.
struct Row {
    std::function<void(QPainter&, QPointF)> paintSample;
    QString text;
};

QString scaleTitle(CellColouring colouring) {
    switch (colouring) {
        case CellColouring::Area: return CanvasLegendTexts::tr("Area");
        case CellColouring::Neighbours: return CanvasLegendTexts::tr("Neighbours");
        case CellColouring::Aspect: return CanvasLegendTexts::tr("Aspect ratio");
        case CellColouring::Level: return CanvasLegendTexts::tr("Deeper levels");
        case CellColouring::Volume: return CanvasLegendTexts::tr("Volume");
        case CellColouring::Mass: return CanvasLegendTexts::tr("Mass");
        case CellColouring::Threshold: return CanvasLegendTexts::tr("Break threshold");
        case CellColouring::None:
        case CellColouring::Fragment:
        case CellColouring::Cluster: break;
    }
    return {};
}

/// A value at an end of the scale, in the unit that suits the larger end.
QString scaleText(CellColouring colouring, double value, const CanvasContents& contents) {
    const auto text = [&](QuantityKind kind, double factor) {
        return roundedQuantity(factor * value, quantityFormat(kind, factor * contents.range.most, contents.units));
    };
    switch (colouring) {
        case CellColouring::Area: return text(QuantityKind::Area, 1.0);
        case CellColouring::Volume: return text(QuantityKind::Volume, 1.0);
        case CellColouring::Mass: return text(QuantityKind::Mass, contents.density);
        case CellColouring::Threshold: return text(QuantityKind::Impulse, contents.threshold);
        case CellColouring::Neighbours:
        case CellColouring::Level: return QLocale().toString(value, 'f', 0);
        default: return QLocale().toString(value, 'f', 1);
    }
}

/// Collects the rows and paints them.
class Legend {
public:
    Legend(const CanvasContents& contents, const CanvasColours& colours) : m_contents(contents), m_colours(colours) {
        if (contents.compared) addChanges(*contents.compared);
        if (contents.overlays.hasSeeds) addSeeds();
        const bool hasDiagrams = !contents.pattern->baked().triangulation.triangles.empty();
        if (contents.overlays.hasTriangles && hasDiagrams)
            addLine(contents.isOnScale() ? colours.triangleOnScale : colours.triangle,
                    CanvasLegendTexts::tr("Delaunay triangulation"));
        if (contents.overlays.hasWholeVoronoi && hasDiagrams)
            addLine(colours.wholeVoronoi, CanvasLegendTexts::tr("Voronoi diagram, unclipped"));
        if (contents.overlays.hasBonds && contents.pattern->partition().pieceCount() > 1)
            addLine(colours.bond, CanvasLegendTexts::tr("bonds (width: length of the shared edge)"));
        if (contents.overlays.hasCells && contents.bondMarks) addBondMarks(*contents.bondMarks);
        if (contents.overlays.hasCells && !contents.hidden.isEmpty()) addHatch();
    }

    QRectF area(const QFont& font, const CanvasView& view) const {
        const int scales = static_cast<int>(hasScale()) + static_cast<int>(hasBondScale());
        if (m_rows.empty() && scales == 0) return {};
        const QFontMetricsF metrics(legendFont(font));
        double width = scales > 0 ? kScaleWidth : 0.0;
        double ends = -kBetweenEnds;
        for (const QString& text : scaleTexts()) ends += metrics.horizontalAdvance(text) + kBetweenEnds;
        width = std::max(width, ends);
        for (const Row& row : m_rows) {
            width = std::max(width, kSampleWidth + metrics.horizontalAdvance(row.text));
        }
        const double height = kRowHeight * static_cast<double>(m_rows.size()) + kScaleHeight * scales;
        const QSizeF size(std::ceil(width) + 2.0 * kLegendPadding, height + 2.0 * kLegendPadding);
        return {
            QPointF(view.size.width() - size.width() - kEdgeMargin, view.size.height() - size.height() - kEdgeMargin),
            size};
    }

    QRectF paint(QPainter& painter, const CanvasView& view) const {
        const QRectF panel = area(painter.font(), view);
        if (panel.isEmpty()) return panel;
        painter.save();
        painter.setFont(legendFont(painter.font()));
        paintPanel(painter, panel);
        const double width = panel.width() - 2.0 * kLegendPadding;
        double top = panel.top() + kLegendPadding;
        for (const Row& row : m_rows) {
            const QPointF middle(panel.left() + kLegendPadding + kSampleWidth / 2.0 - 4.0, top + kRowHeight / 2.0);
            row.paintSample(painter, middle);
            painter.setPen(m_colours.text);
            painter.drawText(QRectF(panel.left() + kLegendPadding + kSampleWidth, top, width, kRowHeight),
                             Qt::AlignVCenter, row.text);
            top += kRowHeight;
        }
        QRectF scale(panel.left() + kLegendPadding, top, width, kScaleHeight);
        if (hasScale()) {
            paintScale(painter, scale);
            scale.translate(0.0, kScaleHeight);
        }
        if (hasBondScale()) paintBondScale(painter, scale);
        painter.restore();
        return panel;
    }

private:
    static QFont legendFont(QFont font) {
        font.setPixelSize(11);
        return font;
    }

    bool hasScale() const { return m_contents.overlays.hasCells && isQuantity(m_contents.colouring()); }

    bool hasBondScale() const {
        return m_contents.overlays.hasCells && m_contents.bondMarks && m_contents.bondMarks->showsStrengths;
    }

    void addChanges(const ComparedAsset& compared) {
        if (compared.isEmpty()) m_rows.push_back({[](QPainter&, QPointF) {}, CanvasLegendTexts::tr("no changes")});
        for (int k = 0; k < kFragmentChanges; ++k) {
            const auto change = static_cast<FragmentChange>(k);
            const std::size_t count = compared.fragments.count(change);
            if (count == 0) continue;
            m_rows.push_back(
                {[this, change](QPainter& painter, QPointF at) { paintChangeMarker(painter, at, change, m_colours); },
                 changeText(change, count)});
        }
    }

    void addSeeds() {
        const DrawablePattern& pattern = *m_contents.pattern;
        const std::vector<PatternLayer>& layers = pattern.baked().asset->pattern.layers;
        const DrawablePattern::Counts& counts = pattern.counts();
        addSeedMarker(SeedOrigin::Scattered, counts.scattered, CanvasLegendTexts::tr("scattered seed"));
        addSeedMarker(SeedOrigin::Moved, counts.moved, CanvasLegendTexts::tr("moved by hand"));
        addSeedMarker(SeedOrigin::Placed, counts.placed, CanvasLegendTexts::tr("placed by hand"));
        for (std::size_t k = 0; k < std::min(layers.size(), kMaxLayers) && layers.size() > 1; ++k) {
            if (layers[k].isOn && kindOf(layers[k].parameters).role != LayerRole::Moves) addLayer(k, layers[k]);
        }
        if (counts.duplicates > 0) addDuplicates(counts.duplicates);
        if (counts.withoutCell > 0) addWithoutCell(counts.withoutCell);
    }

    /// The colour of the layer that seeds are in; neutral if they are in several, which have rows of their own.
    QColor seedColour(SeedOrigin origin) const {
        const auto layer = m_contents.pattern->counts().layers[static_cast<std::size_t>(origin)];
        return layer ? layerColour(*layer) : m_colours.text;
    }

    void addSeedMarker(SeedOrigin origin, std::size_t count, const QString& text) {
        if (count == 0) return;
        m_rows.push_back({[this, origin](QPainter& painter, QPointF at) {
                              painter.setPen(QPen(m_colours.halo, 1.0));
                              painter.setBrush(seedColour(origin));
                              paintSeedMarker(painter, at, kSampleMarkerRadius, origin);
                          },
                          text});
    }

    void addLayer(std::size_t number, const PatternLayer& layer) {
        m_rows.push_back(
            {[number](QPainter& painter, QPointF at) {
                 painter.fillRect(QRectF(at.x() - 6.0, at.y() - 4.0, 12.0, 8.0), layerColour(number));
             },
             CanvasLegendTexts::tr("layer %1: %2").arg(layer.id).arg(layerKindName(layer.parameters).toLower())});
    }

    void addDuplicates(std::size_t count) {
        m_rows.push_back({[this](QPainter& painter, QPointF at) {
                              painter.setBrush(Qt::NoBrush);
                              painter.setPen(QPen(m_colours.fault, 1.5));
                              painter.drawEllipse(at, kSampleMarkerRadius + 2.0, kSampleMarkerRadius + 2.0);
                          },
                          CanvasLegendTexts::tr("duplicate seeds: %1").arg(count)});
    }

    void addWithoutCell(std::size_t count) {
        m_rows.push_back({[this](QPainter& painter, QPointF at) {
                              painter.setBrush(Qt::NoBrush);
                              painter.setPen(QPen(m_colours.text, 1.5));
                              painter.drawEllipse(at, kSampleMarkerRadius, kSampleMarkerRadius);
                          },
                          CanvasLegendTexts::tr("seeds without a cell: %1").arg(count)});
    }

    void addLine(const QColor& colour, const QString& text) {
        m_rows.push_back({[colour](QPainter& painter, QPointF at) {
                              painter.setPen(QPen(colour, 1.5));
                              painter.drawLine(at - QPointF(8.0, 0.0), at + QPointF(8.0, 0.0));
                          },
                          text});
    }

    void addHatch() {
        m_rows.push_back({[this](QPainter& painter, QPointF at) {
                              painter.setPen(QPen(m_colours.cellEdge, 1.0));
                              painter.setBrush(QBrush(m_colours.label, Qt::BDiagPattern));
                              painter.drawRect(QRectF(at.x() - 7.5, at.y() - 4.5, 15.0, 9.0));
                          },
                          CanvasLegendTexts::tr("hidden fragment")});
    }

    void addBondMarks(const BondMarks& marks) {
        const auto hasAny = [](const std::vector<bool>& pieces) {
            return std::ranges::find(pieces, true) != pieces.end();
        };
        if (hasAny(marks.isAnchored)) {
            m_rows.push_back({[this](QPainter& painter, QPointF at) { paintAnchorSymbol(painter, at, m_colours); },
                              CanvasLegendTexts::tr("anchored")});
        }
        if (hasAny(marks.neverBreaks)) {
            m_rows.push_back({[this](QPainter& painter, QPointF at) { paintShieldSymbol(painter, at, m_colours); },
                              CanvasLegendTexts::tr("never breaks")});
        }
    }

    void paintPanel(QPainter& painter, const QRectF& panel) const {
        QColor fill = m_colours.panel;
        fill.setAlpha(235);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(m_colours.panelEdge, 1.0));
        painter.setBrush(fill);
        painter.drawRoundedRect(QRectF(panel.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    }

    void paintScale(QPainter& painter, const QRectF& area) const {
        const CellColouring colouring = m_contents.overlays.colouring;
        const QRectF ends =
            paintBar(painter, area, scaleTitle(colouring), [](double place) { return toQColor(rampColour(place)); });
        const QStringList texts = scaleTexts();
        const bool isOne = texts.size() == 1;
        painter.drawText(ends, (isOne ? Qt::AlignHCenter : Qt::AlignLeft) | Qt::AlignTop, texts.front());
        if (!isOne) painter.drawText(ends, Qt::AlignRight | Qt::AlignTop, texts.back());
    }

    /// The text below the scale: at its ends, or about all of it.
    QStringList scaleTexts() const {
        if (!hasScale()) return {};
        const CellColouring colouring = m_contents.overlays.colouring;
        const auto& [least, most] = m_contents.range;
        if (least == most) return {CanvasLegendTexts::tr("all: %1").arg(scaleText(colouring, least, m_contents))};
        return {scaleText(colouring, least, m_contents), scaleText(colouring, most, m_contents)};
    }

    /// The factors of bonds, on a logarithmic scale around 1.
    void paintBondScale(QPainter& painter, const QRectF& area) const {
        const auto colour = [this](double place) {
            return bondColour(kWeakestShown * std::pow(kStrongestShown / kWeakestShown, place), m_colours);
        };
        const QRectF ends = paintBar(painter, area, CanvasLegendTexts::tr("Strength of bonds"), colour);
        const auto paint = [&](Qt::Alignment side, const QString& text, double factor) {
            painter.drawText(ends, static_cast<int>((side | Qt::AlignTop).toInt()),
                             text.arg(QLocale().toString(factor)));
        };
        paint(Qt::AlignLeft, CanvasLegendTexts::tr("≤ %1"), kWeakestShown);
        paint(Qt::AlignHCenter, CanvasLegendTexts::tr("× %1"), 1.0);
        paint(Qt::AlignRight, CanvasLegendTexts::tr("≥ %1"), kStrongestShown);
    }

    /// Paints the title and the bar of a scale; returns the area of the numbers below it.
    QRectF paintBar(QPainter& painter, const QRectF& area, const QString& title,
                    const std::function<QColor(double)>& colour) const {
        painter.setPen(m_colours.text);
        painter.drawText(area, Qt::AlignTop | Qt::AlignLeft, title);
        const QRectF bar(area.left(), area.top() + 16.0, area.width(), 9.0);
        QLinearGradient ramp(bar.topLeft(), bar.topRight());
        for (int stop = 0; stop <= 10; ++stop) ramp.setColorAt(stop / 10.0, colour(stop / 10.0));
        painter.setBrush(ramp);
        painter.setPen(QPen(m_colours.panelEdge, 1.0));
        painter.drawRect(bar);
        painter.setPen(m_colours.text);
        return {area.left(), bar.bottom() + 1.0, area.width(), 16.0};
    }

    const CanvasContents& m_contents;
    const CanvasColours& m_colours;
    std::vector<Row> m_rows;
};

}  // namespace

QRectF paintLegend(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours) {
    return contents.pattern ? Legend(contents, colours).paint(painter, view) : QRectF();
}

QRectF legendArea(const QFont& font, const CanvasView& view, const CanvasContents& contents,
                  const CanvasColours& colours) {
    return contents.pattern ? Legend(contents, colours).area(font, view) : QRectF();
}

}  // namespace rubble
