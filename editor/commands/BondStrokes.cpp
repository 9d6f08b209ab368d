#include "editor/commands/BondStrokes.h"

#include "core/asset/project/Ranges.h"
#include "core/geometry/line/LineSimplification.h"
#include "editor/commands/ProjectEdits.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr double kPathTolerance = 0.25;  // of the radius

struct BondStrokeTexts {
    Q_DECLARE_TR_FUNCTIONS(BondStrokes)
};

QString strokeText(BondBrush brush, bool isErasing) {
    switch (brush) {
        case BondBrush::Anchor:
            return isErasing ? BondStrokeTexts::tr("Erase Anchors") : BondStrokeTexts::tr("Paint Anchors");
        case BondBrush::Strength:
            return isErasing ? BondStrokeTexts::tr("Erase Bond Strength") : BondStrokeTexts::tr("Paint Bond Strength");
        case BondBrush::NeverBreaks: break;
    }
    return isErasing ? BondStrokeTexts::tr("Erase Never Breaks") : BondStrokeTexts::tr("Paint Never Breaks");
}

}  // namespace

double nextBrushStrength(double strength, int direction) {
    if (direction > 0) {
        const auto* above = std::ranges::upper_bound(kBrushStrengths, strength);
        return above == kBrushStrengths.end() ? kBrushStrengths.back() : *above;
    }
    const auto* from = std::ranges::lower_bound(kBrushStrengths, strength);
    return from == kBrushStrengths.begin() ? kBrushStrengths.front() : *(from - 1);
}

bool hasStrokes(const Asset& asset, BondBrush brush) {
    const std::vector<BondStroke>& strokes = asset.bonding.strokes;
    return std::ranges::find(strokes, brush, &BondStroke::brush) != strokes.end();
}

BondStrokePath::BondStrokePath(const BondBrushSettings& settings, double radius) {
    const NumberRange& range = rangeOf(ProjectNumber::BondBrushRadius);
    m_stroke.brush = settings.brush;
    m_stroke.isErasing = settings.isErasing;
    m_stroke.radius = std::clamp(radius, range.min, range.max);
    if (settings.brush == BondBrush::Strength && !settings.isErasing) m_stroke.strength = settings.strength;
}

void BondStrokePath::extend(Vec2 point) {
    m_points.push_back(point);
    m_stroke.points = simplified(m_points, kPathTolerance * m_stroke.radius);
}

Edit paintStroke(Asset asset, BondStroke stroke) {
    const QString text = strokeText(stroke.brush, stroke.isErasing);
    asset.bonding.strokes.push_back(std::move(stroke));
    return modify(text, std::move(asset));
}

}  // namespace rubble
