#pragma once

#include "core/io/project/ProjectFile.h"
#include "editor/background/MortarWatch.h"
#include "editor/panels/inspector/Inspector.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/Patience.h"
#include "tests/support/asset/Projects.h"

#include <QApplication>
#include <QSignalSpy>
#include <QSlider>
#include <QStyle>
#include <QTest>

namespace rubble::test {

/// A document with the inspector in a window.
struct InspectorDesk {
    Document document;
    Selection selection;
    Bakes bakes;
    MortarWatch mortars{document, bakes};
    Inspector inspector{document, selection, bakes, mortars};
    QSignalSpy refusals{&inspector, &Inspector::refused};

    explicit InspectorDesk(Project project = fullProject()) : document(std::move(project)) {
        selection.prune(document.project());
        inspector.resize(360, 900);
        inspector.show();
        inspector.activateWindow();
        if (!QTest::qWaitForWindowActive(&inspector, kPatience)) qFatal("The window does not become active.");
    }
    const Asset& asset(Id id = 9) const { return *findAsset(document.project(), id); }
    std::string text() const { return projectText(document.project()); }

    /// The control of the visible page with this accessible name.
    template <class Control>
    Control& control(const QString& name) {
        for (Control* control : inspector.page().findChildren<Control*>()) {
            if (control->accessibleName() == name) return *control;
        }
        qFatal("There is no control \"%s\".", qPrintable(name));
    }
    void type(const QString& name, const QString& text) {
        auto& field = control<NumberField>(name);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
    }
    void undoAll() {
        while (document.undoStack().canUndo()) document.undoStack().undo();
    }
};

/// Drags a slider's handle to its right end.
inline void drag(QSlider& slider) {
    constexpr int kHalfHandle = 6;
    const int middle = slider.height() / 2;
    const int from = kHalfHandle + QStyle::sliderPositionFromValue(slider.minimum(), slider.maximum(), slider.value(),
                                                                   slider.width() - 2 * kHalfHandle);
    QTest::mousePress(&slider, Qt::LeftButton, {}, {from, middle});
    for (int x = from; x < slider.width(); x += 5) QTest::mouseMove(&slider, {x, middle});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {slider.width() - 2, middle});
}

}  // namespace rubble::test
