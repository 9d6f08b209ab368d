#pragma once

#include "core/asset/Project.h"

#include <QColor>
#include <QPointer>
#include <QToolButton>

class QColorDialog;

namespace rubble {

QColor toQColor(const Colour& colour);
/// With eight bits a channel, as colours are picked.
Colour fromQColor(const QColor& colour);
/// A small picture of a colour, framed so that it is seen on any ground.
QIcon swatchIcon(const Colour& colour);

/// A swatch that opens a dialog to pick another colour. What is picked is told while the dialog is open, as one stroke;
/// cancelling it tells the colour from before.
class ColourButton : public QToolButton {
    Q_OBJECT
public:
    explicit ColourButton(QWidget* parent = nullptr);

    const Colour& value() const { return m_value; }
    void setValue(const Colour& colour);
    void setMixed();
    void setHint(const QString& hint);

signals:
    /// Edits that follow belong to one stroke.
    void strokeBegan();
    void edited(const rubble::Colour& colour);

private:
    void openDialog();
    void showValue();

    Colour m_value;
    bool m_isMixed = false;
    QPointer<QColorDialog> m_dialog;
};

}  // namespace rubble
