// Tests app/importer/gltf/*.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/MeshCases.h"

using namespace rubble;

class GltfReaderTest : public QObject {
    Q_OBJECT
private slots:
    void everyMeshIsWhatItsValuesSay_data() { test::addMeshCases({".gltf", ".glb"}); }
    void everyMeshIsWhatItsValuesSay() {
        QFETCH(const QString, file);
        test::compareMeshCase(file.toStdString());
    }
};

RUBBLE_TEST(GltfReaderTest)
#include "GltfReaderTest.moc"
