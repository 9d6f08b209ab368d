#pragma once

#include <QAccessible>

class QWidget;

namespace rubble {

/// Sets what a widget of a class of its own is for assistive technologies, such as a slider or a chart. Without a role,
/// it is an unknown client area.
void setAccessibleRole(QWidget& widget, QAccessible::Role role);

}  // namespace rubble
