#pragma once

#include "editor/panels/NumberField.h"

#include <QSlider>
#include <QWidget>

namespace rubble {

enum class SliderScale { Linear, Logarithmic };

/// A slider with the number beside it. The slider covers the usual values; any that the field's range allows may be typed.
/// A drag of the slider is one stroke.
class SliderField : public QWidget {
    Q_OBJECT
public:
    /// `from` and `to` are the slider's ends; above zero for a logarithmic scale.
    SliderField(const FieldRange& range, double from, double to, SliderScale scale = SliderScale::Linear,
                QWidget* parent = nullptr);

    NumberField& field() { return *m_field; }
    QSlider& slider() { return *m_slider; }
    double value() const { return m_field->value(); }
    /// Shows a number; not told by `edited`. A drag that gave another one ends.
    void setValue(double value);
    void setMixed();
    void setFormat(const NumberFormat& format) { m_field->setFormat(format); }
    /// Takes other ends for the slider.
    void setEnds(double from, double to);
    void setHint(const QString& hint);
    void setName(const QString& name);

signals:
    /// Edits that follow belong to one stroke.
    void strokeBegan();
    void edited(double value);

private:
    void showOnSlider();
    void takeFromSlider();
    double valueAt(int position) const;
    int positionOf(double value) const;

    QSlider* m_slider;
    NumberField* m_field;
    double m_from;
    double m_to;
    SliderScale m_scale;
    StepRun m_run;
};

}  // namespace rubble
