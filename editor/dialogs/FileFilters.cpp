#include "editor/dialogs/FileFilters.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>

namespace rubble {

namespace {

const QStringList kMeshSuffixes = {"obj", "gltf", "glb", "fbx", "stl", "ply"};

struct FileFiltersTexts {
    Q_DECLARE_TR_FUNCTIONS(FileFilters)
};

}  // namespace

QString projectFilter() { return FileFiltersTexts::tr("Rubble projects (*%1)").arg(kProjectSuffix); }

QString meshFilter() { return FileFiltersTexts::tr("Meshes (%1)").arg("*." + kMeshSuffixes.join(" *.")); }

QString skyFilter() { return FileFiltersTexts::tr("Skies (*.hdr)"); }

bool isMeshPath(const QString& path) { return kMeshSuffixes.contains(QFileInfo(path).suffix().toLower()); }

}  // namespace rubble
