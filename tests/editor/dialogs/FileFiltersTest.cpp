#include "editor/dialogs/FileFilters.h"

#include "tests/support/TestProgram.h"

using namespace rubble;

class FileFiltersTest : public QObject {
    Q_OBJECT
private slots:
    void filtersNameTheSuffixes() {
        QCOMPARE(projectFilter(), "Rubble projects (*.rubble)");
        QCOMPARE(meshFilter(), "Meshes (*.obj *.gltf *.glb *.fbx *.stl *.ply)");
    }
    void meshesAreKnownByTheirSuffixInAnyCase() {
        QVERIFY(isMeshPath("/models/wall.obj") && isMeshPath("WALL.GLB"));
        QVERIFY(!isMeshPath("wall.rubble") && !isMeshPath("obj") && !isMeshPath(""));
    }
};

RUBBLE_TEST(FileFiltersTest)
#include "FileFiltersTest.moc"
