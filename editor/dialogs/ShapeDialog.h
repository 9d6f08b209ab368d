#pragma once

#include "editor/widgets/numbers/Units.h"

#include <QDialog>

class QFormLayout;

namespace rubble {

class NumberField;

/// Asks for the lengths of a new shape.
class ShapeDialog : public QDialog {
    Q_OBJECT
public:
    struct Length {
        QString label;
        double value = 1.0;  // m, at first
    };
    ShapeDialog(const QString& title, const QList<Length>& lengths, const Units& units, QWidget* parent);

    /// Adds a field for the number of corners.
    void addCorners(int value);

    double length(int index) const;
    int corners() const;

    /// Stays open while a field's text is refused.
    void accept() override;

private:
    QFormLayout* m_form;
    QList<NumberField*> m_lengths;
    NumberField* m_corners = nullptr;
};

}  // namespace rubble
