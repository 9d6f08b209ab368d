#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QString>

namespace rubble::test {

/// From now on the program's settings are files in a folder, not the user's.
inline void keepSettingsIn(const QString& folder) {
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    QCoreApplication::setOrganizationName("RubbleTest");
}

}  // namespace rubble::test
