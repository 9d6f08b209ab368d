#pragma once

#include <QString>
#include <QStringList>

namespace rubble {

/// Returns the folder that contains `projects` and `docs`: share/rubble of an installed program, otherwise the source
/// tree.
QString installedDataFolder();
/// Returns the paths of the example projects.
QStringList exampleProjects();
/// Returns the title of an example: "Wall with openings" for "wall-with-openings.rubble".
QString exampleTitle(const QString& path);
/// Returns the path of the example that the start page plays; empty if it is not installed.
QString demoProject();

}  // namespace rubble
