#include "editor/canvas/tools/BondBrushTool.h"

#include "core/asset/project/Ranges.h"
#include "editor/canvas/tools/LineSimplification.h"
#include "editor/commands/ProjectEdits.h"

#include <QLocale>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr double kPathTolerance = 0.25;  // of the radius: within which points of a stroke are left out
constexpr double kMaxStrength = 10.0;
constexpr std::array kStrengths{0.0, 0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0};
constexpr int kPathAlpha = 90;  // of the stroke that is being painted, of 255

QString strokeText(BondBrush brush, bool isErasing) {
    switch (brush) {
        case BondBrush::Anchor:
            return isErasing ? BondBrushTool::tr("Erase Anchors") : BondBrushTool::tr("Paint Anchors");
        case BondBrush::Strength:
            return isErasing ? BondBrushTool::tr("Erase Bond Strength") : BondBrushTool::tr("Paint Bond Strength");
        case BondBrush::NeverBreaks: break;
    }
    return isErasing ? BondBrushTool::tr("Erase Never Breaks") : BondBrushTool::tr("Paint Never Breaks");
}

}  // namespace

/// A fragment whose solid is not known has no place in the asset's plane.
bool BondBrushTool::canPaint() const { return m_state.displayedAsset() && m_state.asset()->breakAs == BreakAs::Bonded; }

bool BondBrushTool::erases(Qt::KeyboardModifiers modifiers) const {
    return m_isErasing != modifiers.testFlag(Qt::ShiftModifier);
}

/// In metres.
double BondBrushTool::radius() const {
    const NumberRange& range = rangeOf(ProjectNumber::BondBrushRadius);
    return std::clamp(m_size.radiusPixels() / m_state.view.scale, range.min, range.max);
}

void BondBrushTool::press(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (!canPaint()) return emit statusMessage(hint());
    const bool isErasing = erases(pointer.modifiers);
    const std::vector<BondStroke>& strokes = m_state.asset()->bonding.strokes;
    if (isErasing && std::ranges::find(strokes, m_brush, &BondStroke::brush) == strokes.end())
        return emit statusMessage(tr("There are no strokes of this brush to erase."));
    m_state.stroke = BondStroke{.brush = m_brush, .isErasing = isErasing, .radius = radius()};
    if (m_brush == BondBrush::Strength && !isErasing) m_state.stroke->strength = m_strength;
    m_path.clear();
    extend(pointer.metres + m_state.fragmentOffset);
    emit changed();
}

/// Leads the stroke to a point.
void BondBrushTool::extend(Vec2 point) {
    m_path.push_back(point);
    m_state.stroke->points = simplified(m_path, kPathTolerance * m_state.stroke->radius);
}

void BondBrushTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (m_state.stroke) extend(pointer.metres + m_state.fragmentOffset);
    emit changed();
}

void BondBrushTool::release(const CanvasPointer&) {
    if (m_state.stroke && m_state.asset()) {
        Asset asset = *m_state.asset();
        const QString text = strokeText(m_state.stroke->brush, m_state.stroke->isErasing);
        asset.bonding.strokes.push_back(*std::exchange(m_state.stroke, std::nullopt));
        m_state.push(modify(text, std::move(asset)));
    }
    endDrag();
}

bool BondBrushTool::cancel() {
    if (!m_state.stroke) return false;
    endDrag();
    return true;
}

void BondBrushTool::endDrag() {
    m_state.stroke.reset();
    m_path.clear();
    emit changed();
}

void BondBrushTool::leave() {
    m_pointer.reset();
    emit changed();
}

void BondBrushTool::setBrush(BondBrush brush) {
    m_brush = brush;
    emit changed();
}

void BondBrushTool::setRadiusPixels(double radius) {
    m_size.setRadiusPixels(radius);
    emit changed();
}

void BondBrushTool::stepSize(double steps) {
    m_size.step(steps);
    emit changed();
}

void BondBrushTool::setStrength(double strength) {
    m_strength = std::clamp(strength, 0.0, kMaxStrength);
    emit changed();
}

/// To the next of kStrengths above (1) or below (-1).
void BondBrushTool::stepStrength(int direction) {
    if (direction > 0) {
        const auto* above = std::ranges::upper_bound(kStrengths, m_strength);
        setStrength(above == kStrengths.end() ? kMaxStrength : *above);
    } else {
        const auto* from = std::ranges::lower_bound(kStrengths, m_strength);
        setStrength(from == kStrengths.begin() ? 0.0 : *(from - 1));
    }
}

bool BondBrushTool::key(const QKeyEvent& event) {
    if (!overridesShortcut(event.key())) return CanvasTool::key(event);
    switch (event.key()) {
        case Qt::Key_BracketLeft: stepSize(-1.0); break;
        case Qt::Key_BracketRight: stepSize(1.0); break;
        case Qt::Key_Comma: stepStrength(-1); break;
        case Qt::Key_Period: stepStrength(1); break;
        default: m_isErasing = !m_isErasing; emit changed();
    }
    return true;
}

bool BondBrushTool::controlWheel(double notches) {
    stepSize(notches);
    return true;
}

/// Elsewhere brackets select parents and children.
bool BondBrushTool::overridesShortcut(int key) const {
    if (m_brush == BondBrush::Strength && (key == Qt::Key_Comma || key == Qt::Key_Period)) return true;
    return key == Qt::Key_BracketLeft || key == Qt::Key_BracketRight || key == Qt::Key_X;
}

QColor BondBrushTool::colour(const CanvasColours& colours) const {
    switch (m_brush) {
        case BondBrush::Anchor: return colours.anchored;
        case BondBrush::Strength:
            return m_strength == 1.0 ? colours.neutralBond : m_strength < 1.0 ? colours.weakBond : colours.strongBond;
        case BondBrush::NeverBreaks: break;
    }
    return colours.neverBreaks;
}

void BondBrushTool::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!canPaint()) return;
    if (m_state.stroke) {
        QPolygonF line;
        for (const Vec2 point : m_state.stroke->points)
            line.push_back(m_state.view.pixels(point - m_state.fragmentOffset));
        if (line.size() == 1) line.push_back(line.front());
        QColor fill = m_state.stroke->isErasing ? colours.text : colour(colours);
        fill.setAlpha(kPathAlpha);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(
            QPen(fill, 2.0 * m_state.stroke->radius * m_state.view.scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    if (!m_pointer) return;
    const bool isErasing = m_state.stroke ? m_state.stroke->isErasing : erases(m_pointer->modifiers);
    m_size.paintRing(painter, m_pointer->pixels, 1.0, isErasing ? colours.text : colour(colours), colours.halo,
                     isErasing);
}

Qt::CursorShape BondBrushTool::cursor() const { return canPaint() ? Qt::CrossCursor : Qt::ForbiddenCursor; }

QString BondBrushTool::actionHint() const {
    if (m_isErasing) return tr("Drag: erase");
    switch (m_brush) {
        case BondBrush::Anchor: return tr("Drag: anchor fragments");
        case BondBrush::Strength: return tr("Drag: make bonds %1 times as strong").arg(QLocale().toString(m_strength));
        case BondBrush::NeverBreaks: break;
    }
    return tr("Drag: let fragments never break");
}

QString BondBrushTool::hint() const {
    if (!m_state.displayedAsset()) return {};
    if (!canPaint()) return tr("This asset breaks whole. Set \"Break as\" to Bonded in the inspector to paint bonds.");
    if (m_state.stroke) return tr("Release to finish · Esc: cancel");
    const QString hint = tr("%1 · Shift: invert · X: switch between paint and erase · [ ], Ctrl and wheel: size");
    return m_brush == BondBrush::Strength ? tr("%1 · , .: factor").arg(hint.arg(actionHint())) : hint.arg(actionHint());
}

/// The factors as a group, of which the current one is checked.
void BondBrushTool::addStrengths(QMenu& menu) {
    QMenu* strengths = menu.addMenu(tr("Strength &Factor"));
    for (const double strength : kStrengths) {
        const QString text = QLocale().toString(strength);
        QAction* action = strengths->addAction(strength == 1.0 ? tr("%1 (neutral)").arg(text) : text, this,
                                               [this, strength] { setStrength(strength); });
        action->setCheckable(true);
        action->setChecked(strength == m_strength);
    }
    menu.addSeparator();
}

void BondBrushTool::fillMenu(QMenu& menu, const CanvasPointer&) {
    menu.addAction(tr("Increase Brush &Size"), this, [this] { stepSize(1.0); });
    menu.addAction(tr("&Decrease Brush Size"), this, [this] { stepSize(-1.0); });
    menu.addSeparator();
    if (m_brush == BondBrush::Strength) addStrengths(menu);
    QAction* erase = menu.addAction(tr("&Erase"), this, [this](bool isOn) {
        m_isErasing = isOn;
        emit changed();
    });
    erase->setCheckable(true);
    erase->setChecked(m_isErasing);
}

}  // namespace rubble

#include "moc_BondBrushTool.cpp"
