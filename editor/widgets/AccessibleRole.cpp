#include "editor/widgets/AccessibleRole.h"

#include <QAccessibleWidget>
#include <QVariant>
#include <QWidget>

namespace rubble {

namespace {

constexpr const char* kRoleProperty = "accessibleRole";

QAccessibleInterface* accessibleOf(const QString& /*className*/, QObject* object) {
    const QVariant role = object ? object->property(kRoleProperty) : QVariant();
    auto* widget = qobject_cast<QWidget*>(object);
    if (!widget || !role.isValid()) return nullptr;
    return new QAccessibleWidget(widget, static_cast<QAccessible::Role>(role.toInt()));
}

}  // namespace

void setAccessibleRole(QWidget& widget, QAccessible::Role role) {
    QAccessible::installFactory(accessibleOf);  // once: Qt ignores a factory that it has
    widget.setProperty(kRoleProperty, static_cast<int>(role));
    // Qt may have created an interface without the role, when the widget got its name.
    QAccessible::deleteAccessibleInterface(QAccessible::uniqueId(QAccessible::queryAccessibleInterface(&widget)));
}

}  // namespace rubble
