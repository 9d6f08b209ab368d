#pragma once

#include "editor/widgets/ColourButton.h"
#include "editor/widgets/ComboBox.h"
#include "editor/widgets/RandomSeedField.h"
#include "editor/widgets/SliderField.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QToolTip>

#include <functional>

namespace rubble {

/// The interface that Form expects of a control, overloaded for each class of controls:
///   showIn        shows a value without emitting a signal
///   showMixedIn   shows that the edited values differ
///   refuseIn      keeps the value that was entered as text and says why it is refused, where a control can
///   connectRefused  calls `refused` with the reason when a typed text is no value
///   connectTo     calls `begin` before edits that merge into one undo step, and `enter` with each value entered

using Begin = std::function<void()>;

using OnRefused = std::function<void(const QString&)>;

inline void connectRefused(QWidget&, const OnRefused&) {}
inline void refuseIn(QWidget& control, const QString& sentence) {
    QToolTip::showText(control.mapToGlobal(QPoint(0, control.height())), sentence, &control);
}

inline void showIn(NumberField& field, double value) { field.setValue(value); }
inline void showMixedIn(NumberField& field) { field.setMixed(); }
inline void connectRefused(NumberField& field, const OnRefused& refused) {
    QObject::connect(&field, &NumberField::refused, &field, refused);
}
inline void refuseIn(NumberField& field, const QString& sentence) { field.refuseEntered(sentence); }
inline void connectTo(NumberField& field, const Begin& begin, const std::function<void(double)>& enter) {
    QObject::connect(&field, &NumberField::editingStarted, &field, begin);
    QObject::connect(&field, &NumberField::edited, &field, enter);
}

inline void showIn(SliderField& field, double value) { field.setValue(value); }
inline void showMixedIn(SliderField& field) { field.setMixed(); }
inline void connectRefused(SliderField& field, const OnRefused& refused) { connectRefused(field.field(), refused); }
inline void refuseIn(SliderField& field, const QString& sentence) { field.field().refuseEntered(sentence); }
inline void connectTo(SliderField& field, const Begin& begin, const std::function<void(double)>& enter) {
    QObject::connect(&field, &SliderField::editingStarted, &field, begin);
    QObject::connect(&field, &SliderField::edited, &field, enter);
}

inline void showIn(ColourButton& button, const Colour& colour) { button.setValue(colour); }
inline void showMixedIn(ColourButton& button) { button.setMixed(); }
inline void connectTo(ColourButton& button, const Begin& begin, const std::function<void(const Colour&)>& enter) {
    QObject::connect(&button, &ColourButton::editingStarted, &button, begin);
    QObject::connect(&button, &ColourButton::edited, &button, enter);
}

inline void showIn(RandomSeedField& field, quint64 value) { field.setValue(value); }
inline void showMixedIn(RandomSeedField& field) { field.setMixed(); }
inline void connectRefused(RandomSeedField& field, const OnRefused& refused) {
    QObject::connect(&field, &RandomSeedField::refused, &field, refused);
}
inline void connectTo(RandomSeedField& field, const Begin& begin, const std::function<void(quint64)>& enter) {
    QObject::connect(&field, &RandomSeedField::edited, &field, [=](quint64 value) {
        begin();
        enter(value);
    });
}

inline void showIn(QCheckBox& box, bool isOn) {
    box.setTristate(false);
    box.setChecked(isOn);
}
inline void showMixedIn(QCheckBox& box) { box.setCheckState(Qt::PartiallyChecked); }
inline void connectTo(QCheckBox& box, const Begin& begin, const std::function<void(bool)>& enter) {
    QObject::connect(&box, &QCheckBox::clicked, &box, [=, &box](bool isOn) {
        box.setTristate(false);
        begin();
        enter(isOn);
    });
}

/// The value is the current item's data.
inline void showIn(QComboBox& box, Id value) { box.setCurrentIndex(box.findData(value)); }
inline void showMixedIn(QComboBox& box) { box.setCurrentIndex(-1); }
inline void connectTo(QComboBox& box, const Begin& begin, const std::function<void(Id)>& enter) {
    QObject::connect(&box, &QComboBox::activated, &box, [=, &box](int row) {
        begin();
        enter(box.itemData(row).toUInt());
    });
}

inline void showIn(QLineEdit& line, const QString& text) {
    if (line.text() != text) line.setText(text);
    line.setModified(false);
}
inline void showMixedIn(QLineEdit& line) { line.clear(); }
inline void connectTo(QLineEdit& line, const Begin& begin, const std::function<void(const QString&)>& enter) {
    QObject::connect(&line, &QLineEdit::editingFinished, &line, [=, &line] {
        if (!line.isModified()) return;
        line.setModified(false);
        begin();
        enter(line.text());
    });
}

}  // namespace rubble
