#include "editor/canvas/tools/BondBrushTool.h"

#include "editor/widgets/NumberField.h"

#include <QLocale>
#include <QWidgetAction>

#include <algorithm>
#include <utility>

namespace rubble {

namespace {

constexpr int kPathAlpha = 90;  // of the stroke that is being painted, of 255

}  // namespace

/// A fragment whose solid is not known has no place in the asset's plane.
bool BondBrushTool::canPaint() const { return m_state.displayedAsset() && m_state.asset()->breakAs == BreakAs::Bonded; }

bool BondBrushTool::erases(Qt::KeyboardModifiers modifiers) const {
    return m_settings.isErasing != modifiers.testFlag(Qt::ShiftModifier);
}

void BondBrushTool::press(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (!canPaint()) return emit statusMessage(hint());
    BondBrushSettings settings = m_settings;
    settings.isErasing = erases(pointer.modifiers);
    if (settings.isErasing && !hasStrokes(*m_state.asset(), settings.brush))
        return emit statusMessage(tr("There are no strokes of this brush to erase."));
    m_path.emplace(settings, m_size.radiusPixels() / m_state.view.scale);
    extend(pointer);
    emit changed();
}

void BondBrushTool::extend(const CanvasPointer& pointer) {
    m_path->extend(pointer.metres + m_state.fragmentOffset);
    m_state.stroke = m_path->stroke();
}

void BondBrushTool::move(const CanvasPointer& pointer) {
    m_pointer = pointer;
    if (m_path) extend(pointer);
    emit changed();
}

void BondBrushTool::release(const CanvasPointer&) {
    if (m_path && m_state.asset()) {
        m_state.stroke.reset();
        m_state.push(paintStroke(*m_state.asset(), std::exchange(m_path, std::nullopt)->stroke()));
    }
    endDrag();
}

bool BondBrushTool::cancel() {
    if (!m_path) return false;
    endDrag();
    return true;
}

void BondBrushTool::endDrag() {
    m_path.reset();
    m_state.stroke.reset();
    emit changed();
}

void BondBrushTool::leave() {
    m_pointer.reset();
    emit changed();
}

void BondBrushTool::setSettings(const BondBrushSettings& settings) {
    if (settings == m_settings) return;
    m_settings = settings;
    emit changed();
    emit settingsChanged();
}

void BondBrushTool::setBrush(BondBrush brush) {
    BondBrushSettings settings = m_settings;
    settings.brush = brush;
    setSettings(settings);
}

void BondBrushTool::setErasing(bool isErasing) {
    BondBrushSettings settings = m_settings;
    settings.isErasing = isErasing;
    setSettings(settings);
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
    BondBrushSettings settings = m_settings;
    settings.strength = std::clamp(strength, kBrushStrengths.front(), kBrushStrengths.back());
    setSettings(settings);
}

bool BondBrushTool::key(const QKeyEvent& event) {
    if (!overridesShortcut(event.key())) return CanvasTool::key(event);
    switch (event.key()) {
        case Qt::Key_BracketLeft: stepSize(-1.0); break;
        case Qt::Key_BracketRight: stepSize(1.0); break;
        case Qt::Key_Comma: setStrength(nextBrushStrength(strength(), -1)); break;
        case Qt::Key_Period: setStrength(nextBrushStrength(strength(), 1)); break;
        default: setErasing(!m_settings.isErasing);
    }
    return true;
}

bool BondBrushTool::controlWheel(double notches) {
    stepSize(notches);
    return true;
}

/// Elsewhere brackets select parents and children.
bool BondBrushTool::overridesShortcut(int key) const {
    if (m_settings.brush == BondBrush::Strength && (key == Qt::Key_Comma || key == Qt::Key_Period)) return true;
    return key == Qt::Key_BracketLeft || key == Qt::Key_BracketRight || key == Qt::Key_X;
}

QColor BondBrushTool::colour(const CanvasColours& colours) const {
    switch (m_settings.brush) {
        case BondBrush::Anchor: return colours.anchored;
        case BondBrush::Strength:
            return m_settings.strength == 1.0  ? colours.neutralBond
                   : m_settings.strength < 1.0 ? colours.weakBond
                                               : colours.strongBond;
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
    if (m_settings.isErasing) return tr("Drag: erase");
    switch (m_settings.brush) {
        case BondBrush::Anchor: return tr("Drag: anchor fragments");
        case BondBrush::Strength:
            return tr("Drag: make bonds %1 times as strong").arg(QLocale().toString(m_settings.strength));
        case BondBrush::NeverBreaks: break;
    }
    return tr("Drag: let fragments never break");
}

QString BondBrushTool::hint() const {
    if (!m_state.displayedAsset()) return {};
    if (!canPaint()) return tr("This asset breaks whole. Set \"Break as\" to Bonded in the inspector to paint bonds.");
    if (m_path) return tr("Release to finish · Esc: cancel");
    const QString hint = tr("%1 · Shift: invert · X: switch between paint and erase · [ ], Ctrl and wheel: size");
    return m_settings.brush == BondBrush::Strength ? tr("%1 · , .: factor").arg(hint.arg(actionHint()))
                                                   : hint.arg(actionHint());
}

/// A field for any factor, and common ones as a group, of which the current one is checked.
void BondBrushTool::addStrengths(QMenu& menu) {
    QMenu* strengths = menu.addMenu(tr("Strength &Factor"));
    auto* field = new NumberField;
    field->setRange({.min = kBrushStrengths.front(), .max = kBrushStrengths.back()});
    field->setHint(tr("Set the factor by which the brush multiplies the strength of bonds"));
    field->setAccessibleName(tr("Strength Factor"));
    field->setValue(m_settings.strength);
    connect(field, &NumberField::edited, this, &BondBrushTool::setStrength);
    auto* entry = new QWidgetAction(strengths);
    entry->setDefaultWidget(field);
    strengths->addAction(entry);
    strengths->addSeparator();
    for (const double strength : kBrushStrengths) {
        const QString text = QLocale().toString(strength);
        QAction* action = strengths->addAction(strength == 1.0 ? tr("%1 (neutral)").arg(text) : text, this,
                                               [this, strength] { setStrength(strength); });
        action->setCheckable(true);
        action->setChecked(strength == m_settings.strength);
    }
    menu.addSeparator();
}

void BondBrushTool::fillMenu(QMenu& menu, const CanvasPointer&) {
    menu.addAction(tr("Increase Brush &Size"), this, [this] { stepSize(1.0); });
    menu.addAction(tr("&Decrease Brush Size"), this, [this] { stepSize(-1.0); });
    menu.addSeparator();
    if (m_settings.brush == BondBrush::Strength) addStrengths(menu);
    QAction* erase = menu.addAction(tr("&Erase"), this, [this](bool isOn) { setErasing(isOn); });
    erase->setCheckable(true);
    erase->setChecked(m_settings.isErasing);
}

}  // namespace rubble

#include "moc_BondBrushTool.cpp"
