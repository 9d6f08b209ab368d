#pragma once

#include "editor/window/MainWindow.h"

#include <QApplication>
#include <QList>

namespace rubble::test {

/// The top-level widgets of a class, also hidden ones.
template <class Window = MainWindow>
QList<Window*> windows() {
    QList<Window*> windows;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* window = qobject_cast<Window*>(widget)) windows.append(window);
    }
    return windows;
}

/// The first of them that is visible; null if there is none.
template <class Window = MainWindow>
Window* visibleWindow() {
    for (Window* window : windows<Window>()) {
        if (window->isVisible()) return window;
    }
    return nullptr;
}

}  // namespace rubble::test
