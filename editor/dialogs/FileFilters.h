#pragma once

#include <QString>

namespace rubble {

inline constexpr const char* kProjectSuffix = ".rubble";

/// The filter of file dialogs for projects.
QString projectFilter();
/// The filter of file dialogs for meshes that can be imported.
QString meshFilter();
/// The filter of file dialogs for pictures of skies.
QString skyFilter();
/// Whether a file's suffix is that of a mesh that can be imported.
bool isMeshPath(const QString& path);

}  // namespace rubble
