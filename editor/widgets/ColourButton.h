#pragma once

#include "core/asset/project/Project.h"

#include <QPointer>
#include <QToolButton>

class QColorDialog;

namespace rubble {

/// A framed swatch of a colour.
QIcon swatchIcon(const Colour& colour);

/// A swatch that opens the colour dialog. Each colour picked is emitted while the dialog is open, all as one undo step;
/// cancelling emits the previous colour.
class ColourButton : public QToolButton {
    Q_OBJECT
public:
    explicit ColourButton(QWidget* parent = nullptr);

    const Colour& value() const { return m_value; }
    void setValue(const Colour& colour);
    void setMixed();
    void setHint(const QString& hint);

signals:
    /// The edits that follow merge into one undo step.
    void editingStarted();
    void edited(const rubble::Colour& colour);

private:
    void openDialog();
    void showValue();

    Colour m_value;
    bool m_isMixed = false;
    QPointer<QColorDialog> m_dialog;
};

}  // namespace rubble
