#include "editor/dialogs/FileFilters.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace rubble {

namespace {

const QStringList kMeshSuffixes = {"obj", "gltf", "glb", "fbx", "stl", "ply"};

QString tr(const char* text) { return QCoreApplication::translate("FileFilters", text); }

}  // namespace

QString projectFilter() { return tr("Rubble projects (*%1)").arg(kProjectSuffix); }

QString meshFilter() { return tr("Meshes (%1)").arg("*." + kMeshSuffixes.join(" *.")); }

bool isMeshPath(const QString& path) { return kMeshSuffixes.contains(QFileInfo(path).suffix().toLower()); }

}  // namespace rubble
