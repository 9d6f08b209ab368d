#include "editor/canvas/tools/BondBrushTool.h"

#include "editor/widgets/NumberField.h"
#include "editor/widgets/input/BrushRing.h"

#include <QLocale>
#include <QWidgetAction>

namespace rubble {

namespace {

constexpr int kPathAlpha = 90;  // of the stroke that is being painted, of 255

}  // namespace

BondBrushTool::BondBrushTool(const CanvasState& state) : CanvasTool(state), m_painter(state.bondPainter) {
    connect(&m_painter, &BondPainter::changed, this, [this] {
        if (!m_painter.stroke()) m_isPainting = false;
        emit changed();
    });
}

/// A fragment whose solid is not known has no place in the asset's plane.
bool BondBrushTool::canPaint() const { return m_state.assetInItsPlane() && m_painter.asset(); }

Vec2 BondBrushTool::pointInAsset(const CanvasPointer& pointer) const { return pointer.metres + m_state.fragmentOffset; }

void BondBrushTool::press(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (!m_state.assetInItsPlane()) return;
    if (const QString reason = m_painter.refusal(pointer.modifiers); !reason.isEmpty())
        return emit statusMessage(reason);
    m_painter.begin(pointInAsset(pointer), m_painter.radiusPixels() / m_state.view.scale, pointer.modifiers);
    m_isPainting = true;
}

void BondBrushTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (m_isPainting) return m_painter.extend(pointInAsset(pointer));
    emit changed();
}

void BondBrushTool::release(const CanvasPointer&) {
    if (m_isPainting) m_painter.finish();
}

bool BondBrushTool::cancel() { return m_painter.cancel(); }

void BondBrushTool::leave() {
    m_pointer.reset();
    emit changed();
}

bool BondBrushTool::key(const QKeyEvent& event) { return m_painter.key(event.key()) || CanvasTool::key(event); }

bool BondBrushTool::controlWheel(double notches) {
    m_painter.stepSize(notches);
    return true;
}

/// Elsewhere brackets select parents and children.
bool BondBrushTool::overridesShortcut(int key) const { return m_painter.handlesKey(key); }

QColor BondBrushTool::colour(const CanvasColours& colours) const {
    const BondBrushSettings& settings = m_painter.settings();
    switch (settings.brush) {
        case BondBrush::Anchor: return colours.anchored;
        case BondBrush::Strength:
            return settings.strength == 1.0  ? colours.neutralBond
                   : settings.strength < 1.0 ? colours.weakBond
                                             : colours.strongBond;
        case BondBrush::NeverBreaks: break;
    }
    return colours.neverBreaks;
}

void BondBrushTool::paint(QPainter& painter, const CanvasColours& colours) const {
    if (!canPaint()) return;
    const BondStroke* current = m_painter.stroke();
    if (current) {
        QPolygonF line;
        for (const Vec2 point : current->points) line.push_back(m_state.view.pixels(point - m_state.fragmentOffset));
        if (line.size() == 1) line.push_back(line.front());
        QColor fill = current->isErasing ? colours.text : colour(colours);
        fill.setAlpha(kPathAlpha);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(
            QPen(fill, 2.0 * current->radius * m_state.view.scale, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    }
    if (!m_pointer) return;
    const bool isErasing = current ? current->isErasing : m_painter.erases(m_pointer->modifiers);
    paintBrushRing(painter, m_pointer->pixels, m_painter.radiusPixels(), isErasing ? colours.text : colour(colours),
                   colours.halo, isErasing);
}

Qt::CursorShape BondBrushTool::cursor() const { return canPaint() ? Qt::CrossCursor : Qt::ForbiddenCursor; }

QString BondBrushTool::actionHint() const {
    if (m_painter.settings().isErasing) return tr("Drag: erase");
    switch (m_painter.settings().brush) {
        case BondBrush::Anchor: return tr("Drag: anchor fragments");
        case BondBrush::Strength:
            return tr("Drag: make bonds %1 times as strong").arg(QLocale().toString(m_painter.settings().strength));
        case BondBrush::NeverBreaks: break;
    }
    return tr("Drag: let fragments never break");
}

QString BondBrushTool::hint() const {
    if (!m_state.assetInItsPlane()) return {};
    if (!canPaint()) return m_painter.refusal({});
    if (m_painter.stroke()) return tr("Release to finish · Esc: cancel");
    const QString hint = tr("%1 · Shift: invert · X: switch between paint and erase · [ ], Ctrl and wheel: size");
    return m_painter.settings().brush == BondBrush::Strength ? tr("%1 · , .: factor").arg(hint.arg(actionHint()))
                                                             : hint.arg(actionHint());
}

/// A field for any factor, and common ones as a group, of which the current one is checked.
void BondBrushTool::addStrengths(QMenu& menu) {
    QMenu* strengths = menu.addMenu(tr("Strength &Factor"));
    auto* field = new NumberField;
    field->setRange({.min = kBrushStrengths.front(), .max = kBrushStrengths.back()});
    field->setHint(tr("Set the factor by which the brush multiplies the strength of bonds"));
    field->setAccessibleName(tr("Strength Factor"));
    field->setValue(m_painter.settings().strength);
    connect(field, &NumberField::edited, &m_painter, &BondPainter::setStrength);
    auto* entry = new QWidgetAction(strengths);
    entry->setDefaultWidget(field);
    strengths->addAction(entry);
    strengths->addSeparator();
    for (const double strength : kBrushStrengths) {
        const QString text = QLocale().toString(strength);
        QAction* action = strengths->addAction(strength == 1.0 ? tr("%1 (neutral)").arg(text) : text, this,
                                               [this, strength] { m_painter.setStrength(strength); });
        action->setCheckable(true);
        action->setChecked(strength == m_painter.settings().strength);
    }
    menu.addSeparator();
}

void BondBrushTool::fillMenu(QMenu& menu, const CanvasPointer&) {
    menu.addAction(tr("Increase Brush &Size"), &m_painter, [this] { m_painter.stepSize(1.0); });
    menu.addAction(tr("&Decrease Brush Size"), &m_painter, [this] { m_painter.stepSize(-1.0); });
    menu.addSeparator();
    if (m_painter.settings().brush == BondBrush::Strength) addStrengths(menu);
    QAction* erase = menu.addAction(tr("&Erase"), this, [this](bool isOn) { m_painter.setErasing(isOn); });
    erase->setCheckable(true);
    erase->setChecked(m_painter.settings().isErasing);
}

}  // namespace rubble

#include "moc_BondBrushTool.cpp"
