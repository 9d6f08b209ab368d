#include "editor/commands/BondPainter.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <utility>

namespace rubble {

BondPainter::BondPainter(Document& document, const Selection& selection)
    : m_document(document), m_selection(selection) {
    connect(&document, &Document::changed, this, [this](const Changes& changes) {
        if (changes.isUndoOrRedo || changes.touches(Part::Asset, m_selection.asset())) cancel();
    });
    connect(&selection, &Selection::assetChanged, this, &BondPainter::cancel);
}

void BondPainter::setOn(bool isOn) {
    if (isOn == m_isOn) return;
    m_isOn = isOn;
    m_path.reset();
    emit changed();
}

void BondPainter::setSettings(const BondBrushSettings& settings) {
    if (settings == m_settings) return;
    m_settings = settings;
    emit changed();
}

void BondPainter::setBrush(BondBrush brush) {
    BondBrushSettings settings = m_settings;
    settings.brush = brush;
    setSettings(settings);
}

void BondPainter::setErasing(bool isErasing) {
    BondBrushSettings settings = m_settings;
    settings.isErasing = isErasing;
    setSettings(settings);
}

void BondPainter::setStrength(double strength) {
    BondBrushSettings settings = m_settings;
    settings.strength = std::clamp(strength, kBrushStrengths.front(), kBrushStrengths.back());
    setSettings(settings);
}

void BondPainter::setRadiusPixels(double radius) {
    m_size.setRadiusPixels(radius);
    emit changed();
}

void BondPainter::stepSize(double steps) {
    m_size.step(steps);
    emit changed();
}

bool BondPainter::erases(Qt::KeyboardModifiers modifiers) const {
    return m_settings.isErasing != modifiers.testFlag(Qt::ShiftModifier);
}

bool BondPainter::handlesKey(int key) const {
    if (m_settings.brush == BondBrush::Strength && (key == Qt::Key_Comma || key == Qt::Key_Period)) return true;
    return key == Qt::Key_BracketLeft || key == Qt::Key_BracketRight || key == Qt::Key_X;
}

bool BondPainter::key(int key) {
    if (!handlesKey(key)) return false;
    switch (key) {
        case Qt::Key_BracketLeft: stepSize(-1.0); break;
        case Qt::Key_BracketRight: stepSize(1.0); break;
        case Qt::Key_Comma: setStrength(nextBrushStrength(m_settings.strength, -1)); break;
        case Qt::Key_Period: setStrength(nextBrushStrength(m_settings.strength, 1)); break;
        default: setErasing(!m_settings.isErasing);
    }
    return true;
}

const Asset* BondPainter::asset() const {
    const Asset* active = findAsset(m_document.project(), m_selection.asset());
    return active && active->breakAs == BreakAs::Bonded ? active : nullptr;
}

QString BondPainter::refusal(Qt::KeyboardModifiers modifiers) const {
    if (!asset()) return tr("This asset breaks whole. Set \"Break as\" to Bonded in the inspector to paint bonds.");
    if (erases(modifiers) && !hasStrokes(*asset(), m_settings.brush))
        return tr("There are no strokes of this brush to erase.");
    return {};
}

void BondPainter::begin(Vec2 point, double radius, Qt::KeyboardModifiers modifiers) {
    RUBBLE_ASSERT(refusal(modifiers).isEmpty());
    cancel();  // of the other view, which missed the release of the button
    BondBrushSettings settings = m_settings;
    settings.isErasing = erases(modifiers);
    m_path.emplace(settings, radius);
    extend(point);
}

void BondPainter::extend(Vec2 point) {
    if (!m_path) return;
    m_path->extend(point);
    emit changed();
}

void BondPainter::finish() {
    if (!m_path) return;
    const BondStrokePath path = *std::exchange(m_path, std::nullopt);
    if (const Asset* painted = asset()) m_document.push(paintStroke(*painted, path.stroke()));
    emit changed();
}

bool BondPainter::cancel() {
    if (!m_path) return false;
    m_path.reset();
    emit changed();
    return true;
}

}  // namespace rubble

#include "moc_BondPainter.cpp"
