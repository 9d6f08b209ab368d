#pragma once

#include "editor/commands/BondStrokes.h"
#include "editor/commands/BrushSize.h"
#include "editor/document/Document.h"
#include "editor/document/Selection.h"

#include <QObject>

#include <optional>

namespace rubble {

/// The brush that paints the bonds of the active asset: its settings and the stroke that is being painted. The tools of
/// the canvas and of the 3D view share one.
///
/// A stroke is one edit, made when it is finished. Undo, redo, another edit of the asset and another active asset
/// cancel it.
class BondPainter : public QObject {
    Q_OBJECT
public:
    BondPainter(Document& document, const Selection& selection);

    /// Whether it is the current tool of the views.
    bool isOn() const { return m_isOn; }
    /// Cancels the stroke if it is switched off.
    void setOn(bool isOn);

    const BondBrushSettings& settings() const { return m_settings; }
    void setBrush(BondBrush brush);
    void setErasing(bool isErasing);
    /// `strength`: of BondBrush::Strength; brought into the range of kBrushStrengths.
    void setStrength(double strength);
    double radiusPixels() const { return m_size.radiusPixels(); }
    void setRadiusPixels(double radius);
    /// See BrushSize::step().
    void stepSize(double steps);
    /// Whether a stroke with these modifier keys erases: Shift inverts.
    bool erases(Qt::KeyboardModifiers modifiers) const;

    /// Whether a key (without modifiers) changes the settings.
    bool handlesKey(int key) const;
    /// Changes the settings by a key; false if it is not one of the brush.
    bool key(int key);

    /// The active asset if it breaks as bonded and can be painted; else null.
    const Asset* asset() const;
    /// Why no stroke can be painted with these modifier keys, as a sentence; empty if one can.
    QString refusal(Qt::KeyboardModifiers modifiers) const;
    /// Starts a stroke at a point of the asset's plane, if there is no refusal(). `radius`: m.
    void begin(Vec2 point, double radius, Qt::KeyboardModifiers modifiers);
    /// Leads the stroke, if there is one, to a point of the asset's plane.
    void extend(Vec2 point);
    /// Pushes the stroke, if there is one.
    void finish();
    /// Ends the stroke without an edit; false if there is none.
    bool cancel();
    /// The stroke that is being painted; null if there is none.
    const BondStroke* stroke() const { return m_path ? &m_path->stroke() : nullptr; }

signals:
    /// It was switched on or off, or its settings or the stroke changed.
    void changed();

private:
    void setSettings(const BondBrushSettings& settings);

    Document& m_document;
    const Selection& m_selection;
    bool m_isOn = false;
    BondBrushSettings m_settings;
    BrushSize m_size;
    std::optional<BondStrokePath> m_path;
};

}  // namespace rubble
